#pragma once

#include "renderer/geometry/finite.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace asos {

/// Returns a unit vector along `v`, or `fallback` if it has no direction. Any length is allowed:
/// components are scaled first, since squares of very large and very small ones would not fit.
[[nodiscard]] inline glm::vec3 unit_or(glm::dvec3 v, glm::vec3 fallback) {
  const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(most > 0.0) || !finite(v)) return fallback;
  return glm::vec3(glm::normalize(v / most));
}

/// Returns the direction, mirrored above the plane of a normal if it leads below it.
template <typename Vector>
[[nodiscard]] Vector above_plane(const Vector& direction, const Vector& normal) {
  const auto height = glm::dot(direction, normal);
  return height < 0 ? direction - 2 * height * normal : direction;
}

/// Returns a unit vector perpendicular to a unit vector.
[[nodiscard]] inline glm::vec3 any_perpendicular(glm::vec3 n) {
  const glm::vec3 axis = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, n));
}

}  // namespace asos
