#include "renderer/comparison/disk_area.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {

namespace {

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

// Returns the signed area of the sector of the disk around the origin from a to b.
double sector(glm::dvec2 a, glm::dvec2 b, double radius) {
  return 0.5 * radius * radius * std::atan2(cross(a, b), glm::dot(a, b));
}

// Returns the signed area of the intersection of the disk with the triangle of the origin, p and q:
// the sum over the pieces of p q inside and outside of the circle.
double with_triangle(glm::dvec2 p, glm::dvec2 q, double radius) {
  const glm::dvec2 d = q - p;
  const double a = glm::dot(d, d), b = glm::dot(p, d), c = glm::dot(p, p) - radius * radius;
  std::array<double, 4> at{0.0, 0.0, 1.0, 1.0};  // the ends of the pieces
  const double root2 = b * b - a * c;
  if (a > 0.0 && root2 > 0.0) {
    const double root = std::sqrt(root2);
    at[1] = std::clamp((-b - root) / a, 0.0, 1.0);
    at[2] = std::clamp((-b + root) / a, 0.0, 1.0);
  } else {
    at[1] = at[2] = 1.0;  // no piece is inside
  }
  double area = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(at[i + 1] > at[i])) continue;
    const glm::dvec2 from = p + at[i] * d, to = p + at[i + 1] * d;
    area += i == 1 ? 0.5 * cross(from, to) : sector(from, to, radius);
  }
  return area;
}

}  // namespace

double area_in_disk(const ConvexPolygon& polygon, glm::dvec2 centre, double radius) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += with_triangle(polygon[i] - centre, polygon[(i + 1) % polygon.size()] - centre, radius);
  return std::abs(area);
}

}  // namespace asos
