#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace asos::test {

/// The intersection of a line with a triangle's plane.
struct TriangleCrossing {
  double t = 0.0;   ///< along the line, in lengths of its direction
  double b1 = 0.0;  ///< barycentric coordinates of the second and the third corner
  double b2 = 0.0;

  /// The smallest barycentric coordinate: not negative inside the triangle.
  [[nodiscard]] double inside() const { return std::min({b1, b2, 1.0 - b1 - b2}); }
};

/// Intersects one triangle in double precision, as a reference for the ray tracer (Moeller and
/// Trumbore 1997). nullopt: the line is parallel to the plane.
[[nodiscard]] inline std::optional<TriangleCrossing> crossing(const World& world,
                                                              std::uint32_t triangle,
                                                              glm::dvec3 origin,
                                                              glm::dvec3 direction) {
  const glm::uvec3 corner = world.triangles[triangle];
  const glm::dvec3 p0(world.positions[corner.x]);
  const glm::dvec3 e1 = glm::dvec3(world.positions[corner.y]) - p0;
  const glm::dvec3 e2 = glm::dvec3(world.positions[corner.z]) - p0;
  const glm::dvec3 p = glm::cross(direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0.0) return std::nullopt;
  const glm::dvec3 s = origin - p0;
  const glm::dvec3 q = glm::cross(s, e1);
  return TriangleCrossing{glm::dot(e2, q) / determinant, glm::dot(s, p) / determinant,
                          glm::dot(direction, q) / determinant};
}

}  // namespace asos::test
