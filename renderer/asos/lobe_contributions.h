#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
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

/// Computes the contribution of rough reflection lobes to the leaves of a block, by samples of the
/// leaf with one direction each, and that of the sky if it may be occluded, by a few rays of each
/// sample. A lobe covers the whole half-space, where boundaries rarely matter. Lights with an
/// extent are highlights and not part of it. The rays of all leaves share packets, and leaves of
/// one surface share samples (fit_surfaces).
class LobeContributions {
 public:
  /// `eye` has to outlive this.
  explicit LobeContributions(const EyeContext& eye) : eye_(&eye) {}

  /// Defers a leaf until `run`. Its own sample represents it if no other sample meets it.
  /// `reflected` is the largest reflectance of its lobes, by colour. If it `shares` samples with
  /// other leaves, it has to vary smoothly, as the sky's occlusion does.
  void add(const Leaf& leaf, glm::vec3 reflected, bool shares);
  /// Returns the lobe contribution of a leaf immediately.
  [[nodiscard]] glm::vec3 at_once(const Leaf& leaf, glm::vec3 reflected);

  /// Samples the deferred leaves and empties the queue. The result is valid until the next leaf.
  std::span<const Contribution> run();
  /// Returns the parts of the radiance of contribution `number`, if layers ask for them.
  [[nodiscard]] LightSum light(std::size_t number) const;

 private:
  [[nodiscard]] RegionSampler& sampler();
  void wait(const Leaf& leaf, glm::vec3 reflected);
  [[nodiscard]] RegionSampler::Goal goal_of(double weight, glm::vec3 reflected) const;

  const EyeContext* eye_;
  std::unique_ptr<RegionSampler> sampler_;  // large, so made when first needed
  BlockQueue queue_;                        // in the sampler's order
  std::vector<SampledLeaf> leaves_;         // in this order, too
};

}  // namespace asos
