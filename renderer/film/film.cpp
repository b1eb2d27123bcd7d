#include "renderer/film/film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace asos {
namespace {

float srgb_encode(float linear) {
  // The comparison is also false for NaN, which has no display intensity and is displayed as black.
  if (!(linear > 0.0f)) return 0.0f;
  if (linear >= 1.0f) return 1.0f;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// A table of the sRGB curve rounded to bytes, which avoids its power function: for each byte the
/// smallest linear value that rounds to it, and for 4096 steps of the linear scale the first byte
/// to try.
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

std::size_t pixels_of(const PixelRect& rect) {
  return static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
}

/// Calls `f` for each row that two rectangles share, with its start in both and its length.
template <typename F>
void each_shared_row(const PixelRect& a, const PixelRect& b, const F& f) {
  const PixelRect shared = intersection(a, b);
  for (int y = shared.y; y < shared.y + shared.height; ++y) {
    const auto index = [&](const PixelRect& r) {
      return static_cast<std::ptrdiff_t>(y - r.y) * r.width + (shared.x - r.x);
    };
    f(index(a), index(b), shared.width);
  }
}

template <typename T>
void copy_shared(const std::vector<T>& from, const PixelRect& from_rect, std::vector<T>& to,
                 const PixelRect& to_rect) {
  each_shared_row(from_rect, to_rect, [&](std::ptrdiff_t begin, std::ptrdiff_t into, int count) {
    std::copy_n(from.begin() + begin, count, to.begin() + into);
  });
}

// Missing values become `otherwise`.
template <typename T>
void copy_told(const std::vector<T>& from, const PixelRect& from_rect, std::vector<T>& to,
               const PixelRect& to_rect, const T& otherwise) {
  if (from.size() >= pixels_of(from_rect)) return copy_shared(from, from_rect, to, to_rect);
  each_shared_row(from_rect, to_rect, [&](std::ptrdiff_t, std::ptrdiff_t into, int count) {
    std::fill_n(to.begin() + into, count, otherwise);
  });
}

void put_samples(const FinishedTile& tile, Film& film) {
  const PixelRect inside = intersection(tile.rect, {0, 0, film.width, film.height});
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    for (int x = inside.x; x < inside.x + inside.width; ++x) {
      const auto from =
          static_cast<std::size_t>(y - tile.rect.y) * static_cast<std::size_t>(tile.rect.width) +
          static_cast<std::size_t>(x - tile.rect.x);
      film.samples[film.index(x, y)] =
          from < tile.outlook.size() ? shown_count(tile.outlook[from]) : std::uint16_t{0};
    }
  }
}

void copy_costs(const std::vector<float>& from, const PixelRect& from_rect, std::vector<float>& to,
                const PixelRect& to_rect) {
  copy_told(from, from_rect, to, to_rect, 0.0f);
}

}  // namespace

void copy_pixels(const FinishedTile& from, FinishedTile& to) {
  copy_shared(from.radiance, from.rect, to.radiance, to.rect);
  copy_shared(from.split_level, from.rect, to.split_level, to.rect);
  copy_shared(from.cause, from.rect, to.cause, to.rect);
  if (!to.rays.empty()) copy_costs(from.rays, from.rect, to.rays, to.rect);
  if (!to.seconds.empty()) copy_costs(from.seconds, from.rect, to.seconds, to.rect);
  if (!to.coverage.empty()) copy_told(from.coverage, from.rect, to.coverage, to.rect, 1.0f);
  if (!to.outlook.empty()) copy_told(from.outlook, from.rect, to.outlook, to.rect, {});
  if (!to.unlit.empty()) copy_told(from.unlit, from.rect, to.unlit, to.rect, glm::vec4(0.0f));
  copy_planes(from.layers, from.rect, to.layers, to.rect);
}

std::uint16_t shown_count(const SplitPredictionData& pixel) {
  return static_cast<std::uint16_t>(std::min(pixel.samples, std::uint32_t{0xffff}));
}

Film::Film(int w, int h)
    : width(std::max(w, 0)),
      height(std::max(h, 0)),
      radiance(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), glm::vec3(0.0f)),
      split_level(radiance.size(), 0),
      cause(radiance.size(), SplitCause::none),
      samples(radiance.size(), 0),
      rays(radiance.size(), 0.0f),
      seconds(radiance.size(), 0.0f) {}

void Film::put(const FinishedTile& tile) {
  // Skips pixels outside the picture, and tiles whose arrays are too short.
  if (tile.rect.empty()) return;
  const std::size_t pixels = pixels_of(tile.rect);
  if (tile.radiance.size() < pixels || tile.split_level.size() < pixels ||
      tile.cause.size() < pixels)
    return;
  const PixelRect whole{0, 0, width, height};
  copy_shared(tile.radiance, tile.rect, radiance, whole);
  copy_shared(tile.split_level, tile.rect, split_level, whole);
  copy_shared(tile.cause, tile.rect, cause, whole);
  if (!tile.coarse) put_samples(tile, *this);
  copy_costs(tile.rays, tile.rect, rays, whole);
  copy_costs(tile.seconds, tile.rect, seconds, whole);
  if (!tile.coverage.empty() && coverage.empty()) coverage.assign(radiance.size(), 1.0f);
  if (!coverage.empty()) copy_told(tile.coverage, tile.rect, coverage, whole, 1.0f);
  if (!tile.outlook.empty() && outlook.empty()) outlook.resize(radiance.size());
  if (!outlook.empty()) copy_told(tile.outlook, tile.rect, outlook, whole, {});
  if (!tile.unlit.empty() && unlit.empty()) unlit.assign(radiance.size(), glm::vec4(0.0f));
  if (!unlit.empty()) copy_told(tile.unlit, tile.rect, unlit, whole, glm::vec4(0.0f));
  for (const LayerPlane& plane : tile.layers)
    if (!find_plane(layers, plane.layer)) layers.emplace_back(plane.layer, radiance.size());
  copy_planes(tile.layers, tile.rect, layers, whole);
}

glm::vec3 display_rgb(glm::vec3 radiance, float exposure_ev) {
  const glm::vec3 exposed = radiance * std::exp2(exposure_ev);
  return {srgb_encode(exposed.x), srgb_encode(exposed.y), srgb_encode(exposed.z)};
}

glm::u8vec3 display_bytes(glm::vec3 radiance, float exposure_ev) {
  const glm::vec3 exposed = radiance * std::exp2(exposure_ev);
  return {byte_curve(exposed.x), byte_curve(exposed.y), byte_curve(exposed.z)};
}

glm::u8vec3 split_colour(int level, SplitCause cause) {
  if (level <= 0) return cause == SplitCause::none ? glm::u8vec3(0) : exact_colour;
  // Viridis without its darkest quarter, which is hard to distinguish from black: perceptually
  // ordered, and readable for colour-blind people.
  constexpr std::array<glm::vec3, 4> scale{glm::vec3(59, 82, 139), glm::vec3(33, 145, 140),
                                           glm::vec3(94, 201, 98), glm::vec3(253, 231, 37)};
  const float t = 3.0f * static_cast<float>(std::min(level, split_colour_levels) - 1) /
                  static_cast<float>(split_colour_levels - 1);
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(t), 2);
  const glm::vec3 mixed = glm::mix(scale[below], scale[below + 1], t - static_cast<float>(below));
  return glm::u8vec3(mixed + 0.5f);
}

}  // namespace asos
