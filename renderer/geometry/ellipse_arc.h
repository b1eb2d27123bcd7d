#pragma once

#include "renderer/geometry/shape_face.h"

#include <glm/glm.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace asos {

/// The points centre + cos(t) * cosine + sin(t) * sine with from <= t <= to.
struct EllipseArc {
  glm::dvec3 centre{0.0};
  glm::dvec3 cosine{0.0};
  glm::dvec3 sine{0.0};
  double from = 0.0;
  double to = 2.0 * std::numbers::pi;

  /// Returns the point at an angle, always with the same bits for the same angle.
  [[nodiscard]] glm::dvec3 at(double angle) const {
    return centre + std::cos(angle) * cosine + std::sin(angle) * sine;
  }
  [[nodiscard]] bool closed() const { return to - from >= 2.0 * std::numbers::pi; }
};

/// Appends the angles t where c0 + ca cos(t) + cb sin(t) = 0, which is where an arc crosses a
/// plane.
inline void add_crossings(double c0, double ca, double cb, std::vector<double>& angles) {
  const double size = std::hypot(ca, cb);
  if (!(size > std::abs(c0))) return;
  const double middle = std::atan2(cb, ca);
  const double half = std::acos(-c0 / size);
  angles.push_back(middle - half);
  angles.push_back(middle + half);
}

/// Returns the circle around a face's axis at the height y of the unit surface. Its angle is that
/// of the unit surface's point (cos, y, sin).
[[nodiscard]] inline EllipseArc ring(const ShapeFace& face, double y) {
  const double r = face.kind == ShapeFace::Kind::side ? face.radius_at(y) : 1.0;
  return {face.world({0.0, y, 0.0}), r * face.world_from_unit[0], r * face.world_from_unit[2]};
}

}  // namespace asos
