#include "renderer/shadows/area_shadow.h"

#include "renderer/geometry/largest.h"
#include "renderer/pyray/tuning.h"
#include "renderer/shading/reflected_light.h"
#include "renderer/shadows/sampled_shadow.h"
#include "renderer/shadows/shadow.h"
#include "renderer/shadows/shadow_context.h"

#include <algorithm>
#include <limits>

namespace asos {
namespace {

// Returns the error of a highlight that is scaled by the light's visibility, if the lobe is so
// broad that it matters which part of the light is visible. The highlight of such a lobe, as of
// rough metal, extends over the whole light.
double lobe_error(const ShadowContext& block, const Illumination& lit, const Visibility& seen) {
  if (!block.rules.error_budget.refines_leaves() || !is_broad(lit)) return 0.0;
  const auto share = static_cast<float>(largest(seen * (1.0 - seen)));
  return static_cast<double>(share * std::min(lit.highlight, spread_over(lit)));
}

// Returns the visibility from one point by a pyray through the light's square, between the surface
// and the light. The error is infinite where that does not resolve the occluders.
Estimate pyramid_shadow(const ShadowContext& block, const ShadowQuery& query,
                        const Receiver& receiver, RenderStatistics& counts) {
  const auto seen = [&](const Visibility& visibility) -> Estimate {
    return {visibility, lobe_error(block, query.lit, visibility)};
  };
  const auto pyramid = LightPyramid::of(query.lit.light, receiver);
  if (!pyramid) return seen(ray_visibility(block, query, counts).value);

  // Make the pyray: through the light's square, between the surface and the light.
  SubdivisionRules rules = shadow_rules(block.rules, query);
  rules.most_entries = ShadowTuning::most_groups;
  const bool refined = !block.rules.area_shadows;
  if (refined || !block.rules.see_through)
    rules.error_budget.max_level =
        std::min(rules.error_budget.max_level, ShadowTuning::pyramid_levels);
  Pyray pyray{pyramid->frame()};
  pyray.bounds = query.found;
  pyray.bounds.within = pyramid->between();
  pyray.bounds.most_entries = most_entries_for_samples(levels_left(block.rules, query.leaf));
  pyray.outline = pyramid->boundaries();
  pyray.seed = query.leaf.seed;

  // Visibility that varies between outlines is sampled. The paper's qualities split the light
  // instead.
  LightPyramidCaster& caster = block.work->pyramid_caster;
  caster.start(*block.scene, block.rules.see_through, query.lit.light, *pyramid, refined);
  const Trace trace = trace_shadow(block, query, pyray, rules, caster, counts);
  const bool too_detailed = trace.timed_out || caster.gives_up() ||
                            trace.outcome.unresolved_area > rules.error_budget.eps;
  return too_detailed ? Estimate{} : seen(caster.visibility().value_or(Visibility(0.0)));
}

// Returns the visibility from one point, or of the patch by rays where the former's error exceeds
// the allowance.
Estimate resolved_shadow(const ShadowContext& block, const ShadowQuery& query,
                         const Receiver& receiver, double allowed, RenderStatistics& counts) {
  const Estimate seen = pyramid_shadow(block, query, receiver, counts);
  return seen.within(allowed) ? seen : sampled_shadow(block, query, counts);
}

// Uses rays where they cost less, or represent the patch better, than a pyray from its centre.
Estimate refined_shadow(const ShadowContext& block, const ShadowQuery& query,
                        const Receiver& middle, RenderStatistics& counts) {
  const ErrorBudget& error_budget = block.rules.error_budget;
  const auto tolerance = static_cast<double>(error_budget.tolerance);
  const bool detailed = std::ranges::binary_search(query.leaf.behind_detail, query.lit.index);
  const auto bound = ErrorBound::unknown(query.lit.light.entered || detailed);
  return query.takes_rays(error_budget, LeafCosts::light_view, bound)
             ? sampled_shadow(block, query, counts)
             : resolved_shadow(block, query, middle, tolerance, counts);
}

}  // namespace

Estimate area_shadow(const ShadowContext& block, const ShadowQuery& query,
                     RenderStatistics& counts) {
  const Receiver middle = receiver_above(query.lit.point, query.lit.light);
  const AreaShadows* published = block.rules.area_shadows;
  if (query.lit.layer > 0) {
    // There is no data on how evenly a surface behind another one is lit.
    return !published && has_patch(block, query.lit)
               ? sampled_shadow(block, query, counts)
               : Estimate::exact(point_area_shadow(block, query, middle, counts));
  }
  return published ? Estimate::exact(published->of_patch(block, query, counts))
                   : refined_shadow(block, query, middle, counts);
}

Visibility point_area_shadow(const ShadowContext& block, const ShadowQuery& query,
                             const Receiver& receiver, RenderStatistics& counts) {
  return resolved_shadow(block, query, receiver, std::numeric_limits<double>::infinity(), counts)
      .value;
}

}  // namespace asos
