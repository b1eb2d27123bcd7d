#pragma once

#include "renderer/film/rgbe.h"
#include "renderer/shading/sky_distribution.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace asos {

/// Texels of linear radiance: as floats, or packed as in a Radiance picture, which takes a third of
/// the memory for the same radiance.
class SkyTexels {
 public:
  SkyTexels() = default;
  SkyTexels(std::vector<glm::vec3> radiance) : radiance_(std::move(radiance)) {}
  /// The radiance is that of `packed` times `scale`.
  SkyTexels(std::vector<Rgbe> packed, glm::vec3 scale = glm::vec3(1.0f))
      : packed_(std::move(packed)), scale_(scale) {}

  [[nodiscard]] glm::vec3 operator[](std::size_t i) const {
    return packed_.empty() ? radiance_[i] : scale_ * radiance_of(packed_[i]);
  }
  [[nodiscard]] std::size_t size() const { return radiance_.size() + packed_.size(); }
  [[nodiscard]] std::size_t memory_bytes() const {
    return radiance_.capacity() * sizeof(glm::vec3) + packed_.capacity() * sizeof(Rgbe);
  }

  void reserve(std::size_t count) { radiance_.reserve(count); }
  void add(glm::vec3 radiance) { radiance_.push_back(radiance); }

 private:
  std::vector<glm::vec3> radiance_;
  std::vector<Rgbe> packed_;
  glm::vec3 scale_{1.0f};
};

/// A direction in an equirectangular picture: u in turns from its left edge, v from 0 at the zenith
/// to 1 at the nadir.
struct SkyPlace {
  double u = 0.0;
  double v = 0.0;
};
/// Returns the place of a unit direction.
[[nodiscard]] SkyPlace sky_place(glm::dvec3 direction);

/// Rows of texels from the zenith to the nadir. All rows have the same height in angle, and each
/// has its own number of columns. Column 0 starts at +Z and columns continue through -X. So the
/// centre of a row is -Z with +X on its right, as seen by a camera that looks along -Z.
struct SkyRows {
  std::vector<std::uint32_t> start;  ///< start of each row in texels, and the end
  SkyTexels texels;
  glm::dvec3 zenith{0.0};  ///< at v = 0; for a picture, the mean of the first row
  glm::dvec3 nadir{0.0};   ///< at v = 1

  [[nodiscard]] int rows() const { return static_cast<int>(start.size()) - 1; }
  [[nodiscard]] int columns(int row) const {
    const auto r = static_cast<std::size_t>(row);
    return static_cast<int>(start[r + 1] - start[r]);
  }
  [[nodiscard]] glm::vec3 texel(int row, int column) const {
    return texels[start[static_cast<std::size_t>(row)] + static_cast<std::size_t>(column)];
  }
  /// Returns the bilinear value at `u` turns (any number) and `v`, 0 at the zenith to 1 at the
  /// nadir. It interpolates across the seam, and between the poles and the rows next to them. NaN
  /// if a coordinate is not finite.
  [[nodiscard]] glm::vec3 at(double u, double v) const;
};

/// An equirectangular picture of all directions, and means of it over larger and larger patches.
/// The number of texels of each row makes them square on the sphere, not in the picture ("reduced
/// grids" of weather models). One size therefore fits all directions, and each texel is the exact
/// mean of its solid angle.
class SkyMap {
 public:
  /// `texels` are linear and finite radiance, row by row from the zenith down. `width` and `height`
  /// are at least 1, and their product fits 32 bits.
  SkyMap(int width, int height, SkyTexels texels);

  /// Returns the mean around a unit direction over a patch with sides of `side` radians; 0: a
  /// point.
  [[nodiscard]] glm::vec3 mean(glm::dvec3 direction, double side) const;

  /// Returns the means in the largest number of rows that is at most `rows`.
  [[nodiscard]] const SkyRows& rows_below(int rows) const;

  /// Returns the sampler of directions in proportion to radiance, with texels of half a degree. It
  /// is made at the first call; any thread.
  [[nodiscard]] const SkyDistribution& distribution() const;

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  [[nodiscard]] glm::vec3 level_at(std::size_t level, double u, double v) const;
  [[nodiscard]] glm::vec3 second_texel(int row, int column) const;

  // The picture, then rows of its height, half its height, ..., 1. A large picture's second level
  // is not stored: `polar_` has its rows near the poles. The others are means of few texels of the
  // picture and are computed on access.
  std::vector<SkyRows> levels_;
  SkyRows polar_;
  struct Distribution {
    std::once_flag once;
    std::optional<SkyDistribution> made;
  };
  std::unique_ptr<Distribution> distribution_;
};

}  // namespace asos
