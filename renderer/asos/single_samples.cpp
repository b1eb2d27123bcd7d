#include "renderer/asos/single_samples.h"

#include <cmath>
#include <utility>
#include <vector>

namespace asos {

SingleSamples::SingleSamples(const EyeContext& eye, const EyeSamples& samples)
    : eye_(&eye), samples_(&samples), places_(eye.seed) {}

// Each leaf takes the next of its pixel's samples on the lights, so that the samples of a pixel's
// leaves together are well distributed.
std::span<const Contribution> SingleSamples::run() {
  if (queue_.empty()) return {};
  if (!sums_)
    sums_ = std::make_unique<SampleSums>(*eye_->scene, eye_->viewer, *eye_->settings, places_);
  sums_->resize(0);
  sums_->resize(queue_.size());
  if (!eye_->mirrored() && eye_->settings->layers.of_light()) {
    light_.assign(queue_.size(), {});
    targets_.light.clear();
    for (LightSum& light : light_) targets_.light.push_back(&light);
    sums_->note_layers(*eye_->settings, targets_);
  }
  const PixelRect& block = eye_->block;
  for (std::uint32_t i = 0; i < queue_.size() && !eye_->stop.stop_requested(); ++i) {
    const PyrayLeaf& leaf = *queue_[i].leaf;
    const glm::dvec2 at = glm::dvec2(block.x, block.y) +
                          static_cast<double>(block.width) * glm::dvec2(samples_->at(leaf.sample));
    const auto x = static_cast<int>(std::floor(at.x)), y = static_cast<int>(std::floor(at.y));
    sums_->add_hit({at, eye_->side_of(leaf.weight), x, y, taken_[leaf.root]++, i},
                   samples_->ray(leaf.sample), samples_->hit(leaf.sample));
  }
  sums_->trace();
  for (std::uint32_t i = 0; i < queue_.size(); ++i) {
    const SampleSums::Sum sum = sums_->sum(i);
    queue_[i].radiance = queue_[i].leaf->weight * sum.radiance;
    queue_[i].dropped = sum.count == 0;
  }
  const RenderStatistics counts = std::exchange(sums_->statistics(), {});
  queue_.share_rays(static_cast<double>(counts.rays()), std::vector<double>(queue_.size(), 1.0));
  *eye_->counts += counts;
  return queue_.take();
}

}  // namespace asos
