#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

// Surfaces that light goes straight through, one behind the other.

namespace asos {

/// The share of a layer behind others below which no display shows it, even at +8 stops.
inline constexpr float invisible_share = 1.0f / (256.0f * 256.0f);

/// Where the ray goes on behind a surface it has met: beyond the error of the hit's distance.
[[nodiscard]] inline float behind(const Ray& ray, const SurfacePoint& point, float t) {
  const float length = glm::length(ray.direction);
  const glm::vec3 d = ray.direction / length;
  const float across = std::abs(glm::dot(point.geometric_normal, d));
  // The surface's own error along its normal, seen along the ray; at most 64 times that for rays
  // that graze it. A triangle met twice all the same is noticed by its index.
  const glm::vec3 moved = spawn_origin(point, point.geometric_normal) - point.position;
  const float error = glm::length(moved) / (std::max(across, 1.0f / 64.0f) * length);
  return std::max(std::nextafter(t, std::numeric_limits<float>::infinity()), t + error);
}

}  // namespace asos
