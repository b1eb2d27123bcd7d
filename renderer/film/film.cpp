#include "renderer/film/film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace asos {
namespace {

float srgb_encode(float linear) {
  // The comparison is also false for NaN, which has no display intensity and shows as black.
  if (!(linear > 0.0f)) return 0.0f;
  if (linear >= 1.0f) return 1.0f;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// The rounded bytes of the sRGB curve without its power function: for each byte the smallest
/// linear value that rounds to it, and for 4096 steps of the linear scale the byte to start from.
struct ByteCurve {
  static constexpr int steps = 4096;
  std::array<float, 257> threshold{};
  std::array<std::uint8_t, steps + 1> start{};

  ByteCurve() {
    for (int byte = 1; byte < 256; ++byte) {
      const double encoded = (byte - 0.5) / 255.0;
      const double linear =
          encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
      threshold[static_cast<std::size_t>(byte)] = static_cast<float>(linear);
    }
    threshold[256] = std::numeric_limits<float>::infinity();
    std::size_t byte = 0;
    for (int i = 0; i <= steps; ++i) {
      const float linear = static_cast<float>(i) / steps;
      while (linear >= threshold[byte + 1]) ++byte;
      start[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(byte);
    }
  }

  [[nodiscard]] std::uint8_t operator()(float linear) const {
    if (!(linear > 0.0f)) return 0;
    if (linear >= 1.0f) return 255;
    std::size_t byte = start[static_cast<std::size_t>(linear * steps)];
    while (linear >= threshold[byte + 1]) ++byte;
    return static_cast<std::uint8_t>(byte);
  }
};

const ByteCurve byte_curve;

}  // namespace

Film::Film(int w, int h)
    : width(std::max(w, 0)),
      height(std::max(h, 0)),
      radiance(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), glm::vec3(0.0f)),
      split_level(radiance.size(), 0),
      cause(radiance.size(), SplitCause::none),
      rays(radiance.size(), 0.0f),
      seconds(radiance.size(), 0.0f) {}

void Film::put(const FinishedTile& tile) {
  // What lies outside the picture is left out; a tile whose arrays are too short is not a tile.
  if (tile.rect.empty()) return;
  const auto tile_width = static_cast<std::size_t>(tile.rect.width);
  const std::size_t pixels = tile_width * static_cast<std::size_t>(tile.rect.height);
  if (tile.radiance.size() < pixels || tile.split_level.size() < pixels ||
      tile.cause.size() < pixels)
    return;
  const int x0 = std::max(tile.rect.x, 0);
  const int x1 = std::min(tile.rect.x + tile.rect.width, width);
  const int y0 = std::max(tile.rect.y, 0);
  const int y1 = std::min(tile.rect.y + tile.rect.height, height);
  if (x0 >= x1) return;
  for (int y = y0; y < y1; ++y) {
    const auto from =
        static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y - tile.rect.y) * tile_width +
                                    static_cast<std::size_t>(x0 - tile.rect.x));
    const auto to = static_cast<std::ptrdiff_t>(index(x0, y));
    std::copy_n(tile.radiance.begin() + from, x1 - x0, radiance.begin() + to);
    std::copy_n(tile.split_level.begin() + from, x1 - x0, split_level.begin() + to);
    std::copy_n(tile.cause.begin() + from, x1 - x0, cause.begin() + to);
    for (const auto& [told, kept] : {std::pair(&tile.rays, &rays), {&tile.seconds, &seconds}}) {
      if (told->size() < pixels) {
        std::fill_n(kept->begin() + to, x1 - x0, 0.0f);
      } else {
        std::copy_n(told->begin() + from, x1 - x0, kept->begin() + to);
      }
    }
  }
}

glm::vec3 display_rgb(glm::vec3 radiance, float exposure_ev) {
  const glm::vec3 exposed = radiance * std::exp2(exposure_ev);
  return {srgb_encode(exposed.x), srgb_encode(exposed.y), srgb_encode(exposed.z)};
}

glm::u8vec3 display_bytes(glm::vec3 radiance, float exposure_ev) {
  const glm::vec3 exposed = radiance * std::exp2(exposure_ev);
  return {byte_curve(exposed.x), byte_curve(exposed.y), byte_curve(exposed.z)};
}

glm::u8vec3 split_colour(int level, int max_level) {
  if (level <= 0 || max_level <= 0) return {0, 0, 0};
  // Viridis without its darkest quarter, which is hard to tell from black: perceptually ordered,
  // and readable for the colour-blind.
  constexpr std::array<glm::vec3, 4> scale{glm::vec3(59, 82, 139), glm::vec3(33, 145, 140),
                                           glm::vec3(94, 201, 98), glm::vec3(253, 231, 37)};
  const float t = max_level == 1 ? 3.0f
                                 : 3.0f * static_cast<float>(std::min(level, max_level) - 1) /
                                       static_cast<float>(max_level - 1);
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(t), 2);
  const glm::vec3 mixed = glm::mix(scale[below], scale[below + 1], t - static_cast<float>(below));
  return glm::u8vec3(mixed + 0.5f);
}

}  // namespace asos
