#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
#include "renderer/pyray/caster.h"
#include "renderer/samples/region_sampler.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace asos {

/// What the lobes of rough mirrors show to the leaves of a block: by samples of the leaf, each with
/// a direction of its own, of which nothing else is asked. A lobe sees all of the half-space, where
/// boundaries mostly do not matter; lights with a size are its highlights, and no part of it. The
/// rays of all leaves share packets.
class LobeShares {
 public:
  /// `eye` has to outlive this.
  explicit LobeShares(const EyeContext& eye) : eye_(&eye) {}

  /// Defers a leaf until `run`. `reflected`: the largest reflectance of its lobes, by colour.
  void add(const PyrayLeaf& leaf, glm::vec3 reflected);
  /// What the lobes of a leaf show at once; it does not wait.
  [[nodiscard]] glm::vec3 at_once(const PyrayLeaf& leaf, glm::vec3 reflected);

  /// Samples the deferred leaves. Valid until the next leaf; none waits then.
  std::span<const Contribution> run();

 private:
  [[nodiscard]] RegionSampler& sampler();
  [[nodiscard]] RegionSampler::Goal goal_of(double weight, glm::vec3 reflected) const;

  const EyeContext* eye_;
  std::unique_ptr<RegionSampler> sampler_;  // made when first needed: it is large
  BlockQueue queue_;                        // in its order
};

}  // namespace asos
