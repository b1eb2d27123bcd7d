#include "renderer/lights/lit_texels.h"

#include "renderer/world/texture_image.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

constexpr std::size_t texels_a_block = 8;  // along its sides

std::size_t blocks_along(int texels) {
  return (static_cast<std::size_t>(texels) + texels_a_block - 1) / texels_a_block;
}

/// Adds a row to the brightest byte of each column.
void add_brightest(const std::uint8_t* rgba, std::size_t width,
                   std::uint8_t* __restrict brightest) {
  for (std::size_t x = 0; x < width; ++x)
    brightest[x] = std::max({brightest[x], rgba[4 * x], rgba[4 * x + 1], rgba[4 * x + 2]});
}

}  // namespace

LitTexels::LitTexels(const World& world, int texture) {
  const Image* const image = image_of(world, texture);
  if (!image) return;
  const Texture& t = world.textures[static_cast<std::size_t>(texture)];
  u_ = {image->width, t.wrap_u};
  v_ = {image->height, t.wrap_v};
  // The upper byte of 16-bit texels is rounded down.
  const std::uint8_t least = image->low.empty() ? black : black - 1;
  const auto width = static_cast<std::size_t>(image->width);
  const auto height = static_cast<std::size_t>(image->height);
  columns_ = blocks_along(image->width);
  const std::size_t rows = blocks_along(image->height);
  sums_.resize((columns_ + 1) * (rows + 1));
  std::vector<std::uint8_t> brightest(columns_ * texels_a_block);
  for (std::size_t row = 0; row < rows; ++row) {
    std::fill(brightest.begin(), brightest.end(), std::uint8_t{0});
    for (std::size_t y = texels_a_block * row; y < std::min(texels_a_block * (row + 1), height);
         ++y)
      add_brightest(image->rgba.data() + 4 * width * y, width, brightest.data());
    std::uint32_t along = 0;
    for (std::size_t x = 0; x < columns_; ++x) {
      const auto* const first = &brightest[texels_a_block * x];
      along += *std::max_element(first, first + texels_a_block) > least ? 1u : 0u;
      sums_[(row + 1) * (columns_ + 1) + x + 1] = sum(x + 1, row) + along;
    }
  }
}

// Returns the blocks between two coordinates. If the texture repeats in between, they are all.
LitTexels::Blocks LitTexels::blocks_of(const Axis& axis, double low, double high) {
  // One texel for the neighbours of a bilinear look-up, one for rounding.
  constexpr double margin = 2.0;
  const Blocks all{0, blocks_along(axis.texels)};
  const double size = axis.texels;
  double first = low * size - margin, last = high * size + margin;
  if (axis.wrap == Wrap::clamp_to_edge) {
    first = std::clamp(first, 0.0, size - 1.0);
    last = std::clamp(last, 0.0, size - 1.0);
  } else {
    const double turn = std::floor(low);
    first -= turn * size;
    last -= turn * size;
    if (!(first >= 0.0 && last < size)) return all;
    const bool mirrored = axis.wrap == Wrap::mirrored_repeat && std::fmod(turn, 2.0) != 0.0;
    if (mirrored) {
      std::swap(first, last);
      first = std::max(0.0, size - 1.0 - first);
      last = std::max(0.0, size - 1.0 - last);
    }
  }
  return {static_cast<std::size_t>(first) / texels_a_block,
          std::min(all.end, static_cast<std::size_t>(last) / texels_a_block + 1)};
}

bool LitTexels::any(glm::vec2 low, glm::vec2 high) const {
  // Single precision is exact to a texel up to here.
  constexpr float largest = 256.0f;
  if (sums_.empty()) return true;
  if (!(std::max({-low.x, -low.y, high.x, high.y}) < largest)) return true;
  const Blocks x = blocks_of(u_, static_cast<double>(low.x), static_cast<double>(high.x));
  const Blocks y = blocks_of(v_, static_cast<double>(low.y), static_cast<double>(high.y));
  return sum(x.end, y.end) + sum(x.begin, y.begin) > sum(x.begin, y.end) + sum(x.end, y.begin);
}

}  // namespace asos
