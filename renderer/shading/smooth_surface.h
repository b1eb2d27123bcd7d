#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>

namespace asos {

/// A triangle's corners and unit normals, between which the smooth surface is interpolated.
struct SmoothTriangle {
  std::array<glm::vec3, 3> corner;
  std::array<glm::vec3, 3> normal;

  [[nodiscard]] bool flat() const { return normal[0] == normal[1] && normal[0] == normal[2]; }
};

/// A triangle represents a smooth surface only if each corner's normal is within 45 degrees of the
/// triangle's. Beyond that it is an edge with averaged normals.
inline constexpr float least_smooth_cosine = 0.70710678f;
/// A surface that rises above its triangle by less than this fraction of its extent is flat.
inline constexpr float least_bulge = 1.0f / 4096.0f;

/// Returns the displacement from a triangle to the smooth surface at a point with these weights.
/// The point moves to each corner's tangent plane if that lies above it, and the results are mixed
/// by the weights (Hanika 2021, "Hacking the Shadow Terminator", Ray Tracing Gems II, chapter 4).
/// `side` times the normals are on the side of `geometric`, the triangle's unit normal; `extent` is
/// the triangle's largest side. Returns 0 where the surface is flat or concave on that side.
[[nodiscard]] inline glm::vec3 height_of_smooth(const SmoothTriangle& t, glm::vec3 weights,
                                                glm::vec3 geometric, float side, float extent) {
  glm::vec3 lift(0.0f);
  if (t.flat()) return lift;
  float highest = 0.0f, least_cosine = 1.0f;
  for (int i = 0; i < 3; ++i) {
    const auto a = static_cast<std::size_t>(i), b = (a + 1) % 3, c = (a + 2) % 3;
    const glm::vec3 normal = side * t.normal[a];
    least_cosine = std::min(least_cosine, glm::dot(normal, geometric));
    // Heights of the tangent plane above the other corners, and above the point.
    const float above_b = glm::dot(t.corner[a] - t.corner[b], normal);
    const float above_c = glm::dot(t.corner[a] - t.corner[c], normal);
    highest = std::max(highest, std::max(above_b, above_c));
    const float above = weights[(i + 1) % 3] * above_b + weights[(i + 2) % 3] * above_c;
    lift += weights[i] * std::max(0.0f, above) * normal;
  }
  const bool smooth = highest > least_bulge * extent && least_cosine > least_smooth_cosine;
  return smooth ? lift : glm::vec3(0.0f);
}

}  // namespace asos
