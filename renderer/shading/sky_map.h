#pragma once

#include "renderer/shading/sky_distribution.h"
#include "renderer/shading/sky_texels.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace asos {

/// A direction in an equirectangular picture: turns from its left edge, and 0 at the zenith to 1 at
/// the nadir.
struct SkyPlace {
  double u = 0.0;
  double v = 0.0;
};
/// Of a unit direction.
[[nodiscard]] SkyPlace sky_place(glm::dvec3 direction);

/// Rows of texels from the zenith to the nadir, all of the same height in angle and each divided
/// into columns of its own number. Column 0 starts at +Z and they go on by way of -X, so that the
/// middle of a row is -Z and right of it is +X, as a camera that looks along -Z sees them.
struct SkyRows {
  std::vector<std::uint32_t> start;  ///< of each row in texels, and the end
  SkyTexels texels;
  glm::dvec3 zenith{0.0};  ///< at v = 0; of a picture, the mean of the first row
  glm::dvec3 nadir{0.0};   ///< at v = 1

  [[nodiscard]] int rows() const { return static_cast<int>(start.size()) - 1; }
  [[nodiscard]] int columns(int row) const {
    const auto r = static_cast<std::size_t>(row);
    return static_cast<int>(start[r + 1] - start[r]);
  }
  [[nodiscard]] glm::vec3 texel(int row, int column) const {
    return texels[start[static_cast<std::size_t>(row)] + static_cast<std::size_t>(column)];
  }
  /// The bilinear mean at `u` turns (any number) and `v`, 0 at the zenith to 1 at the nadir: across
  /// the seam, and between the poles and the rows next to them. NaN where they are not finite.
  [[nodiscard]] glm::vec3 at(double u, double v) const;
};

/// An equirectangular picture of all directions, and means of it over ever larger patches. Their
/// rows have as many texels as make them square on the sphere, not in the picture ("reduced
/// grids" of weather models), so that one size fits all directions, and each is the exact mean of
/// its solid angle.
class SkyMap {
 public:
  /// `texels`: linear radiance, finite, row by row from the zenith down; `width` and `height` at
  /// least 1, their product at most that of 32-bit numbers.
  SkyMap(int width, int height, SkyTexels texels);

  /// The mean around a unit direction of a patch whose sides are `side` radians; 0: a point.
  [[nodiscard]] glm::vec3 mean(glm::dvec3 direction, double side) const;

  /// Irradiance over pi of a surface with this unit normal that sees half of the sky.
  [[nodiscard]] glm::vec3 irradiance_over_pi(glm::dvec3 normal) const;

  /// Directions as its light comes from them, within texels of half a degree.
  [[nodiscard]] const SkyDistribution& distribution() const { return *distribution_; }

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  [[nodiscard]] glm::vec3 level_at(std::size_t level, double u, double v) const;
  [[nodiscard]] glm::vec3 second_texel(int row, int column) const;

  // The picture; then rows of its height, half its height, ..., 1. Of a large picture the second
  // has no texels of its own: `polar_` has those of its rows near the poles, the others, means of
  // few texels of the picture, are made where they are looked at.
  std::vector<SkyRows> levels_;
  SkyRows polar_;
  SkyRows irradiance_;  // over pi, by normal
  std::optional<SkyDistribution> distribution_;
};

}  // namespace asos
