#include "renderer/scene/builtin/textures.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace asos::builtin {

namespace {

constexpr int texels = 512;

/// Returns a pseudo-random value, 0 to 1, for each point of a lattice.
double lattice_value(glm::uvec2 at, std::uint32_t seed) {
  std::uint32_t h = at.x * 0x9e3779b1u ^ at.y * 0x85ebca77u ^ seed * 0xc2b2ae3du;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return static_cast<double>(h ^ (h >> 15)) / 4294967296.0;
}

/// Smooth noise over the unit square, 0 to 1, from a repeating lattice of `cells` points.
double noise(glm::dvec2 uv, glm::uvec2 cells, std::uint32_t seed) {
  const glm::dvec2 p = glm::fract(uv) * glm::dvec2(cells), low = glm::floor(p), t = p - low;
  const glm::dvec2 blend = t * t * (3.0 - 2.0 * t);
  const glm::uvec2 a = glm::uvec2(low) % cells, b = (a + 1u) % cells;
  const double top = glm::mix(lattice_value(a, seed), lattice_value({b.x, a.y}, seed), blend.x);
  const double bottom = glm::mix(lattice_value({a.x, b.y}, seed), lattice_value(b, seed), blend.x);
  return glm::mix(top, bottom, blend.y);
}

/// The weighted mean of `noise` and two finer octaves, each of half the previous weight.
double rough_noise(glm::dvec2 uv, glm::uvec2 cells, std::uint32_t seed) {
  return (4.0 * noise(uv, cells, seed) + 2.0 * noise(uv, 2u * cells, seed + 1) +
          noise(uv, 4u * cells, seed + 2)) /
         7.0;
}

/// Makes an image from `colour` (0 to 1) at the centre of each texel.
template <typename Colour>
Image painted(const std::string& name, Colour colour) {
  Image image{name, texels, texels, {}};
  image.rgba.own().reserve(4ull * texels * texels);
  for (int y = 0; y < texels; ++y) {
    for (int x = 0; x < texels; ++x) {
      const glm::dvec3 rgb = colour(glm::dvec2(x + 0.5, y + 0.5) / static_cast<double>(texels));
      for (int c = 0; c < 3; ++c) {
        const double byte = std::round(255.0 * std::clamp(rgb[c], 0.0, 1.0));
        image.rgba.own().push_back(static_cast<std::uint8_t>(byte));
      }
      image.rgba.own().push_back(255);
    }
  }
  return image;
}

/// Returns the tangent-space normals of a height field in metres, on a square of side `metres`.
template <typename Height>
Image normals_of(const std::string& name, double metres, Height height) {
  return painted(name, [&](glm::dvec2 uv) {
    constexpr double step = 0.5 / texels;
    const glm::dvec2 u(step, 0.0), v(0.0, step);
    const double rise_u = height(uv + u) - height(uv - u), rise_v = height(uv + v) - height(uv - v);
    // Green points up the image, so against v.
    const glm::dvec3 normal(-rise_u, rise_v, 2.0 * step * metres);
    return 0.5 + 0.5 * glm::normalize(normal);
  });
}

/// A point in rows of boards that are as long as the image is wide.
struct Board {
  std::uint32_t row = 0;
  double along = 0.0;  ///< 0 to 1 from one joint to the next
  double down = 0.0;   ///< 0 to 1 from its upper edge
};

Board board_at(glm::dvec2 uv, int rows, std::uint32_t seed) {
  Board board;
  board.row = static_cast<std::uint32_t>(uv.y * rows);
  board.down = uv.y * rows - board.row;
  board.along = glm::fract(uv.x + lattice_value({board.row, 0}, seed));
  return board;
}

}  // namespace

Image wood_planks() {
  constexpr glm::dvec3 dark(0.42, 0.27, 0.15), light(0.80, 0.61, 0.40);
  return painted("wood planks", [&](glm::dvec2 uv) {
    const Board board = board_at(uv, 16, 7);
    if (board.down < 0.07 || board.along < 0.004) return 0.3 * dark;
    // The rings of a trunk, cut lengthwise: wavy bands along the plank, different for each plank.
    const glm::dvec2 place(board.along, uv.y);
    const double waver = rough_noise(place, {3, 24}, 11 + board.row);
    const double ring = glm::fract(3.0 * board.down + 4.0 * waver);
    const double streak = noise(place, {16, 256}, 50);
    const double tone = 0.8 + 0.3 * lattice_value({board.row, 1}, 7);
    return tone * glm::mix(dark, light, 0.3 + 0.45 * (1.0 - ring * ring) + 0.25 * streak);
  });
}

Image clapboards() {
  constexpr glm::dvec3 cream(0.93, 0.87, 0.71);
  return painted("clapboards", [&](glm::dvec2 uv) {
    const Board board = board_at(uv, 12, 3);
    if (board.down < 0.1) return 0.5 * cream;
    if (board.along < 0.003) return 0.6 * cream;
    const double tone = 0.93 + 0.06 * lattice_value({board.row, 1}, 3);
    const double grain = rough_noise({board.along, uv.y}, {8, 96}, 21) - 0.5;
    return (tone + 0.12 * grain) * cream;
  });
}

Image sand_normals(double metres) {
  // Heights in metres: wavy ripples across v, of varying height, and single grains.
  const auto height = [](glm::dvec2 uv) {
    const double waver = rough_noise(uv, {4, 4}, 5);
    const double ripple = std::sin(2.0 * std::numbers::pi * (20.0 * uv.y + 3.0 * waver));
    const double strength = 0.3 + 0.7 * noise(uv, {6, 6}, 9);
    return 0.007 * strength * ripple + 0.004 * noise(uv, {128, 128}, 13);
  };
  return normals_of("sand normals", metres, height);
}

Image hammered_normals(double metres) {
  // Heights in metres: overlapping dents, one in each cell of a lattice. The deepest dent
  // determines the height.
  constexpr int cells = 24;
  const double depth = 0.06 * metres / cells;
  const auto height = [depth](glm::dvec2 uv) {
    const glm::dvec2 p = uv * static_cast<double>(cells);
    const glm::ivec2 low(glm::floor(p));
    double deepest = 0.0;
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const glm::ivec2 cell = low + glm::ivec2(x, y);
        const glm::uvec2 at((cell + cells) % cells);
        const glm::dvec2 offset(lattice_value(at, 31), lattice_value(at, 32));
        const glm::dvec2 away = p - glm::dvec2(cell) - (0.2 + 0.6 * offset);
        const double radius = 0.75 + 0.2 * lattice_value(at, 33);
        deepest = std::max(deepest, 1.0 - glm::dot(away, away) / (radius * radius));
      }
    }
    return -depth * deepest;
  };
  return normals_of("hammered normals", metres, height);
}

Image brushed_normals(double metres) {
  // Heights in metres: scratches along u of many lengths, one texel wide.
  const double depth = 0.00035 * metres;
  const auto height = [depth](glm::dvec2 uv) {
    return depth * (noise(uv, {3, 128}, 61) + 0.7 * noise(uv, {7, 256}, 62) +
                    0.5 * noise(uv, {17, 256}, 63));
  };
  return normals_of("brushed normals", metres, height);
}

}  // namespace asos::builtin
