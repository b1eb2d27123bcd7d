#include "renderer/features/triangle_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos {
namespace {

// Distances below this fraction of the coordinates are rounding errors.
constexpr double on_plane = 4e-7;
// Lines shorter than this fraction of the smaller triangle's size are contacts at a corner.
constexpr double shortest_line = 1e-6;
// Both triangles' segments are on one line unless rounding turned one of them; as the sine.
constexpr double askew = 1e-3;

// Largest rounding error of a corner, by axis: a floor of kilometres is exactly level, and a small
// object that stands in it must not count as coplanar with it.
struct Rounding {
  glm::dvec3 of_coordinates;

  // Returns the rounding error of a distance along n, in units of n's length.
  [[nodiscard]] double along(glm::dvec3 n) const { return glm::dot(glm::abs(n), of_coordinates); }
};

// Returns the largest extent of a triangle's box along an axis.
double size_of(const TriangleCorners& t) {
  const glm::dvec3 d = glm::max(t[0], glm::max(t[1], t[2])) - glm::min(t[0], glm::min(t[1], t[2]));
  return std::max({d.x, d.y, d.z});
}

Rounding rounding_of(const TriangleCorners& s, const TriangleCorners& t, glm::dvec3 origin,
                     double size) {
  glm::dvec3 largest(0.0);
  for (int i = 0; i < 3; ++i) largest = glm::max(largest, glm::max(glm::abs(s[i]), glm::abs(t[i])));
  return {on_plane * (largest + glm::abs(origin) + size)};
}

// Returns the triangle's normal, of any length, independent of the winding: its largest coordinate
// is positive.
glm::dvec3 unwound_normal(const TriangleCorners& t) {
  const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const glm::dvec3 size = glm::abs(n);
  const int largest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return n[largest] < 0.0 ? -n : n;
}

// Returns the segment of `t` on the plane of `other`. A corner on the plane counts as being on its
// positive side, so that two triangles that meet on the plane cross it once together.
std::optional<LineSegment> crossing(const TriangleCorners& t, const TriangleCorners& other,
                                    const Rounding& rounding) {
  const glm::dvec3 n = unwound_normal(other);
  const double nothing = rounding.along(n);
  double d[3];
  int negative = 0;
  for (int i = 0; i < 3; ++i) {
    d[i] = glm::dot(n, t[i] - other[0]);
    if (std::abs(d[i]) <= nothing) d[i] = 0.0;
    negative += d[i] < 0.0;
  }
  if (negative == 0 || negative == 3) return std::nullopt;
  glm::dvec3 found[2];
  int count = 0;
  for (int i = 0; i < 3 && count < 2; ++i) {
    const int j = (i + 1) % 3;
    if ((d[i] < 0.0) == (d[j] < 0.0)) continue;
    found[count++] = t[i] + (t[j] - t[i]) * (d[i] / (d[i] - d[j]));
  }
  return LineSegment{found[0], found[1]};
}

}  // namespace

std::optional<LineSegment> common_line(const TriangleCorners& s, const TriangleCorners& t,
                                       glm::dvec3 origin) {
  const double size = std::min(size_of(s), size_of(t));
  const Rounding rounding = rounding_of(s, t, origin, size);
  const std::optional<LineSegment> x = crossing(s, t, rounding);
  if (!x) return std::nullopt;
  const std::optional<LineSegment> y = crossing(t, s, rounding);
  if (!y) return std::nullopt;
  // The common part of the two segments is the intersection.
  const glm::dvec3 d = x->q - x->p;
  const double square = glm::dot(d, d);
  if (!(square > 0.0)) return std::nullopt;
  const glm::dvec3 e = y->q - y->p;
  if (glm::length(glm::cross(d, e)) > askew * std::sqrt(square) * glm::length(e))
    return std::nullopt;
  double y0 = glm::dot(y->p - x->p, d) / square;
  double y1 = glm::dot(y->q - x->p, d) / square;
  glm::dvec3 p0 = y->p, p1 = y->q;
  if (y0 > y1) {
    std::swap(y0, y1);
    std::swap(p0, p1);
  }
  const double length = (std::min(y1, 1.0) - std::max(y0, 0.0)) * std::sqrt(square);
  if (length <= shortest_line * size) return std::nullopt;
  return LineSegment{y0 > 0.0 ? p0 : x->p, y1 < 1.0 ? p1 : x->q};
}

}  // namespace asos
