#pragma once

#include <glm/glm.hpp>

namespace asos {

/// Returns twice the area of the triangle 0, a, b; above 0 if b is counter-clockwise of a, with x
/// to the right and y up.
[[nodiscard]] inline double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace asos
