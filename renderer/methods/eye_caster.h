#pragma once

#include "renderer/film/statistics.h"
#include "renderer/geometry/view.h"
#include "renderer/methods/render_scene.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/subdivision_trace.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <stop_token>
#include <vector>

namespace asos {

/// Looks along eye rays through one square block of the picture, whose frame's (u, v) runs from 0
/// to 1 across it: the engine's Caster for eye pyrays. Leaves are shaded and added up, root by
/// root; a root is a pixel.
class EyeCaster final : public Caster {
 public:
  EyeCaster(const RenderScene& scene, const View& view, const RenderSettings& settings,
            const Frame& frame, PixelRect block, std::size_t roots, const std::stop_token& stop,
            RenderStatistics& counts);

  [[nodiscard]] SampleId probe(std::span<const glm::vec2> points) override;
  [[nodiscard]] Cover cover(SampleId sample) const override;
  [[nodiscard]] std::uint32_t surface(SampleId sample) const override;
  [[nodiscard]] bool uneven(SampleId sample, double share) const override;
  [[nodiscard]] bool cancelled() const override { return stop_.stop_requested(); }
  void leaf(std::uint32_t root, SampleId sample, double weight) override;

  /// Whether a sample met the background or a surface without holes and nothing shining through.
  [[nodiscard]] bool opaque(SampleId sample) const;

  /// The world's triangle that a sample met; Hit::none: the background.
  [[nodiscard]] std::uint32_t triangle(SampleId sample) const { return hits_[sample].triangle; }
  /// What a sample sees as a leaf of this weight, linear; its rays are not counted.
  [[nodiscard]] glm::vec3 radiance(SampleId sample, double weight) const;

  /// Keeps the leaves of one root from now on.
  void log_leaves(std::uint32_t root) { logged_root_ = root; }
  [[nodiscard]] const std::vector<TracedLeaf>& logged_leaves() const { return logged_leaves_; }

  /// A root's colour: the mean of its leaves. Samples that were not finite were left out and
  /// counted.
  [[nodiscard]] glm::vec3 colour(std::uint32_t root) const;

 private:
  struct Sum {
    glm::dvec3 radiance{0.0};
    double weight = 0.0;
  };

  const RenderScene& scene_;
  const View& view_;
  const Frame& frame_;
  PixelRect block_;
  std::stop_token stop_;
  RenderStatistics& counts_;
  Shader shader_;
  PixelSpacing spacing_;
  float most_uneven_;
  std::vector<glm::vec2> points_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
  std::vector<Sum> sums_;
  std::uint32_t logged_root_ = no_sample;
  std::vector<TracedLeaf> logged_leaves_;
};

}  // namespace asos
