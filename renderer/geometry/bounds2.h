#pragma once

#include <glm/glm.hpp>

namespace asos {

/// An axis-aligned rectangle in a plane.
struct Bounds2 {
  glm::vec2 lo{0.0f};
  glm::vec2 hi{0.0f};
};

}  // namespace asos
