#pragma once

#include "renderer/lights/receiver.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {

/// Returns the cosine of `direction` (unit) to the receiver's normal; 0 below either of its
/// horizons.
[[nodiscard]] inline double cosine_above(glm::dvec3 direction, const Receiver& receiver) {
  if (!(glm::dot(direction, receiver.geometric) > 0.0)) return 0.0;
  return std::max(0.0, glm::dot(direction, receiver.normal));
}

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
