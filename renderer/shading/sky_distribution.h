#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace asos {

struct SkyRows;

/// A direction, and how densely such are taken there.
struct SkyDirection {
  glm::dvec3 direction{0.0, 1.0, 0.0};  ///< unit
  double density = 0.0;                 ///< per steradian
};

/// Directions of a sky's picture, distributed as its radiance is (Pharr, Jakob, Humphreys,
/// "Physically Based Rendering", section 12.5): by texel, evenly over each one's solid angle.
class SkyDistribution {
 public:
  /// Of rows whose texels are means of their solid angles. Black all over: even over the sphere.
  explicit SkyDistribution(const SkyRows& rows);

  /// The direction of a place in the unit square.
  [[nodiscard]] SkyDirection at(glm::dvec2 place) const;
  /// The density of a unit direction, per steradian.
  [[nodiscard]] double density(glm::dvec3 direction) const;

 private:
  [[nodiscard]] double density_of(std::size_t texel, std::size_t row) const;

  std::vector<std::size_t> start_;   // of each row in texels, and the end
  std::vector<double> cumulative_;   // of all texels, in their order; the last is 1
  std::vector<double> solid_angle_;  // of a texel of each row
};

}  // namespace asos
