#include "renderer/asos/sampled_contributions.h"

#include "renderer/geometry/largest.h"
#include "renderer/pyray/tuning.h"
#include "renderer/samples/one_sample.h"
#include "renderer/samples/region_sampler.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace asos {

RegionSampler& SampledContributions::sampler() {
  if (!sampler_) {
    sampler_ =
        std::make_unique<RegionSampler>(*eye_->scene, eye_->viewer, *eye_->settings, eye_->block,
                                        eye_->seed, eye_->mask, eye_->stop, shows_);
    if (shows_ == SummedRadiance::direct) sampler_->restrict_to(lights_->lights());
    if (!eye_->mirrored() && eye_->settings->layers.of_light()) sampler_->note_layers();
  }
  return *sampler_;
}

// Returns the usual goal of a part, with the first round reduced by the reflectance of white and by
// the number of rays to the sky, but not below four samples (one at MAX 0).
RegionSampler::Goal SampledContributions::goal_of(double weight, glm::vec3 reflected) const {
  RegionSampler::Goal goal = sample_goal(eye_->error_budget, weight);
  const bool sky = eye_->viewer.shader.settings().sky_shadows;
  const double share = std::min(1.0, static_cast<double>(largest(reflected))) /
                       (sky ? double{OneSample::lobe_sky_rays} : 1.0);
  const auto worth = static_cast<std::uint32_t>(share * goal.least);
  goal.least = std::clamp(std::bit_ceil(worth), std::min(4u, goal.least), goal.least);
  goal.grows = shows_ == SummedRadiance::lobes;
  return goal;
}

void SampledContributions::wait(const Leaf& leaf, glm::vec3 reflected) {
  const std::size_t number = sampler().add(leaf.region, goal_of(leaf.weight, reflected));
  sampler().set_inside(number, leaf.at);
}

void SampledContributions::add(const Leaf& leaf, glm::vec3 reflected, bool shares) {
  if (queue_.empty()) leaves_.clear();
  wait(leaf, reflected);
  queue_.add(leaf);
  leaves_.push_back({&leaf, reflected, shares});
}

glm::vec3 SampledContributions::at_once(const Leaf& leaf, glm::vec3 reflected) {
  wait(leaf, reflected);
  return glm::vec3(sampler().run(*eye_->counts).front().value);
}

std::span<const Contribution> SampledContributions::run() {
  if (queue_.empty()) return {};
  const std::uint64_t before = eye_->counts->rays();
  const bool shared =
      std::any_of(leaves_.begin(), leaves_.end(), [](const auto& leaf) { return leaf.shares; });
  auto found = sampler_->start(*eye_->counts, shared ? FitTuning::first_error : 1.0);
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    leaves_[i].found = found[i];
    leaves_[i].converged = !sampler_->open(i);
  }
  fit_surfaces(eye_->scene->features(), leaves_);
  for (std::size_t i = 0; i < leaves_.size(); ++i)
    if (leaves_[i].fitted) sampler_->end(i);
  found = sampler_->finish(*eye_->counts);
  std::vector<double> samples;
  for (std::uint32_t i = 0; i < queue_.size(); ++i) {
    queue_[i].radiance = queue_[i].leaf->weight * (found[i].value + leaves_[i].correction);
    samples.push_back(found[i].cost);
  }
  queue_.share_rays(static_cast<double>(eye_->counts->rays() - before), samples);
  return queue_.take();
}

// A fit changes all parts by the same factor.
LightSum SampledContributions::light(std::size_t number) const {
  const SampledLeaf& leaf = leaves_[number];
  LightSum light = sampler_->layers(number).light;
  const glm::dvec3 old = leaf.found.value, fitted = old + leaf.correction;
  const auto scaled = glm::notEqual(old, glm::dvec3(0.0));
  for (glm::dvec3& part : light.radiance) part *= glm::mix(glm::dvec3(1.0), fitted / old, scaled);
  light.add(LightPart::direct, light.weight * glm::mix(leaf.correction, glm::dvec3(0.0), scaled));
  return light;
}

}  // namespace asos
