#pragma once

#include "renderer/prepared/viewer.h"
#include "renderer/samples/bounced_light.h"
#include "renderer/samples/layer_probe.h"
#include "renderer/samples/plain_samples.h"
#include "renderer/samples/sample_block.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/samples/sampled_reflections.h"
#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace asos {

/// Point samples, traced and shaded a batch at a time through packets of rays and added up by what
/// they belong to. Samples that are not finite are left out of their sums and counted. The bits of
/// a sum may depend on which samples were added before, never on anything else.
class SampleSums {
 public:
  struct Sum {
    glm::dvec3 radiance{0.0};  ///< linear, of all samples together
    std::uint32_t count = 0;

    [[nodiscard]] glm::dvec3 mean() const {
      return count > 0 ? radiance / static_cast<double>(count) : glm::dvec3(0.0);
    }
  };

  /// `scene`, `view` and `places` have to outlive this.
  SampleSums(const RenderScene& scene, const View& view, const RenderSettings& settings,
             SamplePlaces& places);
  /// What samples are summed up of: all of their radiance, what the lobes of the first surfaces
  /// mirror and no other part of it, or only layers: those samples cast their eye rays alone.
  enum class Shows { all, lobes, layers };
  /// For who looks at the scene in its own way; `viewer` has to outlive this.
  SampleSums(const RenderScene& scene, const Viewer& viewer, const RenderSettings& settings,
             SamplePlaces& places, Shows shows = Shows::all);
  SampleSums(const SampleSums&) = delete;
  SampleSums& operator=(const SampleSums&) = delete;

  /// From now on colours are averaged over squares that are so many times as wide as samples'
  /// sides.
  void widen_colours(float times) {
    colours_ = times;
    plain_.widen_colours(times);
  }

  /// From now on samples are added to layer sums as well: those of target i to `sums[i / targets]`,
  /// where that is not null. Empty: to none. The probe and the sums have to outlive the samples.
  void note_layers(const LayerProbe* probe, std::vector<LayerSum*> sums, std::size_t targets) {
    probe_ = probe;
    layers_ = std::move(sums);
    targets_a_layer_ = targets;
  }

  /// Makes room for sums 0 to `count` - 1; new ones are empty. Those beyond are forgotten, and none
  /// of their samples may wait for `trace`.
  void resize(std::size_t count);
  [[nodiscard]] std::size_t size() const { return radiance_.size(); }

  /// True once a batch was full and was traced, which moved the places to other samples.
  bool add(const PointSample& sample) {
    // Member by member: a copy as a whole would wait for what was just written in parts.
    PointSample& place = samples_[used_];
    points_[used_].x = place.at.x = sample.at.x;
    points_[used_].y = place.at.y = sample.at.y;
    place.side = sample.side;
    place.x = sample.x;
    place.y = sample.y;
    place.index = sample.index;
    place.target = sample.target;
    if (++used_ < batch) return false;
    trace();
    return true;
  }
  /// The same for a sample whose ray was cast already: only its shading is left. Samples of both
  /// kinds do not wait together.
  bool add_hit(const PointSample& sample, const Ray& ray, const Hit& hit) {
    samples_[used_] = sample;
    rays_[used_] = ray;
    hits_[used_] = hit;
    hits_known_ = true;
    if (++used_ < batch) return false;
    trace();
    return true;
  }
  /// Traces the waiting samples. Sums are up to date only after it.
  void trace();

  [[nodiscard]] Sum sum(std::size_t target) const { return {radiance_[target], count_[target]}; }
  /// Goes on from a sum that was known before.
  void continue_from(std::size_t target, const Sum& sum) {
    radiance_[target] = sum.radiance;
    count_[target] = sum.count;
  }
  /// Adds up `count` sums from `first` on, an even number, two at a time: the first half of them
  /// hold all, and the others are empty. None of their samples may wait for `trace`.
  void add_pairs(std::size_t first, std::size_t count);
  /// The first hit of the ray of a sum's latest sample.
  [[nodiscard]] const Hit& hit(std::size_t target) const { return hit_[target]; }
  [[nodiscard]] RenderStatistics& statistics() { return statistics_; }

  /// The block whose pixels' means are those of the first sums, row by row, and all that was
  /// counted.
  [[nodiscard]] BlockResult block(PixelRect rect) const;

 private:
  static constexpr std::size_t batch = 256;

  [[nodiscard]] ViewedRay seen_by(std::size_t i, float side) const {
    ViewedRay seen = viewer_.viewed(rays_[i], hits_[i], side);
    seen.colours = colours_;
    return seen;
  }
  void cast_rays();
  void aim_through_lens();
  void widen_footprints();
  void gather_lobes();
  void add_layers();
  void shade_batch();
  [[nodiscard]] bool shade_plain();
  [[nodiscard]] bool shade(const PointSample& sample, glm::vec3 weight, const ViewedRay& seen);
  void follow_reflections();

  std::optional<Shader> own_shader_;
  Viewer viewer_;
  const RenderScene* scene_;
  SamplePlaces* places_;
  SampledLights lights_;
  SampledReflections reflections_;
  BouncedLight bounced_;
  PlainSamples plain_;
  Culling faces_;
  Shows shows_ = Shows::all;
  const LayerProbe* probe_ = nullptr;
  std::vector<LayerSum*> layers_;
  std::size_t targets_a_layer_ = 1;
  float colours_ = 1.0f;
  std::vector<glm::dvec3> radiance_;
  std::vector<std::uint32_t> count_;
  std::vector<Hit> hit_;
  RenderStatistics statistics_;
  std::array<PointSample, batch> samples_{};
  std::array<glm::dvec2, batch> points_{};
  std::array<Ray, batch> rays_;
  std::array<Hit, batch> hits_;
  std::array<std::size_t, batch> alone_;  // the samples that are shaded one by one
  std::size_t used_ = 0;
  bool hits_known_ = false;  // of the samples that wait
};

}  // namespace asos
