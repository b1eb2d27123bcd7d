#pragma once

#include "renderer/world/hit_plane.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cmath>

namespace asos {

/// The surface of a hit, with the hit's weights: a triangle, or the plane that touches an analytic
/// shape there (HitPlane).
struct HitTriangle {
  bool face;
  glm::uvec3 v{0};  ///< vertices of a triangle
  float b0, b1, b2;

  HitTriangle(const World& world, const Hit& hit)
      : face(world.is_face(hit.triangle)), b0(1.0f - hit.b1 - hit.b2), b1(hit.b1), b2(hit.b2) {
    if (!face) v = world.triangles[hit.triangle];
  }

  template <typename T>
  [[nodiscard]] T mix(const T& at_0, const T& at_1, const T& at_2) const {
    return b0 * at_0 + b1 * at_1 + b2 * at_2;
  }
};

/// Returns `v` normalized, or `fallback` if it has no direction.
[[nodiscard]] inline glm::vec3 normalized_or(glm::vec3 v, glm::vec3 fallback) {
  const float length2 = glm::dot(v, v);
  return length2 > 0.0f && std::isfinite(length2) ? v / std::sqrt(length2) : fallback;
}

}  // namespace asos
