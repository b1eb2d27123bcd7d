#pragma once

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// A rectangle as seen from a point, and the map from the unit square onto it that keeps solid
/// angles (Urena, Fajardo and King 2013, "An Area-Preserving Parametrization for Spherical
/// Rectangles").
class SphericalRectangle {
 public:
  /// `middle` relative to the point, which does not lie in the rectangle's plane; the halves at
  /// right angles.
  SphericalRectangle(glm::dvec3 middle, glm::dvec3 half_u, glm::dvec3 half_v)
      : SphericalRectangle(middle, half_u, half_v, {}) {}
  /// Only a rectangle of it, with the same axes, around what lies above the planes through the
  /// point with these normals; all of it where nothing does.
  SphericalRectangle(glm::dvec3 middle, glm::dvec3 half_u, glm::dvec3 half_v,
                     std::span<const glm::dvec3> horizons);

  /// Steradians. Good to about 1e-15 in all, so that of a rectangle that looks small few digits
  /// are left.
  [[nodiscard]] double solid_angle() const { return solid_angle_; }
  /// The point, relative, for u along half_u and v along half_v, both in 0..1.
  [[nodiscard]] glm::dvec3 point(double u, double v) const;

 private:
  void keep_above(glm::dvec3 normal);

  glm::dvec3 x_axis_, y_axis_, z_axis_;  ///< the rectangle lies at a negative z
  double x0_, x1_, y0_, y1_, z_;
  double b0_, b1_, k_, solid_angle_;
};

}  // namespace asos
