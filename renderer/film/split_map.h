#pragma once

#include "renderer/film/film.h"

#include <cstddef>
#include <cstdint>

namespace asos {

/// What the split map's colours tell of a pixel.
enum class SplitMapColours { level, cause };

/// How a split map is coloured, in the window and in files.
struct SplitMapKey {
  SplitMapColours colours = SplitMapColours::level;
  int max_level = 0;  ///< of the scale of levels

  /// What is told of a pixel: its level, or its cause's number.
  [[nodiscard]] std::uint8_t value(const Film& film, std::size_t pixel) const {
    return colours == SplitMapColours::cause ? static_cast<std::uint8_t>(film.cause[pixel])
                                             : film.split_level[pixel];
  }
  /// The colour of such a value, sRGB bytes: that of `split_cause_colour` or `split_colour`.
  [[nodiscard]] glm::u8vec3 colour(std::uint8_t value) const {
    return colours == SplitMapColours::cause ? split_cause_colour(static_cast<SplitCause>(value))
                                             : split_colour(value, max_level);
  }
};

}  // namespace asos
