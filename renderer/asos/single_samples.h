#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/pyray/caster.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/samples/sobol_sampler.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace asos {

/// Leaves that get one sample: cells still marginal at MAX, and leaves without a second sample at
/// this MAX. Their rays were cast when the cell was examined. They are shaded in batches, with
/// one shadow ray to each light.
class SingleSamples {
 public:
  /// Both references have to outlive it.
  SingleSamples(const EyeContext& eye, const EyeSamples& samples);
  SingleSamples(const SingleSamples&) = delete;
  SingleSamples& operator=(const SingleSamples&) = delete;

  /// Defers a leaf until `run`.
  void add(const PyrayLeaf& leaf) { queue_.add(leaves_.emplace_back(leaf)); }
  /// Shades the deferred leaves and empties the queue. Results that are not finite are dropped.
  /// Valid until the next `run`.
  [[nodiscard]] std::span<const Contribution> run();
  /// Returns the parts of the radiance of contribution `number`, if layers ask for them.
  [[nodiscard]] const LightSum& light(std::size_t number) const { return light_[number]; }

 private:
  const EyeContext* eye_;
  const EyeSamples* samples_;
  SobolSampler places_;
  std::unique_ptr<SampleSums> sums_;  // large, so made when first needed
  std::vector<LightSum> light_;       // of each leaf
  LayerTargets targets_;              // these
  std::list<PyrayLeaf> leaves_;
  BlockQueue queue_;
  std::map<std::uint32_t, int> taken_;  // leaves of each root so far
};

}  // namespace asos
