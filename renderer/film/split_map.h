#pragma once

#include "renderer/film/film.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace asos {

/// The property of a pixel that the split map's colours show: the deepest level, why it was split,
/// the rays that were cast for it, and the time that it took.
enum class SplitMapColours { level, cause, rays, time };

/// The absolute scales of rays and time: logarithmic, from the first to the last.
struct CostScale {
  double first;
  double last;
  /// 0 at `first` or below, 1 at `last` or above.
  [[nodiscard]] double share(double value) const;
};
inline constexpr CostScale rays_scale{1.0, 4096.0};
inline constexpr CostScale seconds_scale{1e-7, 1e-2};  ///< seconds of one processor
[[nodiscard]] const CostScale& cost_scale(SplitMapColours colours);

/// Black at 0 over violet and orange to white at 1 and above, ever brighter: sRGB bytes.
[[nodiscard]] glm::u8vec3 heat_colour(float share);

/// How a split map is coloured, in the window and in files.
struct SplitMapKey {
  SplitMapColours colours = SplitMapColours::level;

  /// The value shown of a pixel: 1 if it is exact and one more than its level if it is deeper; its
  /// cause's number; or where on the scale of 1 to 255 its cost lies. 0: not split or not known,
  /// and black.
  [[nodiscard]] std::uint8_t value(const Film& film, std::size_t pixel) const;
  /// The largest that has a colour of its own.
  [[nodiscard]] std::uint8_t last() const;
  /// The colour of such a value, sRGB bytes.
  [[nodiscard]] glm::u8vec3 colour(std::uint8_t value) const;
};

/// The level and cause of a pixel in words: "not split", "exact, silhouette", "level 3, shading".
[[nodiscard]] std::string split_words(int level, SplitCause cause);

}  // namespace asos
