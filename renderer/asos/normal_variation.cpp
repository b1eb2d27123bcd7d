#include "renderer/asos/normal_variation.h"

#include <algorithm>
#include <cstddef>

namespace asos {

void NormalVariation::find(int side, std::span<const glm::vec3> normals,
                           std::span<const std::uint32_t> surfaces, std::uint32_t background) {
  side_ = side;
  normals_.assign(normals.begin(), normals.end());
  surfaces_.assign(surfaces.begin(), surfaces.end());
  errors_.assign(normals.size(), 0.0f);
  if (side < 3) return;
  // `along` is the pixel's place on the axis on which neighbours are `step` apart.
  const auto second_difference = [&](int pixel, int along, int step) {
    // At the block's border, that of the next pixel.
    const int middle = pixel + step * (std::clamp(along, 1, side - 2) - along);
    const auto at = [&](int i) { return static_cast<std::size_t>(i); };
    const std::uint32_t surface = surfaces[at(pixel)];
    for (const int i : {middle - step, middle, middle + step})
      if (surfaces[at(i)] != surface) return 0.0f;
    return glm::length(normals[at(middle - step)] - 2.0f * normals[at(middle)] +
                       normals[at(middle + step)]);
  };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int i = y * side + x;
      if (surfaces[static_cast<std::size_t>(i)] != background)
        errors_[static_cast<std::size_t>(i)] =
            (second_difference(i, x, 1) + second_difference(i, y, side)) / 24.0f;
    }
  }
}

float NormalVariation::error(int x, int y) const {
  return holds(x, y) ? errors_[index(x, y)] : 0.0f;
}

float NormalVariation::strays(int x, int y, glm::vec3 right, glm::vec3 down) const {
  if (!holds(x, y) || side_ < 3) return 0.0f;
  const std::uint32_t surface = surfaces_[index(x, y)];
  // Of the neighbours to both sides, so that an even bend of the turn itself does not count; at the
  // block's border those of the next pixel.
  const auto strays = [&](glm::ivec2 middle, glm::ivec2 step, glm::vec3 turn) {
    const std::size_t before = index(middle.x - step.x, middle.y - step.y);
    const std::size_t after = index(middle.x + step.x, middle.y + step.y);
    if (surfaces_[before] != surface || surfaces_[after] != surface) return 0.0f;
    return glm::length(0.5f * (normals_[after] - normals_[before]) - turn);
  };
  const int inner_x = std::clamp(x, 1, side_ - 2), inner_y = std::clamp(y, 1, side_ - 2);
  return std::max(strays({inner_x, y}, {1, 0}, right), strays({x, inner_y}, {0, 1}, down));
}

}  // namespace asos
