#include "renderer/published/published_shadows.h"

#include "renderer/published/extended_caster.h"
#include "renderer/shadows/area_shadow.h"
#include "renderer/shadows/shadow_context.h"

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
  const auto pyramid = LightPyramid::of(lit.light, middle);
  if (!pyramid) return std::nullopt;
  const auto extended = ExtendedPyray::of(*pyramid, *patch, fit);
  if (!extended) return std::nullopt;

  // Trace the pyray.
  Pyray pyray{extended->frame};
  pyray.bounds = query.found;
  pyray.bounds.within = extended->between;
  pyray.seed = query.leaf.seed;
  std::vector<BorderEdge> outline(pyramid->boundaries().begin(), pyramid->boundaries().end());
  if (fit == ExtendedPyray::Fit::around)
    outline.insert(outline.end(), extended->outline.begin(), extended->outline.end());
  pyray.outline = outline;
  thread_local ExtendedCaster caster;
  caster.start(*block.scene, block.rules.see_through, *extended, *pyramid, lit.light.own_part);
  (void)trace_shadow(block, query, pyray, shadow_rules(block.rules, query), caster, counts);
  return caster.visibility();
}

// Returns the mean visibility of an extended light over a part of the leaf's square. It uses one
// pyray from behind the surface, through the part of the patch that the light's projection covers
// (CGF'98 section 4.3.2).
Visibility extended_shadow(const ShadowContext& block, const ShadowQuery& query, const Square& part,
                           RenderStatistics& counts) {
  const auto visibility = trace_extended(block, query, part, ExtendedPyray::Fit::inside, counts);
  return visibility ? *visibility
                    : point_area_shadow(block, query,
                                        receiver_above(query.lit.point, query.lit.light), counts);
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

// Returns its mean visibility over the whole leaf. The leaf is divided until each part is inside
// the light's projection. Then a pyray around each part is traced, and only its rays through the
// part count (4.3.4).
Visibility adaptive_extended_shadow(const ShadowContext& block, const ShadowQuery& query,
                                    RenderStatistics& counts) {
  return adaptive_shadow(block, query, query.leaf.region.square,
                         levels_left(block.rules, query.leaf), counts);
}

}  // namespace

// Returns the mean over n x n parts of the patch: by pyrays from a point of each, or by extended
// ones.
Visibility PublishedShadows::divided(const ShadowContext& block, const ShadowQuery& query,
                                     RenderStatistics& counts) const {
  const int n = divisions_;
  const bool extended = quality_ == ShadowQuality::extended_divided;
  const bool jittered = quality_ == ShadowQuality::supersampling;
  const LeafRegion& region = query.leaf.region;
  const Receiver middle = receiver_above(query.lit.point, query.lit.light);
  const glm::dvec3 lift = middle.position - glm::dvec3(query.lit.point.position);
  const HalfSpace plane = HalfSpace::through(middle.position - lift, middle.geometric);
  Visibility sum(0.0);
  int parts = 0;
  for (int i = 0; i < n * n; ++i) {
    // Choose a point of the part.
    const Square part = region.square.part(n, i);
    const std::uint64_t seed =
        query.leaf.seed + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(i);
    const glm::dvec2 inside = jittered ? unit_pair_of(seed) : glm::dvec2(0.5);
    const glm::vec2 at(part.u + part.side * static_cast<float>(inside.x),
                       part.v + part.side * static_cast<float>(inside.y));
    if (!region.holds(at)) continue;
    // Find the visibility from the point, or from the part.
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

Visibility PublishedShadows::of_patch(const ShadowContext& block, const ShadowQuery& query,
                                      RenderStatistics& counts) const {
  // An extended pyray needs a leaf that is a whole square.
  const bool whole = query.leaf.region.border.empty();
  switch (quality_) {
    case ShadowQuality::supersampling:
    case ShadowQuality::forced:
      return divided(block, query, counts);
    case ShadowQuality::extended_divided:
      if (whole) return divided(block, query, counts);
      break;
    case ShadowQuality::extended:
      if (whole) return extended_shadow(block, query, query.leaf.region.square, counts);
      break;
    case ShadowQuality::extended_adaptive:
      if (whole) return adaptive_extended_shadow(block, query, counts);
      break;
    case ShadowQuality::refined:
    case ShadowQuality::centre:
      break;
  }
  return point_area_shadow(block, query, receiver_above(query.lit.point, query.lit.light), counts);
}

}  // namespace asos
