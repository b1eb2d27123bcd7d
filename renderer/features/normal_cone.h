#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <numbers>

namespace asos {

/// A double cone around the normals of faces.
struct NormalCone {
  glm::dvec3 axis{0.0};
  double angle = -1.0;  ///< radians; negative: of nothing; pi/2 or more: holds every direction

  static NormalCone everything() { return {{0, 0, 1}, std::numbers::pi}; }
};

inline double angle_between(glm::dvec3 x, glm::dvec3 y) {
  return std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y));
}

/// The smallest cone that holds both, the second one turned over where that is narrower.
inline NormalCone merge(const NormalCone& x, NormalCone y) {
  if (x.angle < 0.0) return y;
  if (y.angle < 0.0) return x;
  if (glm::dot(x.axis, y.axis) < 0.0) y.axis = -y.axis;
  const double between = angle_between(x.axis, y.axis);
  if (between + y.angle <= x.angle) return x;
  if (between + x.angle <= y.angle) return y;
  const double angle = 0.5 * (x.angle + y.angle + between);
  if (angle >= 0.5 * std::numbers::pi) return NormalCone::everything();
  // Turn x's axis towards y's by what the new cone leaves.
  const glm::dvec3 side = glm::normalize(y.axis - x.axis * glm::dot(x.axis, y.axis));
  const double turn = angle - x.angle;
  return {std::cos(turn) * x.axis + std::sin(turn) * side, angle};
}

}  // namespace asos
