#pragma once

#include <glm/glm.hpp>

namespace asos {

/// The points p with dot(normal, p) >= offset.
struct HalfSpace {
  glm::dvec3 normal{0, 0, 1};
  double offset = 0.0;

  /// Returns the half-space whose border goes through a point.
  [[nodiscard]] static HalfSpace through(glm::dvec3 point, glm::dvec3 normal) {
    return {normal, glm::dot(normal, point)};
  }

  /// Returns the height: above zero inside; a distance if the normal is unit.
  [[nodiscard]] double height(glm::dvec3 p) const { return glm::dot(normal, p) - offset; }
};

}  // namespace asos
