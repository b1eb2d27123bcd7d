#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace asos {

/// An axis-aligned box; empty until it grows.
struct Box {
  glm::vec3 lo{std::numeric_limits<float>::infinity()};
  glm::vec3 hi{-std::numeric_limits<float>::infinity()};

  [[nodiscard]] bool empty() const { return !(lo.x <= hi.x); }
  void grow(glm::vec3 p) { lo = glm::min(lo, p), hi = glm::max(hi, p); }
  void grow(const Box& b) { lo = glm::min(lo, b.lo), hi = glm::max(hi, b.hi); }
};

}  // namespace asos
