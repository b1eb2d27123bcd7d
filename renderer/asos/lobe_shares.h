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

  /// Puts a leaf off until `run`; the number of its contribution. `reflected`: the most that its
  /// lobes return of what they mirror.
  std::uint32_t add(const PyrayLeaf& leaf, glm::vec3 reflected);
  /// Leaves a contribution out.
  void drop(std::uint32_t number) { queue_.drop(number); }
  /// What the lobes of a leaf show at once; it does not wait.
  [[nodiscard]] glm::vec3 at_once(const PyrayLeaf& leaf, glm::vec3 reflected);

  /// Samples all that was put off. Valid until the next leaf; none waits then.
  std::span<const Contribution> run();

 private:
  [[nodiscard]] RegionSampler& sampler();
  [[nodiscard]] RegionSampler::Goal goal_of(double weight, glm::vec3 reflected) const;

  const EyeContext* eye_;
  std::unique_ptr<RegionSampler> sampler_;  // made when first needed: it is large
  BlockQueue queue_;                        // in its order
};

}  // namespace asos
