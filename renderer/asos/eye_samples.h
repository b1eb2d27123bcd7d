#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/pyray/caster.h"
#include "renderer/shading/footprint.h"
#include "renderer/shadows/leaf.h"
#include "renderer/shadows/patch_view.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The rays cast through a block's points, and their hits.
class EyeSamples final : public PatchView {
 public:
  explicit EyeSamples(const EyeContext& eye);

  /// Casts a ray through each point, in packets. Returns the number of the first.
  SampleId probe(std::span<const glm::vec2> points);
  /// Adds a sample that was taken elsewhere, with no hit. Returns its number.
  SampleId add_unseen(glm::vec2 point);

  [[nodiscard]] glm::vec2 at(SampleId sample) const { return points_[sample]; }
  [[nodiscard]] const Ray& ray(SampleId sample) const { return rays_[sample]; }
  [[nodiscard]] const Hit& hit(SampleId sample) const { return hits_[sample]; }
  [[nodiscard]] Ray ray_through(glm::vec2 p) const;
  /// Returns a seed that depends on the sample's place alone.
  [[nodiscard]] std::uint64_t seed(SampleId sample) const;

  [[nodiscard]] OccluderPlane cover(SampleId sample) const;
  /// Returns the number of the surface at a sample. The background has one, too.
  [[nodiscard]] std::uint32_t surface(SampleId sample) const;
  /// Returns whether the ray met the background or an opaque surface, whose holes, if any, have
  /// known outlines.
  [[nodiscard]] bool opaque(SampleId sample) const;
  /// Returns whether the ray met a surface with an alpha cut-out, hole or not, that only samples
  /// can resolve (FeatureSet::cut_outs_unbounded).
  [[nodiscard]] bool cut_out(SampleId sample) const {
    return !cut_out_.empty() && cut_out_[sample];
  }
  [[nodiscard]] SurfacePoint point(SampleId sample) const;
  /// Returns the patch of surface around the hit that a part of the root with the weight `share`
  /// covers.
  [[nodiscard]] Patch patch(SampleId sample, double share) const;

  /// Fills a leaf with a part of a root and the surface at its sample, without views of the
  /// lights.
  void show(const PyrayLeaf& part, Leaf& leaf) const;

  void look(std::span<const glm::vec2> at, std::vector<SurfacePoint>& seen,
            RenderStatistics& counts) override;

 private:
  void cast(std::span<Ray> rays, std::span<Hit> hits) const;
  void find_cut_outs(std::size_t first);

  const EyeContext* eye_;
  Culling faces_;
  std::vector<glm::vec2> points_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
  std::vector<bool> cut_out_;     // empty in scenes without such cut-outs
  std::vector<Blocker> met_;      // scratch
  std::vector<Ray> looked_rays_;  // scratch
  std::vector<Hit> looked_hits_;
};

}  // namespace asos
