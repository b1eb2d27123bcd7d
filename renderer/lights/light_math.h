#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {

/// Returns power times form, limited to the largest float, which it exceeds next to a point light.
[[nodiscard]] inline glm::vec3 irradiance_of(glm::vec3 power, double form) {
  constexpr double most = std::numeric_limits<float>::max();
  const glm::dvec3 product = glm::dvec3(power) * std::min(form, 1e200);
  return glm::vec3(glm::min(product, glm::dvec3(most)));
}

/// Returns a unit vector perpendicular to `axis` (unit).
[[nodiscard]] inline glm::dvec3 any_perpendicular(glm::dvec3 axis) {
  const glm::dvec3 other = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(other, axis));
}

}  // namespace asos
