#include "renderer/published/cone_detection.h"

#include <algorithm>
#include <cmath>

namespace asos {

ConeDetection::ConeDetection(const Frame& frame)
    : parallel_(frame.parallel()),
      a_(frame.base_u()),
      b_(frame.base_v()),
      c_(frame.base_corner()),
      direction_(frame.direction()) {}

ConeDetection::Cone ConeDetection::around(const Square& cell) const {
  const glm::dvec3 to_centre =
      static_cast<double>(cell.centre_u()) * a_ + static_cast<double>(cell.centre_v()) * b_;
  Cone cone;
  cone.centre = parallel_ ? glm::dvec3(0.0) : c_ + to_centre;
  cone.axis = parallel_ ? direction_ : glm::normalize(cone.centre);
  const double half = 0.5 * static_cast<double>(cell.side);
  for (const glm::dvec2 corner :
       {glm::dvec2(1, 1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(-1, -1)}) {
    const glm::dvec3 e = half * (corner.x * a_ + corner.y * b_);
    const glm::dvec3 across = glm::cross(e, cone.axis);
    const glm::dvec3 d = cone.centre + e;
    const double across2 = glm::dot(across, across);
    if (parallel_) {
      cone.radius2 = std::max(cone.radius2, across2);
    } else {
      cone.sine2 = std::max(cone.sine2, across2 / glm::dot(d, d));
    }
  }
  return cone;
}

// The cone cuts the frame's plane in an ellipse A x^2 + 2 B x y + C y^2 + 2 D x + 2 E y + F <= 0
// about the cell's centre. Returns its bounding rectangle in closed form.
Square ConeDetection::reach(const Square& cell) const {
  const Cone cone = around(cell);
  const glm::dvec3 am = glm::cross(a_, cone.axis), bm = glm::cross(b_, cone.axis);
  const double s = cone.sine2;
  const double a = glm::dot(am, am) - s * glm::dot(a_, a_);
  const double b = glm::dot(am, bm) - s * glm::dot(a_, b_);
  const double c = glm::dot(bm, bm) - s * glm::dot(b_, b_);
  const double d = -s * glm::dot(cone.centre, a_);
  const double e = -s * glm::dot(cone.centre, b_);
  const double f = -s * glm::dot(cone.centre, cone.centre) - cone.radius2;
  const double det = a * c - b * b;
  const double x = (b * e - c * d) / det;
  const double y = (b * d - a * e) / det;
  const double k = std::max(0.0, -(f + d * x + e * y));
  const double half_u = std::abs(x) + std::sqrt(k * c / det);
  const double half_v = std::abs(y) + std::sqrt(k * a / det);
  // A cone that cuts the plane in a hyperbola occurs only around pyrays of over 90 degrees.
  const double half = det > 0.0 ? std::max(half_u, half_v) : 2.0 * static_cast<double>(cell.side);
  const auto widened = static_cast<float>(half * (1.0 + 1e-6));
  return {cell.centre_u() - widened, cell.centre_v() - widened, 2.0f * widened};
}

// Tests the minimum of |e x axis|^2 - sine2 |d + e|^2 along the segment: a quadratic.
bool ConeDetection::near(const Segment& s, const Square& cell) const {
  const Cone cone = around(cell);
  const auto offset = [&](float u, float v) {
    return (static_cast<double>(u) - static_cast<double>(cell.centre_u())) * a_ +
           (static_cast<double>(v) - static_cast<double>(cell.centre_v())) * b_;
  };
  const glm::dvec3 e0 = offset(s.u0, s.v0);
  const glm::dvec3 de = offset(s.u1, s.v1) - e0;
  const glm::dvec3 p = glm::cross(e0, cone.axis), q = glm::cross(de, cone.axis);
  const glm::dvec3 d0 = cone.centre + e0;
  const double c0 = glm::dot(p, p) - cone.sine2 * glm::dot(d0, d0) - cone.radius2;
  const double c1 = glm::dot(p, q) - cone.sine2 * glm::dot(d0, de);
  const double c2 = glm::dot(q, q) - cone.sine2 * glm::dot(de, de);
  const double t = c2 > 0.0 ? std::clamp(-c1 / c2, 0.0, 1.0) : (2.0 * c1 + c2 < 0.0 ? 1.0 : 0.0);
  return c0 + t * (2.0 * c1 + t * c2) < 0.0;
}

}  // namespace asos
