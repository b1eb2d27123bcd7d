#pragma once

#include "renderer/film/film.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace asos {

/// The property of pixels that the split map displays: the deepest level, the cause of the split,
/// the rays cast, or the time.
enum class SplitMapColours { level, cause, rays, time };

/// The absolute scales of rays and time: logarithmic, from `first` to `last`.
struct CostScale {
  double first;
  double last;
  /// Returns the position on the scale: 0 at `first` or below, 1 at `last` or above.
  [[nodiscard]] double share(double value) const;
};
inline constexpr CostScale rays_scale{1.0, 4096.0};
inline constexpr CostScale seconds_scale{1e-7, 1e-2};  ///< seconds of one processor
[[nodiscard]] const CostScale& cost_scale(SplitMapColours colours);

/// Returns the colour for a position, with rising brightness: black at 0, then violet and orange,
/// white at 1 and above; sRGB bytes.
[[nodiscard]] glm::u8vec3 heat_colour(float share);

/// The colours of a split map, in the window and in files.
struct SplitMapKey {
  SplitMapColours colours = SplitMapColours::level;

  /// Returns the displayed value of a pixel. Level: 1 if it is exact, 2 if it is sampled without
  /// being divided, level + 2 if it is divided.
  /// Cause: its number. Cost: 1 to 255 on the scale. 0 (black): not split, or unknown.
  [[nodiscard]] std::uint8_t value(const Film& film, std::size_t pixel) const;
  /// Returns the largest value with a colour of its own.
  [[nodiscard]] std::uint8_t last() const;
  /// Returns the colour of a displayed value, sRGB bytes.
  [[nodiscard]] glm::u8vec3 colour(std::uint8_t value) const;
};

/// Returns level, number of samples and cause of a pixel in words: "not split", "exact,
/// silhouette", "16 samples, shading", "level 3, shadow", "level 1, 12 samples, shadow".
/// `samples` 0: it is not sampled, or the method does not count them.
[[nodiscard]] std::string split_words(int level, SplitCause cause, std::uint32_t samples);
/// The same words for a pixel of a film.
[[nodiscard]] std::string split_words(const Film& film, std::size_t pixel);

}  // namespace asos
