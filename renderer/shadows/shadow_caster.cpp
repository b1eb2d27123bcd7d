#include "renderer/shadows/shadow_caster.h"

#include <algorithm>

namespace asos {

void ShadowCaster::start(const ShadowScene& scene, bool see_through, const Frame& frame,
                         std::int32_t ignored_part) {
  scene_ = &scene;
  see_through_ = see_through;
  frame_ = &frame;
  ignored_part_ = ignored_part;
  samples_.clear();
  cast_ = 0;
  seen_ = Visibility(0.0);
  all_ = 0.0;
}

SampleId ShadowCaster::probe(std::span<const glm::vec2> points) {
  const std::size_t first = samples_.size();
  rays_.clear();
  asked_.clear();
  for (const glm::vec2& p : points) {
    Sample& sample = samples_.emplace_back();
    if (const auto ray = ray_at(p)) {
      sample.ray = *ray;
      sample.counts = true;
      asked_.push_back(static_cast<std::uint32_t>(samples_.size() - 1));
      rays_.push_back(*ray);
    }
  }
  blockers_.resize(rays_.size());
  scene_->rays.blockers(rays_, blockers_, ignored_part_, scene_->features.outlined());
  for (std::size_t i = 0; i < asked_.size(); ++i) samples_[asked_[i]].blocker = blockers_[i];
  cast_ += rays_.size();
  return static_cast<SampleId>(first);
}

OccluderPlane ShadowCaster::cover(SampleId sample) const {
  const Hit& hit = samples_[sample].blocker.hit;
  if (!hit.valid()) return OccluderPlane::none();
  return occluder_of(*frame_, scene_->world, scene_->features, hit);
}

std::uint32_t ShadowCaster::surface(SampleId sample) const {
  constexpr std::uint32_t lit = FeatureEdge::none, beside = FeatureEdge::none - 2;
  const Sample& s = samples_[sample];
  if (!s.counts) return beside;
  return s.blocker.hit.valid() ? scene_->features.smooth_surface(s.blocker.hit.triangle) : lit;
}

LeafDecision ShadowCaster::decide(const PyrayLeaf& leaf, bool may_split) {
  const bool varies = may_split && see_through_ && samples_[leaf.sample].blocker.see_through;
  return varies ? LeafDecision{Estimator::split, LeafVariation::shadow} : LeafDecision{};
}

void ShadowCaster::take(std::span<const PyrayLeaf> leaves) {
  for (const PyrayLeaf& leaf : leaves) {
    const Sample& s = samples_[leaf.sample];
    if (!s.counts) continue;
    const double worth = measure(leaf.weight, leaf.region);
    all_ += worth;
    seen_ += worth * Visibility(s.blocker.transmittance);
  }
}

bool ShadowCaster::met_see_through() const {
  return see_through_ && std::any_of(samples_.begin(), samples_.end(),
                                     [](const Sample& s) { return s.blocker.see_through; });
}

std::optional<Visibility> ShadowCaster::visibility() const {
  if (!(all_ > 0.0)) return std::nullopt;
  return seen_ / all_;
}

}  // namespace asos
