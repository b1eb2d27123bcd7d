#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/asos/surface_fits.h"
#include "renderer/samples/region_sampler.h"
#include "renderer/shadows/leaf.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asos {

/// Computes a contribution to the leaves of a block by samples of each leaf. The rays of all leaves
/// share packets. Direct light is that of the selected lights: many lights, each too dim to be
/// evaluated alone. Lobes are rough reflection, with one direction for each sample, and the sky if
/// it may be occluded, by a few rays of each sample. A lobe covers the whole half-space, where
/// boundaries rarely matter. Lights with an extent are highlights and not part of it. Leaves of one
/// surface share samples of the sky (fit_surfaces).
class SampledContributions {
 public:
  /// `shows`: direct light or lobes. `eye` and `lights` have to outlive this.
  SampledContributions(const EyeContext& eye, SummedRadiance shows, const SelectedLights& lights)
      : eye_(&eye), shows_(shows), lights_(&lights) {}

  /// Defers a leaf until `run`. Its own sample represents it if no other sample meets it.
  /// `reflected` is the largest reflectance of its lobes, by colour: the first round has fewer
  /// samples for a lower one. If the leaf `shares` samples with other leaves, the contribution has
  /// to vary smoothly, as the sky's occlusion does.
  void add(const Leaf& leaf, glm::vec3 reflected = glm::vec3(0.0f), bool shares = false);
  /// Returns the contribution to a leaf immediately.
  [[nodiscard]] glm::vec3 at_once(const Leaf& leaf, glm::vec3 reflected = glm::vec3(0.0f));

  /// Samples the deferred leaves and empties the queue. The result is valid until the next leaf.
  std::span<const Contribution> run();
  /// Returns the parts of the radiance of contribution `number`, if layers ask for them.
  [[nodiscard]] LightSum light(std::size_t number) const;

 private:
  [[nodiscard]] RegionSampler& sampler();
  void wait(const Leaf& leaf, glm::vec3 reflected);
  [[nodiscard]] RegionSampler::Goal goal_of(double weight, glm::vec3 reflected) const;

  const EyeContext* eye_;
  SummedRadiance shows_;
  const SelectedLights* lights_;
  std::unique_ptr<RegionSampler> sampler_;  // large, so made when first needed
  BlockQueue queue_;                        // in the sampler's order
  std::vector<SampledLeaf> leaves_;         // in this order, too
};

}  // namespace asos
