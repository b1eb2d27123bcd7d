#pragma once

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// A rectangle as seen from a point, with a map from the unit square onto it that preserves solid
/// angles (Urena, Fajardo and King 2013, "An Area-Preserving Parametrization for Spherical
/// Rectangles").
class SphericalRectangle {
 public:
  /// `middle` is the centre relative to the point, which must not lie in the rectangle's plane. The
  /// half edges are perpendicular.
  SphericalRectangle(glm::dvec3 middle, glm::dvec3 half_u, glm::dvec3 half_v)
      : SphericalRectangle(middle, half_u, half_v, {}) {}
  /// Restricts the rectangle to a smaller one with the same axes, around its part above the planes
  /// through the point with these normals. If no part is above, uses all of it.
  SphericalRectangle(glm::dvec3 middle, glm::dvec3 half_u, glm::dvec3 half_v,
                     std::span<const glm::dvec3> horizons);

  /// Returns the solid angle in steradians. Its absolute error is about 1e-15, so small solid
  /// angles have few digits.
  [[nodiscard]] double solid_angle() const { return solid_angle_; }
  /// Returns the point for u along half_u and v along half_v, both in 0..1, relative to the viewer.
  [[nodiscard]] glm::dvec3 point(double u, double v) const;

 private:
  void keep_above(glm::dvec3 normal);

  glm::dvec3 x_axis_, y_axis_, z_axis_;  ///< the rectangle is at a negative z
  double x0_, x1_, y0_, y1_, z_;
  double b0_, b1_, k_, solid_angle_;
};

}  // namespace asos
