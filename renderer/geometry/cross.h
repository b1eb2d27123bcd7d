#pragma once

#include <glm/glm.hpp>

namespace asos {

/// Twice the area of the triangle 0, a, b: above 0 where b lies counter-clockwise of a, as x and y
/// are drawn to the right and up.
[[nodiscard]] inline double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace asos
