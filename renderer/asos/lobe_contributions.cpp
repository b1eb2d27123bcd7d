#include "renderer/asos/lobe_contributions.h"

#include "renderer/geometry/largest.h"
#include "renderer/samples/region_sampler.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace asos {

RegionSampler& LobeContributions::sampler() {
  if (!sampler_) {
    sampler_ = std::make_unique<RegionSampler>(*eye_->scene, eye_->viewer, *eye_->settings,
                                               eye_->block, eye_->seed, eye_->mask, eye_->stop,
                                               SampleSums::SummedRadiance::lobes);
    if (!eye_->mirrored() && eye_->settings->layers.of_light()) sampler_->note_layers();
  }
  return *sampler_;
}

// Returns the usual goal of a part, with the first round reduced by the lobes' reflectance of
// white, but not below four samples (one at MAX 0).
RegionSampler::Goal LobeContributions::goal_of(double weight, glm::vec3 reflected) const {
  RegionSampler::Goal goal = sample_goal(eye_->error_budget, weight);
  const double share = std::min(1.0, static_cast<double>(largest(reflected)));
  const auto worth = static_cast<std::uint32_t>(share * goal.least);
  goal.least = std::clamp(std::bit_ceil(worth), std::min(4u, goal.least), goal.least);
  return goal;
}

void LobeContributions::wait(const Leaf& leaf, glm::vec3 reflected) {
  const std::size_t number = sampler().add(leaf.region, goal_of(leaf.weight, reflected));
  sampler().set_inside(number, leaf.at);
}

void LobeContributions::add(const Leaf& leaf, glm::vec3 reflected) {
  wait(leaf, reflected);
  queue_.add(leaf);
}

glm::vec3 LobeContributions::at_once(const Leaf& leaf, glm::vec3 reflected) {
  wait(leaf, reflected);
  return glm::vec3(sampler().run(*eye_->counts).front().value);
}

std::span<const Contribution> LobeContributions::run() {
  if (queue_.empty()) return {};
  const std::uint64_t before = eye_->counts->rays();
  const auto found = sampler_->run(*eye_->counts);
  std::vector<double> samples;
  for (std::uint32_t i = 0; i < queue_.size(); ++i) {
    queue_[i].radiance = queue_[i].leaf->weight * found[i].value;
    samples.push_back(found[i].cost);
  }
  queue_.share_rays(static_cast<double>(eye_->counts->rays() - before), samples);
  return queue_.take();
}

}  // namespace asos
