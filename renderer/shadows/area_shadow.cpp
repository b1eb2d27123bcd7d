#include "renderer/shadows/area_shadow.h"

#include "renderer/pyray/prices.h"
#include "renderer/shadows/broad_lobe.h"
#include "renderer/shadows/extended_shadow.h"
#include "renderer/shadows/penumbra.h"
#include "renderer/shadows/sampled_shadow.h"
#include "renderer/shadows/shadow.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// A light that cannot be cut along its boundaries, nor its quarters, is sampled: more levels of
// pyrays cost more than rays that look from all over the patch.
constexpr int window_levels = 1;
// A light whose square holds more groups of boundaries is saturated.
constexpr std::size_t most_entries = 400;

Square part_of(const Square& s, int n, int i) {
  const float side = s.side / static_cast<float>(n);
  return {s.u + static_cast<float>(i % n) * side, s.v + static_cast<float>(i / n) * side, side};
}

bool is_saturated(const ShadowQuery& query) {
  const auto& lights = query.leaf.saturated;
  return std::find(lights.begin(), lights.end(), query.lit.index) != lights.end();
}

// Whether the leaf would be split further for its shadow, had its parent left any levels: rays from
// all over it are then the better last word than a pyray from its middle.
bool uneven_at_last(const ShadowContext& block, const ShadowQuery& query,
                    RenderStatistics& counts) {
  if (query.leaf.level() < block.rules.budget.max_level) return false;
  const Illumination& lit = query.lit;
  const auto patch = patch_of(block, lit.point, query.leaf.region, query.leaf.region.square);
  if (!patch) return false;
  const auto& p = patch->corners;
  const Patch shown{glm::vec3(0.5 * (p[1] - p[0] + p[3] - p[2])),
                    glm::vec3(0.5 * (p[2] - p[0] + p[3] - p[1]))};
  const float reflected = std::max({lit.reflected.x, lit.reflected.y, lit.reflected.z});
  const Penumbra penumbra = find_penumbra(
      block,
      {lit.light, lit.index, lit.point, shown, reflected, query.leaf.level(), query.leaf.weight},
      counts);
  return penumbra.error > block.rules.budget.penumbra_tolerance(block.lights);
}

// The mean over n x n parts of the patch: pyrays from points of each, or extended ones.
Visibility divided_shadow(const ShadowContext& block, const ShadowQuery& query,
                          RenderStatistics& counts) {
  const int n = block.rules.divisions;
  const bool extended = block.rules.quality == ShadowQuality::extended_divided;
  const bool jittered = block.rules.quality == ShadowQuality::supersampling;
  const LeafRegion& region = query.leaf.region;
  const Receiver middle = receiver_above(query.lit.point, query.lit.light);
  const glm::dvec3 lift = middle.position - glm::dvec3(query.lit.point.position);
  const HalfSpace plane = HalfSpace::through(middle.position - lift, middle.geometric);
  Visibility sum(0.0);
  int parts = 0;
  for (int i = 0; i < n * n; ++i) {
    // Choose a point of the part.
    const Square part = part_of(region.square, n, i);
    const std::uint64_t seed =
        query.leaf.seed + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(i);
    const glm::dvec2 inside = jittered ? unit_pair_of(seed) : glm::dvec2(0.5);
    const glm::vec2 at(part.u + part.side * static_cast<float>(inside.x),
                       part.v + part.side * static_cast<float>(inside.y));
    if (!region.holds(at)) continue;
    // Find the visibility from it, or from the part.
    if (extended) {
      sum += extended_shadow(block, query, part, counts);
    } else {
      Receiver receiver = middle;
      receiver.position =
          block.frame->on_plane(glm::dvec2(at), plane).value_or(middle.position - lift) + lift;
      sum += point_area_shadow(block, query, receiver, counts);
    }
    ++parts;
  }
  return parts > 0 ? sum / static_cast<double>(parts)
                   : point_area_shadow(block, query, middle, counts);
}

// By rays where they cost less, or tell more, than a pyray from the patch's middle.
Visibility refined_shadow(const ShadowContext& block, const ShadowQuery& query,
                          const Receiver& middle, RenderStatistics& counts) {
  const PreparedLight& light = query.lit.light;
  const bool by_rays =
      block.rules.budget.rays_suffice(query.leaf.weight, query.intensity(), Prices::light_window) ||
      light.entered || is_saturated(query) || uneven_at_last(block, query, counts);
  if (by_rays) return sampled_shadow(block, query, counts);
  const Visibility seen = point_area_shadow(block, query, middle, counts);
  return lobe_tells_apart(block, query.lit, seen) ? sampled_shadow(block, query, counts) : seen;
}

}  // namespace

Visibility area_shadow(const ShadowContext& block, const ShadowQuery& query,
                       RenderStatistics& counts) {
  // An extended pyray needs a patch that lies on the surface as a whole.
  const bool whole = query.leaf.region.border.empty();
  const Receiver middle = receiver_above(query.lit.point, query.lit.light);
  if (query.lit.layer > 0) {
    // No verdict looks behind a surface, so that nothing tells that one pyray does.
    const bool by_rays =
        block.rules.quality == ShadowQuality::refined && has_patch(block, query.lit);
    return by_rays ? sampled_shadow(block, query, counts)
                   : point_area_shadow(block, query, middle, counts);
  }
  switch (block.rules.quality) {
    case ShadowQuality::refined:
      return refined_shadow(block, query, middle, counts);
    case ShadowQuality::centre:
      break;
    case ShadowQuality::supersampling:
    case ShadowQuality::forced:
      return divided_shadow(block, query, counts);
    case ShadowQuality::extended_divided:
      if (whole) return divided_shadow(block, query, counts);
      break;
    case ShadowQuality::extended:
      if (whole) return extended_shadow(block, query, query.leaf.region.square, counts);
      break;
    case ShadowQuality::extended_adaptive:
      if (whole) return adaptive_extended_shadow(block, query, counts);
      break;
  }
  return point_area_shadow(block, query, middle, counts);
}

Visibility point_area_shadow(const ShadowContext& block, const ShadowQuery& query,
                             const Receiver& receiver, RenderStatistics& counts) {
  const auto window = LightWindow::of(query.lit.light, receiver);
  if (!window) return ray_visibility(block, query, counts);

  // The pyray goes through the light's square, between the surface and the light.
  SubdivisionRules rules = shadow_rules(block.rules, query);
  rules.most_entries = most_entries;
  const bool refined = block.rules.quality == ShadowQuality::refined;
  if (refined || !block.rules.see_through)
    rules.budget.max_level = std::min(rules.budget.max_level, window_levels);
  Pyray pyray{window->frame()};
  pyray.bounds = query.found;
  pyray.bounds.within = window->between();
  pyray.bounds.most_entries = most_entries_for_samples(levels_left(block.rules, query.leaf));
  pyray.outline = window->boundaries();
  pyray.seed = query.leaf.seed;

  // Visibility that varies between outlines is sampled; the paper's qualities split the light for
  // it.
  WindowCaster& caster = block.work->window_caster;
  caster.start(*block.scene, block.rules.see_through, query.lit.light, *window, refined);
  const Trace trace = trace_shadow(block, query, pyray, rules, caster, counts);
  const bool saturated =
      trace.given_up || caster.gives_up() || trace.outcome.unresolved_area > rules.budget.eps;
  return saturated ? sampled_shadow(block, query, counts)
                   : caster.visibility().value_or(Visibility(0.0));
}

}  // namespace asos
