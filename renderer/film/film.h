#pragma once

#include "renderer/film/layers.h"
#include "renderer/film/split_cause.h"
#include "renderer/film/split_prediction_data.h"
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
  /// Deepest level n: the pixel's finest cells are 1/2^n pixels wide. Cuts of a cell along an edge
  /// add no level, nor do samples, nor levels of reflected or shadow pyrays.
  std::vector<std::uint8_t> split_level;
  std::vector<SplitCause> cause;  ///< why it is split; only by ASOS
  /// The cost of each pixel: the rays of all kinds cast for it, and the processor time of its
  /// worker in seconds. If only the cost of several pixels together was measured, it is divided
  /// evenly. Empty: unknown, as in coarse passes.
  std::vector<float> rays;
  std::vector<float> seconds;
  /// The fraction of each pixel that surfaces cover, 0 to 1, if the background is transparent;
  /// `radiance` is then that of the surfaces alone. Empty: all is covered.
  std::vector<float> coverage;
  /// Predicts the level of each pixel for another EPS and MAX. ASOS only; empty: unknown.
  std::vector<SplitPredictionData> outlook;
  /// xyz: the contribution of directly visible unlit surfaces to each pixel, included in
  /// `radiance`; w: the fraction of the pixel that they cover, 0 to 1. They are displayed without
  /// exposure and tone curve: see `tone_mapped`. Empty: no surface is unlit.
  std::vector<glm::vec4> unlit;
  std::vector<LayerPlane> layers;  ///< those that the settings ask for and that have a plane
  bool coarse = false;             ///< better pixels follow
};

/// Copies the common pixels of two tiles of one picture. Costs, coverage and unlit parts are copied
/// if `to` has them. If `from` has none, they become 0, 1 and 0. Layers are copied if both tiles
/// have them.
void copy_pixels(const FinishedTile& from, FinishedTile& to);

/// A whole picture: linear radiance, the split map by level and by cause, and the cost of each
/// pixel, 0 if unknown; row-major from the top left.
struct Film {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> radiance;
  std::vector<std::uint8_t> split_level;
  std::vector<SplitCause> cause;
  /// The number of samples that the split map shows, at most 65,535; 0: none, or unknown.
  std::vector<std::uint16_t> samples;
  std::vector<float> rays;
  std::vector<float> seconds;
  std::vector<float> coverage;               ///< as a tile's; empty until a tile has it
  std::vector<SplitPredictionData> outlook;  ///< as a tile's; empty until a tile has it
  std::vector<glm::vec4> unlit;              ///< by id; "": none
  std::vector<LayerPlane> layers;            ///< by id; "": none
  /// 1 where no final pixel has come yet, while the window renders. Empty: all are final.
  std::vector<std::uint8_t> unfinished;

  Film() = default;
  Film(int w, int h);
  /// Copies a tile into the picture, without the part outside of it.
  void put(const FinishedTile& tile);
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// The number of samples that the split map shows of a pixel.
[[nodiscard]] std::uint16_t shown_count(const SplitPredictionData& pixel);

/// Returns the display intensity, 0 to 1: exposure in stops, clip at white, sRGB curve. See tone.h
/// for tone curves, and for the intensity that stopping rules use.
[[nodiscard]] glm::vec3 display_rgb(glm::vec3 radiance, float exposure_ev);
/// Returns the display intensity as rounded bytes, fast enough for whole pictures. NaN becomes
/// black.
[[nodiscard]] glm::u8vec3 display_bytes(glm::vec3 radiance, float exposure_ev);

/// Returns the split map's colour of a pixel: sRGB bytes, brighter for deeper levels, the same for
/// any MAX. Level 0 is black if the pixel is not split, and `exact_colour` if it has a cause: it
/// was cut along an edge without being divided into quarters.
[[nodiscard]] glm::u8vec3 split_colour(int level, SplitCause cause = SplitCause::none);
inline constexpr glm::u8vec3 exact_colour{150, 110, 160};
/// The colour of undivided pixels that are the mean of samples.
inline constexpr glm::u8vec3 sampled_colour{196, 116, 66};
/// The deepest level with a colour of its own.
inline constexpr int split_colour_levels = 8;
}  // namespace asos
