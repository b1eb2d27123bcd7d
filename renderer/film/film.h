#pragma once

#include "renderer/film/split_cause.h"
#include "renderer/film/split_outlook.h"
#include "renderer/geometry/pixel_rect.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

/// A finished part of a picture, as a worker publishes it. Arrays are row-major, rect.width *
/// rect.height long.
struct FinishedTile {
  PixelRect rect;
  std::vector<glm::vec3> radiance;        ///< linear
  std::vector<std::uint8_t> split_level;  ///< deepest level that the pixel split to; 0: not split
  std::vector<SplitCause> cause;          ///< why; methods other than ASOS tell none
  /// The cost of each pixel: the rays of all kinds that were cast for it, and the seconds of its
  /// worker's processor. A cost that pixels share, in the smallest piece that is measured, is
  /// spread over them evenly. Empty: not known, as of coarse passes.
  std::vector<float> rays;
  std::vector<float> seconds;
  /// The share of each pixel that surfaces cover, 0 to 1: where the background is transparent, and
  /// `radiance` is theirs alone. Empty: all is covered.
  std::vector<float> coverage;
  /// Predicts the level of each pixel under another EPS and MAX. ASOS only; empty: not known.
  std::vector<SplitOutlook> outlook;
  /// What unlit surfaces that the eye sees add to each pixel, in xyz, which `radiance` contains;
  /// and the share of the pixel that they cover, 0 to 1, in w. They are shown as they are: see
  /// `tone_mapped`. Empty: no surface is unlit.
  std::vector<glm::vec4> unlit;
  bool coarse = false;  ///< better pixels follow
};

/// Copies the pixels that two tiles of one picture share. Their cost is only copied where `to`
/// keeps it, as 0 where `from` does not tell it; so is their coverage, as 1, and what is unlit, as
/// 0.
void copy_pixels(const FinishedTile& from, FinishedTile& to);

/// A whole picture: linear radiance, the split map by level and by cause, and what each pixel cost,
/// 0 where that is not told; row-major from the top left.
struct Film {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> radiance;
  std::vector<std::uint8_t> split_level;
  std::vector<SplitCause> cause;
  std::vector<float> rays;
  std::vector<float> seconds;
  std::vector<float> coverage;        ///< as a tile's; empty until a tile tells any
  std::vector<SplitOutlook> outlook;  ///< as a tile's; empty until a tile tells any
  std::vector<glm::vec4> unlit;       ///< the same

  Film() = default;
  Film(int w, int h);
  /// Copies a tile in; what lies outside the picture is left out.
  void put(const FinishedTile& tile);
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// Display intensity, 0 to 1: exposure in stops, clip at white, sRGB curve. By a tone curve, and
/// what stopping rules judge: tone.h.
[[nodiscard]] glm::vec3 display_rgb(glm::vec3 radiance, float exposure_ev);
/// The same as bytes, rounded; fast enough for whole pictures. A value that is not a number shows
/// as black.
[[nodiscard]] glm::u8vec3 display_bytes(glm::vec3 radiance, float exposure_ev);

/// The split map's colour of a level on the absolute scale 0..max_level: sRGB bytes, brighter for
/// deeper levels. Level 0 (not split) is black and no other level is: an overlay leaves its pixels
/// out. A level above max_level has max_level's colour.
[[nodiscard]] glm::u8vec3 split_colour(int level, int max_level);

}  // namespace asos
