#include "renderer/published/published_shadows.h"

#include "renderer/published/extended_shadow.h"

namespace asos {

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
