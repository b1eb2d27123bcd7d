#pragma once

#include "renderer/film/layers.h"
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
  std::vector<glm::vec3> radiance;  ///< linear
  /// Deepest level n: the pixel's finest cells, or as many samples, are 1/2^n pixels wide. Cutting
  /// a cell along an edge adds none, nor do levels of mirrored or shadow pyrays.
  std::vector<std::uint8_t> split_level;
  std::vector<SplitCause> cause;  ///< why it is split; methods other than ASOS tell none
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
  std::vector<LayerPlane> layers;  ///< those that the settings ask for and that have a plane
  bool coarse = false;             ///< better pixels follow
};

/// Copies the pixels that two tiles of one picture share. Their cost is only copied where `to`
/// keeps it, as 0 where `from` does not tell it; so is their coverage, as 1, and what is unlit, as
/// 0. Layers are copied where both have them.
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
  std::vector<LayerPlane> layers;     ///< the same
  /// 1 where no final pixel has come yet, while the window renders. Empty: all are final.
  std::vector<std::uint8_t> unfinished;

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

/// The split map's colour of a pixel: sRGB bytes, brighter for deeper levels, the same at any MAX.
/// Level 0 is black where the pixel is not split, and `exact_colour` where it has a cause: it was
/// cut along an edge without being divided into quarters.
[[nodiscard]] glm::u8vec3 split_colour(int level, SplitCause cause = SplitCause::none);
inline constexpr glm::u8vec3 exact_colour{150, 110, 160};
/// The deepest level that has a colour of its own.
inline constexpr int split_colour_levels = 8;
}  // namespace asos
