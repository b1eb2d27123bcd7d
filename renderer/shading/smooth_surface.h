#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>

namespace asos {

/// A triangle's corners and the unit normals that are interpolated between them.
struct SmoothTriangle {
  std::array<glm::vec3, 3> corner;
  std::array<glm::vec3, 3> normal;

  [[nodiscard]] bool flat() const { return normal[0] == normal[1] && normal[0] == normal[2]; }
};

/// A corner's normal turns from the triangle's by 45 degrees at most where the triangle stands for
/// a smooth surface, and not for an edge whose normals were averaged.
inline constexpr float least_smooth_cosine = 0.70710678f;
/// A surface that rises above its triangle by less than so much of its extent is flat.
inline constexpr float least_bulge = 1.0f / 4096.0f;

/// How far the smooth surface lies above a triangle at a point of these weights: towards it from
/// each corner's tangent plane that lies above the point, mixed by the weights (Hanika 2021,
/// "Hacking the Shadow Terminator", Ray Tracing Gems II, chapter 4). `side` times the normals are
/// on the side of `geometric`, the triangle's unit normal; `extent` is its largest side. 0 where
/// the surface is flat or hollow on that side.
[[nodiscard]] inline glm::vec3 height_of_smooth(const SmoothTriangle& t, glm::vec3 weights,
                                                glm::vec3 geometric, float side, float extent) {
  glm::vec3 lift(0.0f);
  if (t.flat()) return lift;
  float highest = 0.0f, least_cosine = 1.0f;
  for (int i = 0; i < 3; ++i) {
    const auto a = static_cast<std::size_t>(i), b = (a + 1) % 3, c = (a + 2) % 3;
    const glm::vec3 normal = side * t.normal[a];
    least_cosine = std::min(least_cosine, glm::dot(normal, geometric));
    // The tangent plane's heights above the other corners, and above the point.
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
