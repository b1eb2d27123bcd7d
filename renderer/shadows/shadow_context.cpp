#include "renderer/shadows/shadow_context.h"

#include "renderer/geometry/largest.h"
#include "renderer/pyray/tuning.h"
#include "renderer/sampling/random.h"

#include <algorithm>
#include <cmath>

namespace asos {

double ShadowQuery::intensity() const {
  return std::min(1.0, static_cast<double>(largest(lit.reflected * lit.unshadowed)));
}

Receiver receiver_above(const SurfacePoint& point, const PreparedLight& light) {
  Receiver receiver = receiver_at(point);
  const double height = static_cast<double>(clear_height(point));
  // The centre of a sun that is partly above the horizon may lie below it.
  const bool risen = light.traits().infinite && glm::dot(receiver.geometric, light.towards) > 0.0;
  receiver.position += risen ? clear_way(height, static_cast<double>(point.to_edge),
                                         receiver.geometric, light.towards)
                             : height * receiver.geometric;
  return receiver;
}

// Hashes to well-mixed bits (Steele, Lea and Flood 2014).
glm::dvec2 unit_pair_of(std::uint64_t bits) {
  const RandomPair pair = unit_pair(mix_bits(bits));
  return {pair.u, pair.v};
}

SubdivisionRules shadow_rules(const ShadowRules& rules, const ShadowQuery& query) {
  SubdivisionRules shadow;
  shadow.error_budget = rules.error_budget.nested(query.leaf.level(), query.intensity(), 1);
  shadow.variant = rules.variant;
  shadow.jitter = true;
  shadow.finest_detail = ShadowTuning::finest_detail;
  shadow.limits.most_groups = ShadowTuning::most_groups;
  shadow.limits.most_boundaries = ShadowTuning::most_boundaries;
  shadow.limits.most_pieces = ShadowTuning::most_pieces;
  shadow.limits.tolerance = std::ldexp(shadow.finest_side(), -6);
  return shadow;
}

int levels_left(const ShadowRules& rules, const Leaf& leaf) {
  return rules.error_budget.nested(leaf.level(), 1.0, 1).max_level;
}

std::size_t most_entries_for_samples(int levels) {
  return std::max(ShadowTuning::least_entries_for_samples, (std::size_t{1} << 2 * levels) / 2);
}

bool has_patch(const ShadowContext& block, const Illumination& lit) {
  if (lit.layer == 0) return true;
  return lit.point.triangle != Hit::none &&
         block.scene->features.deviation(lit.point.triangle) <= 0.0f;
}

std::optional<ShadowPatch> patch_of(const ShadowContext& block, const SurfacePoint& point,
                                    const LeafRegion& region, const Square& s) {
  ShadowPatch patch;
  // Use the same height above the triangle everywhere: the smooth surface's own plane may dip below
  // it.
  patch.plane =
      HalfSpace::through(glm::dvec3(point.lit_position()), glm::dvec3(point.geometric_normal));
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 corner(s.u + ((i & 1) ? s.side : 0.0f), s.v + ((i & 2) ? s.side : 0.0f));
    const auto at = block.frame->on_plane(corner, patch.plane);
    if (!at) return std::nullopt;
    patch.corners[i] = *at;
  }
  std::vector<BorderEdge>& border = block.work->border;
  border.clear();
  const glm::vec2 origin(s.u, s.v);
  for (const BorderEdge& edge : region.border)
    border.push_back({(edge.from - origin) / s.side, (edge.to - origin) / s.side});
  patch.border = border;
  patch.lift = static_cast<double>(clear_height(point));
  return patch;
}

double deviation(const ShadowContext& block, const SurfacePoint& point, const ShadowPatch& patch) {
  const auto& p = patch.corners;
  const double reach = 0.5 * std::max(glm::distance(p[0], p[3]), glm::distance(p[1], p[2]));
  return block.scene->features.deviation(point.triangle, glm::dvec3(point.position), reach);
}

Trace trace_shadow(const ShadowContext& block, const ShadowQuery& query, const Pyray& pyray,
                   const SubdivisionRules& rules, ShadowCaster& caster, RenderStatistics& counts,
                   std::optional<std::span<const BorderEdge>> searched) {
  Tracer& tracer = block.work->tracer;
  TracedPyray own;
  TracedPyray* traced = query.leaf.observed.wants_more() ? &own : nullptr;
  const Trace trace = searched ? tracer.trace_searched(pyray, *searched, rules, caster, traced)
                               : tracer.trace(block.scene->features, pyray, rules, caster, traced);
  counts.shadow_rays += caster.rays_cast();
  counts.count_shadow_pyray(query.lit.index);
  if (traced && !trace.timed_out) {
    const int number = query.leaf.observed.begin(TracedPyray::Kind::shadow);
    TracedPyray& sent = query.leaf.observed.observer->at(number);
    sent.light = query.lit.index;
    sent.result = glm::vec3(caster.visibility().value_or(Visibility(0.0)));
    sent.levels = std::move(own.levels);
    sent.cells = std::move(own.cells);
  }
  return trace;
}

}  // namespace asos
