#include "renderer/asos/lobe_shares.h"

#include "renderer/asos/sample_goal.h"
#include "renderer/geometry/largest.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace asos {

RegionSampler& LobeShares::sampler() {
  if (!sampler_) {
    sampler_.emplace(*eye_->scene, eye_->viewer, *eye_->settings, eye_->block, eye_->seed,
                     eye_->mask, eye_->stop, SampleSums::Shows::lobes);
  }
  return *sampler_;
}

// As many as of noise, but at first no more than what the lobes return of white is worth. MAX 0
// asks for one sample.
RegionSampler::Goal LobeShares::goal_of(double weight, glm::vec3 reflected) const {
  RegionSampler::Goal goal = sample_goal(*eye_, weight, enough_samples, Sampled::noisy);
  if (eye_->budget.max_level == 0) {
    goal.least = goal.most = 1;
    return goal;
  }
  const double share = std::min(1.0, static_cast<double>(largest(reflected)));
  const auto worth = static_cast<std::uint32_t>(share * goal.least);
  goal.least = std::clamp(std::bit_ceil(worth), std::min(enough_samples, goal.least), goal.least);
  return goal;
}

std::uint32_t LobeShares::add(const PyrayLeaf& leaf, glm::vec3 reflected) {
  sampler().add(leaf.region, goal_of(leaf.weight, reflected));
  shares_.push_back({leaf.root, leaf.sample, leaf.weight});
  return static_cast<std::uint32_t>(shares_.size() - 1);
}

glm::vec3 LobeShares::at_once(const PyrayLeaf& leaf, glm::vec3 reflected) {
  const RegionSampler::Goal goal = goal_of(leaf.weight, reflected);
  return glm::vec3(sampler().sample(leaf.region, goal, *eye_->counts).mean);
}

std::span<const LeafShare> LobeShares::run() {
  done_.clear();
  if (shares_.empty()) return done_;
  const std::uint64_t before = eye_->counts->rays();
  const auto found = sampler_->run(*eye_->counts);
  const auto rays = static_cast<double>(eye_->counts->rays() - before);
  double samples = 0.0;
  for (std::size_t i = 0; i < shares_.size(); ++i) samples += found[i].samples;
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    LeafShare& share = shares_[i];
    share.radiance = share.weight * found[i].mean;
    if (samples > 0.0)
      share.rays = static_cast<std::uint64_t>(std::llround(rays * found[i].samples / samples));
  }
  done_.swap(shares_);
  return done_;
}

}  // namespace asos
