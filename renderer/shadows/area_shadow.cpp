#include "renderer/shadows/area_shadow.h"

#include "renderer/pyray/leaf_costs.h"
#include "renderer/shading/reflected_light.h"
#include "renderer/shadows/sampled_shadow.h"
#include "renderer/shadows/shadow.h"
#include "renderer/shadows/shadow_context.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Returns whether a lobe is so broad that it matters visibly which part of the light is visible,
// and not only its fraction `seen`. The highlight of a broad lobe, such as that of rough metal,
// extends over the whole light.
bool lobe_tells_apart(const ShadowContext& block, const Illumination& lit, const Visibility& seen) {
  const ErrorBudget& error_budget = block.rules.error_budget;
  if (!error_budget.refines_leaves() || !is_broad(lit)) return false;
  const Visibility both = seen * (1.0 - seen);
  const auto share = static_cast<float>(std::max({both.x, both.y, both.z}));
  const float tolerance = error_budget.tolerance;
  return share * lit.highlight > tolerance && share * spread_over(lit) > tolerance;
}

// If neither a light nor its quarters can be cut along their boundaries, the light is sampled. More
// levels of pyrays cost more than rays from all over the patch.
constexpr int window_levels = 1;
// A light whose square contains more groups of boundaries is not resolved.
constexpr std::size_t most_entries = 400;

// Uses rays where they cost less, or represent the patch better, than a pyray from its centre.
Visibility refined_shadow(const ShadowContext& block, const ShadowQuery& query,
                          const Receiver& middle, RenderStatistics& counts) {
  const PreparedLight& light = query.lit.light;
  // Rays from the whole leaf are better than a pyray from its centre if it was not split for its
  // penumbra.
  const LightView view = query.leaf.views.of(query.lit.index);
  const bool by_rays = block.rules.error_budget.samples_suffice(
                           query.leaf.weight, query.intensity(), LeafCosts::light_pyramid) ||
                       light.entered || view.too_detailed ||
                       view.penumbra > static_cast<double>(block.rules.error_budget.tolerance);
  if (by_rays) return sampled_shadow(block, query, counts);
  const Visibility seen = point_area_shadow(block, query, middle, counts);
  return lobe_tells_apart(block, query.lit, seen) ? sampled_shadow(block, query, counts) : seen;
}

}  // namespace

Visibility area_shadow(const ShadowContext& block, const ShadowQuery& query,
                       RenderStatistics& counts) {
  const Receiver middle = receiver_above(query.lit.point, query.lit.light);
  const AreaShadows* published = block.rules.area_shadows;
  if (query.lit.layer > 0) {
    // There is no data on how evenly a surface behind another one is lit.
    return !published && has_patch(block, query.lit)
               ? sampled_shadow(block, query, counts)
               : point_area_shadow(block, query, middle, counts);
  }
  return published ? published->of_patch(block, query, counts)
                   : refined_shadow(block, query, middle, counts);
}

Visibility point_area_shadow(const ShadowContext& block, const ShadowQuery& query,
                             const Receiver& receiver, RenderStatistics& counts) {
  const auto window = LightPyramid::of(query.lit.light, receiver);
  if (!window) return ray_visibility(block, query, counts);

  // Make the pyray: through the light's square, between the surface and the light.
  SubdivisionRules rules = shadow_rules(block.rules, query);
  rules.most_entries = most_entries;
  const bool refined = !block.rules.area_shadows;
  if (refined || !block.rules.see_through)
    rules.error_budget.max_level = std::min(rules.error_budget.max_level, window_levels);
  Pyray pyray{window->frame()};
  pyray.bounds = query.found;
  pyray.bounds.within = window->between();
  pyray.bounds.most_entries = most_entries_for_samples(levels_left(block.rules, query.leaf));
  pyray.outline = window->boundaries();
  pyray.seed = query.leaf.seed;

  // Visibility that varies between outlines is sampled. The paper's qualities split the light
  // instead.
  LightPyramidCaster& caster = block.work->window_caster;
  caster.start(*block.scene, block.rules.see_through, query.lit.light, *window, refined);
  const Trace trace = trace_shadow(block, query, pyray, rules, caster, counts);
  const bool too_detailed = trace.timed_out || caster.gives_up() ||
                            trace.outcome.unresolved_area > rules.error_budget.eps;
  return too_detailed ? sampled_shadow(block, query, counts)
                      : caster.visibility().value_or(Visibility(0.0));
}

}  // namespace asos
