#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace asos {

/// Returns the largest of three components, as of a colour.
[[nodiscard]] inline float largest(glm::vec3 v) {
  return std::max({v.x, v.y, v.z});
}
[[nodiscard]] inline double largest(glm::dvec3 v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace asos
