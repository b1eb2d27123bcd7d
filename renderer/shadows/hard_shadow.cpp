#include "renderer/shadows/hard_shadow.h"

#include "renderer/pyray/tuning.h"
#include "renderer/shadows/sampled_shadow.h"
#include "renderer/shadows/shadow.h"

#include <algorithm>
#include <cmath>

namespace asos {
Estimate hard_shadow(const ShadowContext& block, const ShadowQuery& query, ShadowPatch patch,
                     RenderStatistics& counts) {
  // Frame the patch as seen from the light.
  const Illumination& lit = query.lit;
  const bool parallel = lit.light.traits().infinite;
  const auto frame =
      parallel ? PatchCaster::frame_along(lit.light.towards, world_reach(block.scene->world), patch)
               : PatchCaster::frame_from(lit.light.position, patch);
  if (!frame) return ray_visibility(block, query, counts);
  // A smooth surface may still receive light that is below the patch's plane.
  const glm::dvec3 to_light =
      parallel ? lit.light.towards : lit.light.position - glm::dvec3(lit.point.lit_position());
  if (!(glm::dot(to_light, patch.plane.normal) > 0.0)) return sampled_shadow(block, query, counts);

  // A leaf whose visibility a few rays determine well enough is sampled immediately, if they cost
  // less than a search for boundaries.
  const ErrorBudget& error_budget = block.rules.error_budget;
  const bool refined = !block.rules.area_shadows;
  if (refined && query.takes_rays(error_budget, LeafCosts::search))
    return sampled_shadow(block, query, counts);

  // Search between the patch and the light.
  const double off_plane = deviation(block, lit.point, patch);
  const HalfSpace above{patch.plane.normal, patch.plane.offset + patch.lift + off_plane};
  const SubdivisionRules rules = shadow_rules(block.rules, query);
  Pyray pyray{*frame};
  pyray.bounds = query.found;
  pyray.bounds.within = std::span(&above, 1);
  pyray.bounds.beyond_first = patch.lift;
  pyray.seed = query.leaf.seed;
  const bool bounded = block.work->tracer.search(block.scene->features, pyray, rules);
  // The shadow has no boundaries, so the visibility from the leaf's sample is that of the whole
  // leaf.
  if (!bounded && !block.rules.see_through) return ray_visibility(block, query, counts);
  if (refined && query.takes_rays(error_budget, LeafCosts::patch))
    return sampled_shadow(block, query, counts);

  // Trace, with the leaf's own border.
  if (parallel) {
    // The parallel frame's square is not the leaf's square: the leaf is a region of it.
    std::vector<BorderEdge>& border = block.work->border;
    border.clear();
    const auto placed = [&](glm::vec2 at) {
      return glm::vec2(frame->homogeneous(*block.frame->on_plane(glm::dvec2(at), patch.plane)));
    };
    query.leaf.region.for_each_edge([&](const BorderEdge& edge) {
      border.push_back({placed(edge.from), placed(edge.to)});
    });
    patch.border = border;
  }
  PatchCaster& caster = block.work->patch_caster;
  caster.start(*block.scene, block.rules.see_through, *frame, patch,
               parallel ? block.frame : nullptr, lit.light.own_part);
  const Trace trace = trace_shadow(block, query, pyray, rules, caster, counts, patch.border);
  if (refined && trace.outcome.unresolved_area > rules.error_budget.eps)
    return sampled_shadow(block, query, counts);
  const auto visibility = caster.visibility();
  return visibility ? Estimate::exact(*visibility) : ray_visibility(block, query, counts);
}

}  // namespace asos
