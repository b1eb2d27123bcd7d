#include "renderer/asos/leaf_chooser.h"

#include "renderer/pyray/leaf_costs.h"

#include <algorithm>
#include <utility>

namespace asos {

bool samples_cost_least(const ErrorBudget& error_budget, double weight) {
  return error_budget.samples_suffice(weight, ErrorBudget::usual_contrast, LeafCosts::exact_leaf);
}

Estimator choose(const ErrorBudget& error_budget, const LeafChoice& leaf) {
  const ErrorBound& bound = leaf.bound;
  if (bound.unbounded) return Estimator::samples;
  if (bound.error <= static_cast<double>(error_budget.tolerance)) return Estimator::centre;
  const double contrast = ErrorBudget::usual_contrast + bound.contrast;
  const double samples = error_budget.samples(leaf.weight, contrast);
  if (leaf.may_split) {
    const double leaves = error_budget.leaves(bound.error);
    return samples <= leaves * leaf.price ? Estimator::samples : Estimator::split;
  }
  return ErrorBudget::error_of_samples(samples, contrast) < bound.error ? Estimator::samples
                                                                        : Estimator::centre;
}

LeafChooser::LeafChooser(const EyeContext& eye, const EyeSamples& samples,
                         const SelectedLights& selected_lights, const ShadowContext& shadows)
    : eye_(&eye),
      samples_(&samples),
      terms_(eye, samples, selected_lights, shadows),
      shadows_price_(terms_.cost_of_shadows()),
      part_price_(LeafCosts::part + shadows_price_) {}

LeafDecision LeafChooser::decide(SampleId sample, double weight, const LeafRegion& region,
                                 bool may_split) {
  const ErrorBudget& error_budget = eye_->error_budget;
  if (!error_budget.refines_leaves() || (eye_->mask && !eye_->mask->holds(samples_->at(sample))))
    return {};
  // The background, too, may lie behind a hole.
  if (samples_->cut_out(sample)) return {Estimator::samples, LeafVariation::layers};
  if (!samples_->hit(sample).valid()) return {};
  // The parts of an evenly lit patch are right only as a whole, so none of them is sampled alone.
  const bool shared = terms_.soft_shadows() && even_around(sample, region);
  if (!eye_->mirrored() && !shared && samples_cost_least(error_budget, weight) && is_lit(sample))
    return {Estimator::samples};

  // Add up the error terms. Soft shadows matter only where the others leave a choice.
  const Leaf leaf = Leaf::of(*eye_, *samples_, sample, weight, region);
  if (terms_.layers(leaf).unbounded) return {Estimator::samples, LeafVariation::layers};
  LeafChoice choice{weight, terms_.shading(leaf), LeafCosts::leaf, may_split};
  LeafDecision decision{choose(error_budget, choice)};
  decision.error = static_cast<float>(choice.bound.error);
  if (decision.estimator != Estimator::centre) decision.cause = LeafVariation::shading;
  if (!terms_.soft_shadows()) return decision;
  if (shared) {
    if (decision.sampled() && !choice.bound.unbounded)
      decision.estimator = may_split ? Estimator::split : Estimator::centre;
    return decision;
  }
  if (decision.sampled()) return decision;
  LightViews views;
  const ErrorBound penumbra = terms_.penumbra(leaf, views);
  const bool even = penumbra.error <= static_cast<double>(error_budget.tolerance);
  if (!even || decision.estimator == Estimator::centre) {
    choice.bound += penumbra;
    choice.price += shadows_price_;
    decision.estimator = choose(error_budget, choice);
    decision.error = static_cast<float>(choice.bound.error);
    if (decision.estimator != Estimator::centre)
      decision.cause = even ? LeafVariation::shading : LeafVariation::shadow;
  }
  // If a leaf is split for its shading only, its parts reuse its shadows.
  if (even && decision.splits() && region.border.empty() && samples_->opaque(sample) &&
      nearly_flat(leaf))
    even_.push_back(even_patch(sample, region, views));
  if (!views.empty() && !decision.splits()) {
    decision.record = static_cast<std::uint32_t>(views_.size());
    views_.push_back(std::move(views));
  }
  return decision;
}

bool LeafChooser::is_lit(SampleId sample) const {
  return !eye_->scene->world().material_of(samples_->hit(sample).triangle).unlit;
}

// Returns whether the surface deviates little from its plane, compared with the patch. The search
// for penumbrae ignores occluders closer to a curved surface than its deviation (find_penumbra).
bool LeafChooser::nearly_flat(const Leaf& leaf) const {
  const float size = std::min(glm::length(leaf.square.right), glm::length(leaf.square.down));
  const glm::dvec3 at(leaf.ray.at(leaf.hit.t));
  return 4.0 * eye_->scene->features().deviation(leaf.hit.triangle, at, size) <
         static_cast<double>(size);
}

UniformShadowPatch LeafChooser::even_patch(SampleId sample, const LeafRegion& region,
                                           const LightViews& views) const {
  return {samples_->point(sample), region.square,
          std::vector<Visibility>(eye_->viewer.shader.lights().size(), Visibility(-1.0)), views};
}

// The region has to be a part of the patch. Pixels with a wide filter only overlap it.
UniformShadowPatch* LeafChooser::even_around(SampleId sample, const LeafRegion& region) {
  const Square& s = region.square;
  const float rounding = 1e-3f * s.side;
  for (UniformShadowPatch& even : even_) {
    const Square& all = even.square;
    const float wider = all.side - s.side + rounding;
    if (s.u >= all.u - rounding && s.u <= all.u + wider && s.v >= all.v - rounding &&
        s.v <= all.v + wider &&
        samples_->surface(sample) == eye_->scene->features().smooth_surface(even.middle.triangle))
      return &even;
  }
  return nullptr;
}

bool LeafChooser::may_misplace_light(SampleId sample, double weight,
                                     const LeafRegion& region) const {
  return terms_.may_misplace_light(Leaf::of(*eye_, *samples_, sample, weight, region));
}

}  // namespace asos
