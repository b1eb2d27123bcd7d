#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/geometry/frame.h"
#include "renderer/geometry/ray.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <limits>

namespace asos {

/// The plane of a sample's surface, as nearness over a frame's square. Boundaries behind it do not
/// count (design section 3, "Continuity is the proof"): on a path from the sample to anywhere in
/// the cell, the visible surface can change only at a visible boundary.
///
/// The surface need not be flat. A boundary counts as behind only if it is deeper than the plane by
/// a slack of two parts. One is a few widths of the cell in the world, for surfaces that curve away
/// within the cell. The other is the known deviation of the surface from the plane
/// (FeatureSet::deviation), for facets seen nearly edge-on.
struct OccluderPlane {
  // Plane: nearness = (per_u u + per_v v + at_origin) at slack 0. Moved back by a distance s along
  // its normal it is (nearness * distance) / (distance + s) for a pyramid, and nearness - s * slope
  // for a prism.
  double per_u = 0.0;
  double per_v = 0.0;
  double at_origin = 0.0;
  double distance = 0.0;   ///< from the apex to the plane; prism: 1 / slope
  double nearness = 0.0;   ///< of the sample itself
  double deviation = 0.0;  ///< largest deviation of the surface from the plane, in world units
  bool valid = false;

  /// Returns a cover that hides nothing.
  static OccluderPlane none() { return {}; }

  /// Returns the cover of a surface with normal `normal` (any length, any sign) at the world point
  /// `p`.
  static OccluderPlane plane(const Frame& frame, glm::dvec3 p, glm::dvec3 normal,
                             double deviation = 0.0);
};

/// Returns the cover of a hit.
[[nodiscard]] OccluderPlane occluder_of(const Frame& frame, const World& world,
                                        const FeatureSet& features, const Hit& hit);

/// A cover for one cell: hides boundaries below the nearness u * per_u + v * per_v + at_origin.
struct CellOccluder {
  float per_u = 0.0f;
  float per_v = 0.0f;
  float at_origin = -std::numeric_limits<float>::infinity();

  /// Moves the cover back by `occluder_slack` widths of a cell of the given side, and by the
  /// deviation.
  static CellOccluder of(const OccluderPlane& cover, const Frame& frame, float side);

  [[nodiscard]] bool hides(float u, float v, float nearness) const {
    return nearness < per_u * u + per_v * v + at_origin;
  }
  /// Returns whether it hides every point of a rectangle with at most this nearness.
  [[nodiscard]] bool hides(float u0, float v0, float u1, float v1, float nearness) const {
    return nearness < (per_u > 0.0f ? per_u * u0 : per_u * u1) +
                          (per_v > 0.0f ? per_v * v0 : per_v * v1) + at_origin;
  }
};

/// Distance behind a surface from which a boundary is hidden, in widths of the cell.
inline constexpr double occluder_slack = 4.0;

}  // namespace asos
