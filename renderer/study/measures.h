#pragma once

#include "renderer/film/film.h"
#include "renderer/study/regions.h"

#include <array>
#include <cstddef>
#include <vector>

namespace asos {

/// The difference between two pictures. Radiance is linear and clipped to 0..1, as on a display at
/// exposure 0, except for `rmse_raw`. A pixel's own error is the root mean square over its three
/// channels. NaN counts as white or black, whichever is farther, and makes `rmse_raw` infinite, so
/// that it is always noticed.
struct Measures {
  double rmse = 0.0;          ///< root mean square, over pixels and channels
  double rmse_raw = 0.0;      ///< root mean square without clipping
  double mae = 0.0;           ///< mean absolute, over pixels and channels
  double p99 = 0.0;           ///< of pixel errors: 99th percentile by nearest rank
  double p999 = 0.0;          ///< 99.9th percentile
  double max = 0.0;           ///< the worst pixel's error
  double rmse_display = 0.0;  ///< root mean square after the sRGB curve
  double perceptual = 0.0;    ///< mean CIEDE2000 over pixels
};

/// Returns how far `a` is above `b`, channel by channel, both clipped to 0..1. NaN in `a` counts as
/// white or black, whichever is farther.
[[nodiscard]] glm::dvec3 clipped_difference(glm::vec3 a, glm::vec3 b);

/// Returns the mean of the three channels' squared differences, `clipped` to 0..1 or not.
[[nodiscard]] double squared_error(glm::vec3 a, glm::vec3 b, bool clipped);

/// Returns the root of the mean squared error over all pixels and channels.
[[nodiscard]] double root_mean_square(const Film& film, const Film& reference, bool clipped);

/// Both films have the same size, which is not 0.
[[nodiscard]] Measures measure(const Film& film, const Film& reference);

/// The contribution of one region to a picture's error.
struct RegionError {
  std::size_t pixels = 0;
  double rmse = 0.0;   ///< clipped, over the region's pixels
  double share = 0.0;  ///< of the whole picture's squared error, 0 to 1
};
using RegionErrors = std::array<RegionError, region_count>;
[[nodiscard]] RegionErrors region_errors(const Film& film, const Film& reference,
                                         const std::vector<Region>& regions);

}  // namespace asos
