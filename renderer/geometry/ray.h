#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>

namespace asos {

/// Points origin + t * direction with t_near <= t <= t_far. In this order of members, both vectors
/// are 16-byte aligned, so that a copy by 16 bytes causes no stall.
struct Ray {
  glm::vec3 origin{0.0f};
  float t_near = 0.0f;
  glm::vec3 direction{0, 0, -1};
  float t_far = std::numeric_limits<float>::infinity();

  [[nodiscard]] glm::vec3 at(float t) const { return origin + t * direction; }
};

/// The hit of a ray with a triangle: the point is (1-b1-b2) p0 + b1 p1 + b2 p2.
struct Hit {
  static constexpr std::uint32_t none = 0xffffffffu;

  std::uint32_t triangle = none;  ///< index into World::triangles
  float t = std::numeric_limits<float>::infinity();
  float b1 = 0.0f;
  float b2 = 0.0f;

  [[nodiscard]] bool valid() const { return triangle != none; }
};

}  // namespace asos
