#include "renderer/asos/leaf_chooser.h"

#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <utility>

namespace asos {

LeafChooser::LeafChooser(const EyeContext& eye, const EyeSamples& samples,
                         const SelectedLights& selected_lights, const ShadowContext& shadows)
    : eye_(&eye),
      samples_(&samples),
      terms_(eye, samples, selected_lights, shadows),
      shadows_price_(terms_.cost_of_shadows()),
      part_price_(LeafCosts::part + shadows_price_) {}

LeafDecision LeafChooser::decide(const PyrayLeaf& part, bool may_split) {
  const ErrorBudget& error_budget = eye_->error_budget;
  const SampleId sample = part.sample;
  if (!error_budget.refines_leaves() || (eye_->mask && !eye_->mask->holds(samples_->at(sample))))
    return {};
  // The background, too, may lie behind a hole.
  if (samples_->cut_out(sample)) return {Estimator::samples, LeafVariation::layers};
  if (!samples_->hit(sample).valid()) return {};
  // The parts of an evenly lit patch are right only as a whole, so none of them is sampled alone.
  const bool shared = terms_.soft_shadows() && even_around(part);
  // MAX or EPS may allow so few samples that they cost no more than one exact leaf.
  if (!eye_->mirrored() && !shared && is_lit(sample) &&
      choose(error_budget, part.weight, ErrorBound::none(), {LeafCosts::exact_leaf}) ==
          Estimator::samples)
    return {Estimator::samples};
  Leaf& leaf = add(part);
  LeafDecision decision = decide(leaf, shared, may_split);
  if (decision.splits()) {
    --count_;
  } else {
    decision.record = count_;
  }
  return decision;
}

// Adds up the error terms. Soft shadows matter only where the others leave a choice.
LeafDecision LeafChooser::decide(Leaf& leaf, bool shared, bool may_split) {
  const ErrorBudget& error_budget = eye_->error_budget;
  if (terms_.layers(leaf).unbounded) return {Estimator::samples, LeafVariation::layers};
  ErrorBound bound = terms_.shading(leaf);
  const auto chosen = [&](double leaf_cost) {
    return choose(error_budget, leaf.weight, bound,
                  {0.0, may_split ? std::optional(leaf_cost) : std::nullopt});
  };
  LeafDecision decision{chosen(LeafCosts::leaf)};
  decision.error = static_cast<float>(bound.error);
  if (decision.estimator != Estimator::centre) decision.cause = LeafVariation::shading;
  if (!terms_.soft_shadows()) return decision;
  if (shared) {
    if (decision.sampled() && !bound.unbounded)
      decision.estimator = may_split ? Estimator::split : Estimator::centre;
    return decision;
  }
  if (decision.sampled()) return decision;
  const ErrorBound penumbra = terms_.penumbra(leaf);
  const bool even = penumbra.error <= static_cast<double>(error_budget.tolerance);
  if (!even || decision.estimator == Estimator::centre) {
    bound += penumbra;
    decision.estimator = chosen(LeafCosts::leaf + shadows_price_);
    decision.error = static_cast<float>(bound.error);
    if (decision.estimator != Estimator::centre)
      decision.cause = even ? LeafVariation::shading : LeafVariation::shadow;
  }
  // If a leaf is split for its shading only, its parts reuse its shadows.
  if (even && decision.splits() && leaf.region.border.empty() && samples_->opaque(leaf.sample))
    even_.push_back(even_patch(leaf));
  return decision;
}

Leaf& LeafChooser::add(const PyrayLeaf& part) {
  if (count_ == leaves_->size()) leaves_->push_back(std::make_unique<Leaf>());
  Leaf& leaf = *(*leaves_)[count_++];
  samples_->show(part, leaf);
  return leaf;
}

Leaf& LeafChooser::leaf(const PyrayLeaf& part) {
  if (part.decision.record == 0) return add(part);
  Leaf& leaf = *(*leaves_)[part.decision.record - 1];
  leaf.decision = part.decision;
  return leaf;
}

bool LeafChooser::is_lit(SampleId sample) const {
  return !eye_->scene->world().material_of(samples_->hit(sample).triangle).unlit;
}

UniformShadowPatch LeafChooser::even_patch(const Leaf& whole) const {
  return {whole, std::vector<Visibility>(eye_->viewer.shader.lights().size(), Visibility(-1.0))};
}

// The region has to be a part of the patch. Pixels with a wide filter only overlap it.
UniformShadowPatch* LeafChooser::even_around(const PyrayLeaf& part) {
  const Square& s = part.region.square;
  const float rounding = 1e-3f * s.side;
  for (UniformShadowPatch& even : even_) {
    const Square& all = even.whole.region.square;
    const float wider = all.side - s.side + rounding;
    if (s.u >= all.u - rounding && s.u <= all.u + wider && s.v >= all.v - rounding &&
        s.v <= all.v + wider &&
        samples_->surface(part.sample) ==
            eye_->scene->features().smooth_surface(even.whole.point.triangle))
      return &even;
  }
  return nullptr;
}

}  // namespace asos
