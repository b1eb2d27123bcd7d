#pragma once

#include <glm/glm.hpp>

namespace asos {

/// A point of a surface that receives light.
struct Receiver {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0, 1, 0};  ///< unit: irradiance is weighted by the cosine to it
  /// Unit normal of the surface itself; no light arrives from below its horizon, either.
  glm::dvec3 geometric{0, 1, 0};
};

}  // namespace asos
