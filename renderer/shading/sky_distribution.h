#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace asos {

struct SkyRows;

/// A sampled direction with its density.
struct SkyDirection {
  glm::dvec3 direction{0.0, 1.0, 0.0};  ///< unit
  double density = 0.0;                 ///< per steradian
};

/// Samples directions in proportion to the radiance of a sky's picture (Pharr, Jakob, Humphreys,
/// "Physically Based Rendering", section 12.5): by texel, and evenly over each texel's solid angle.
class SkyDistribution {
 public:
  /// Uses rows whose texels are means over their solid angles. A black picture is sampled evenly
  /// over the sphere.
  explicit SkyDistribution(const SkyRows& rows);

  /// Returns the direction of a place in the unit square.
  [[nodiscard]] SkyDirection at(glm::dvec2 place) const;
  /// Returns the density of a unit direction, per steradian.
  [[nodiscard]] double density(glm::dvec3 direction) const;

 private:
  [[nodiscard]] double density_of(std::size_t texel, std::size_t row) const;

  std::vector<std::size_t> start_;   // of each row in texels, and the end
  std::vector<double> cumulative_;   // of all texels, in order; the last is 1
  std::vector<double> solid_angle_;  // of a texel of each row
};

}  // namespace asos
