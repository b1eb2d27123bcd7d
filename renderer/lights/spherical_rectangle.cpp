#include "renderer/lights/spherical_rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {

using std::numbers::pi;

namespace {

// Clips the interval to where the line slope t + rest is positive, unless nothing would be left.
void keep_positive(double slope, double rest, double& low, double& high) {
  const double end = -rest / slope;
  if (!(end > low && end < high)) return;
  (slope > 0.0 ? low : high) = end;
}

}  // namespace

SphericalRectangle::SphericalRectangle(glm::dvec3 middle, glm::dvec3 half_u, glm::dvec3 half_v,
                                       std::span<const glm::dvec3> horizons) {
  const double u = glm::length(half_u);
  const double v = glm::length(half_v);
  x_axis_ = half_u / u;
  y_axis_ = half_v / v;
  z_axis_ = glm::cross(x_axis_, y_axis_);
  const double x = glm::dot(middle, x_axis_);
  const double y = glm::dot(middle, y_axis_);
  z_ = glm::dot(middle, z_axis_);
  if (z_ > 0.0) {
    z_ = -z_;
    z_axis_ = -z_axis_;
  }
  x0_ = x - u;
  x1_ = x + u;
  y0_ = y - v;
  y1_ = y + v;
  for (const glm::dvec3& normal : horizons) keep_above(normal);

  // Compute the z of the unit normals of the planes through the point and a side, and the angles
  // between neighbouring planes.
  const double n0 = -y0_ / std::sqrt(z_ * z_ + y0_ * y0_);
  const double n1 = x1_ / std::sqrt(z_ * z_ + x1_ * x1_);
  const double n2 = y1_ / std::sqrt(z_ * z_ + y1_ * y1_);
  const double n3 = -x0_ / std::sqrt(z_ * z_ + x0_ * x0_);
  b0_ = n0;
  b1_ = n2;
  k_ = 2.0 * pi - std::acos(-n2 * n3) - std::acos(-n3 * n0);
  solid_angle_ = std::acos(-n0 * n1) + std::acos(-n1 * n2) - k_;
}

void SphericalRectangle::keep_above(glm::dvec3 normal) {
  const double nx = glm::dot(normal, x_axis_), ny = glm::dot(normal, y_axis_);
  const double by_z = z_ * glm::dot(normal, z_axis_);
  keep_positive(ny, by_z + std::max(x0_ * nx, x1_ * nx), y0_, y1_);
  keep_positive(nx, by_z + std::max(y0_ * ny, y1_ * ny), x0_, x1_);
}

glm::dvec3 SphericalRectangle::point(double u, double v) const {
  const double angle = u * solid_angle_ + k_;
  const double sine = std::sin(angle);
  // At the end of a rectangle that fills half of all directions, the quotient would be 0 / 0.
  const double at_end = u < 0.5 ? -0.0 : 0.0;
  const double f = sine != 0.0 ? (std::cos(angle) * b0_ - b1_) / sine : at_end;
  const double c = std::clamp(std::copysign(1.0 / std::sqrt(f * f + b0_ * b0_), f), -1.0, 1.0);
  // At u = 0 and 1 the quotient rounds to either side of the rectangle's ends.
  const double x = std::clamp(-c * z_ / std::sqrt((1.0 - c) * (1.0 + c)), x0_, x1_);

  const double d = std::sqrt(x * x + z_ * z_);
  const double h0 = y0_ / std::sqrt(d * d + y0_ * y0_);
  const double h1 = y1_ / std::sqrt(d * d + y1_ * y1_);
  const double h = h0 + v * (h1 - h0);
  const double y = std::clamp(h * d / std::sqrt((1.0 - h) * (1.0 + h)), y0_, y1_);
  return x * x_axis_ + y * y_axis_ + z_ * z_axis_;
}

}  // namespace asos
