#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

namespace asos::test {

/// A polygon in the picture plane, as a list of corners.
using Polygon = std::vector<glm::dvec2>;

/// The part of a convex polygon where `depth`, a linear function of a point, is not negative: one
/// step of Sutherland and Hodgman. Returns fewer than three corners if there is no such part.
template <class Depth>
[[nodiscard]] Polygon clip(const Polygon& polygon, const Depth& depth) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 p = polygon[i];
    const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
    if (depth(p) >= 0.0) kept.push_back(p);
    if ((depth(p) < 0.0) != (depth(q) < 0.0)) {
      kept.push_back(p + (q - p) * (depth(p) / (depth(p) - depth(q))));
    }
  }
  return kept;
}

/// The part of a convex polygon inside the unit square.
[[nodiscard]] inline Polygon clip_to_unit_square(Polygon polygon) {
  for (int side = 0; side < 4; ++side) {
    const int k = side & 1;
    polygon = clip(polygon, [&](glm::dvec2 p) { return side < 2 ? p[k] : 1.0 - p[k]; });
  }
  return polygon;
}

[[nodiscard]] inline double area(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 p = polygon[i];
    const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return 0.5 * std::abs(twice);
}

}  // namespace asos::test
