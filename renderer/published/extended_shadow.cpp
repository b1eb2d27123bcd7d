#include "renderer/published/extended_shadow.h"

#include "renderer/published/extended_caster.h"
#include "renderer/shadows/area_shadow.h"

#include <algorithm>

namespace asos {
namespace {

std::optional<Visibility> trace_extended(const ShadowContext& block, const ShadowQuery& query,
                                         const Square& part, ExtendedPyray::Fit fit,
                                         RenderStatistics& counts) {
  // Fit the pyray to the light and the patch.
  const Illumination& lit = query.lit;
  const auto patch = patch_of(block, lit.point, query.leaf.region, part);
  if (!patch) return std::nullopt;
  Receiver middle = receiver_above(lit.point, lit.light);
  middle.position =
      0.25 * (patch->corners[0] + patch->corners[1] + patch->corners[2] + patch->corners[3]) +
      (middle.position - glm::dvec3(lit.point.position));
  const auto window = LightPyramid::of(lit.light, middle);
  if (!window) return std::nullopt;
  const auto extended = ExtendedPyray::of(*window, *patch, fit);
  if (!extended) return std::nullopt;

  // Trace it.
  Pyray pyray{extended->frame};
  pyray.bounds = query.found;
  pyray.bounds.within = extended->between;
  pyray.seed = query.leaf.seed;
  std::vector<BorderEdge> outline(window->boundaries().begin(), window->boundaries().end());
  if (fit == ExtendedPyray::Fit::around)
    outline.insert(outline.end(), extended->outline.begin(), extended->outline.end());
  pyray.outline = outline;
  thread_local ExtendedCaster caster;
  caster.start(*block.scene, block.rules.see_through, *extended, *window, lit.light.own_part);
  (void)trace_shadow(block, query, pyray, shadow_rules(block.rules, query), caster, counts);
  return caster.visibility();
}

// Divides parts that are not inside the light's projection into four.
Visibility adaptive_shadow(const ShadowContext& block, const ShadowQuery& query, const Square& part,
                           int levels, RenderStatistics& counts) {
  if (const auto visibility =
          trace_extended(block, query, part, ExtendedPyray::Fit::around, counts))
    return *visibility;
  if (levels <= 0) return extended_shadow(block, query, part, counts);
  Visibility sum(0.0);
  for (int i = 0; i < 4; ++i)
    sum += 0.25 * adaptive_shadow(block, query, part.quarter(i), levels - 1, counts);
  return sum;
}

}  // namespace

Visibility extended_shadow(const ShadowContext& block, const ShadowQuery& query, const Square& part,
                           RenderStatistics& counts) {
  const auto visibility = trace_extended(block, query, part, ExtendedPyray::Fit::inside, counts);
  return visibility ? *visibility
                    : point_area_shadow(block, query,
                                        receiver_above(query.lit.point, query.lit.light), counts);
}

Visibility adaptive_extended_shadow(const ShadowContext& block, const ShadowQuery& query,
                                    RenderStatistics& counts) {
  return adaptive_shadow(block, query, query.leaf.region.square,
                         levels_left(block.rules, query.leaf), counts);
}

}  // namespace asos
