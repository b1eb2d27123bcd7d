#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/geometry/frame.h"
#include "renderer/geometry/ray.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <limits>

namespace asos {

/// The plane of a surface that a sample met, as nearness over a frame's square. Boundaries that lie
/// behind it do not count (design section 3, "Continuity is the proof"): on a path from the sample
/// to anywhere in the cell the visible surface can change only across a boundary that is visible.
///
/// The surface need not be flat. A boundary counts as behind only if it is deeper than the plane
/// by `slack`: a few times the cell's width in the world, for a surface that bends away inside the
/// cell, and as far as the surface is known to leave the plane (FeatureSet::departure), for one
/// that does so in a facet seen nearly edge-on.
struct Cover {
  // Plane: q = (qu u + qv v + q1) at slack 0. Pushed back by a distance s along its normal it is
  // (q * distance) / (distance + s) for a pyramid and q - s * q_slope for a prism.
  double qu = 0.0;
  double qv = 0.0;
  double q1 = 0.0;
  double distance = 0.0;   ///< of the apex from the plane; prism: 1 / q_slope
  double q = 0.0;          ///< nearness of the sample itself
  double departure = 0.0;  ///< how far the surface may leave the plane, in world units
  bool valid = false;

  /// No cover: everything counts.
  static Cover none() { return {}; }

  /// Of a surface with normal `normal` (any length, any sign) at the world point `p`.
  static Cover plane(const Frame& frame, glm::dvec3 p, glm::dvec3 normal, double departure = 0.0);
};

/// Of what a ray met.
[[nodiscard]] Cover cover_of(const Frame& frame, const World& world, const FeatureSet& features,
                             const Hit& hit);

/// A cover for one cell: hides what lies below q = u * qu + v * qv + q1.
struct HidingPlane {
  float qu = 0.0f;
  float qv = 0.0f;
  float q1 = -std::numeric_limits<float>::infinity();

  /// Pushed back by `cover_slack` widths of a cell of the given side, and by the departure.
  static HidingPlane of(const Cover& cover, const Frame& frame, float side);

  [[nodiscard]] bool hides(float u, float v, float q) const { return q < qu * u + qv * v + q1; }
  /// Hides every point of a rectangle whose nearness is at most q.
  [[nodiscard]] bool hides(float u0, float v0, float u1, float v1, float q) const {
    return q < (qu > 0.0f ? qu * u0 : qu * u1) + (qv > 0.0f ? qv * v0 : qv * v1) + q1;
  }
};

/// How far behind a surface a boundary must lie to be hidden, in widths of the cell.
inline constexpr double cover_slack = 4.0;

}  // namespace asos
