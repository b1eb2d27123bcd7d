#pragma once

#include <glm/glm.hpp>

namespace asos {

/// The point of a surface that light falls on.
struct Receiver {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0, 1, 0};     ///< unit: irradiance is weighted by the cosine to it
  glm::dvec3 geometric{0, 1, 0};  ///< unit: the surface's own; nothing reaches it from below either
};

}  // namespace asos
