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
  // `along` is the pixel's coordinate on the axis on which neighbours are `step` apart.
  const auto second_difference = [&](int pixel, int along, int step) {
    // At the block's border, use the difference at the next pixel inside.
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
  if (!holds(x, y)) return 0.0f;
  const std::size_t middle = index(x, y);
  float most = 0.0f;
  const auto look = [&](int column, int row, glm::vec3 turn) {
    if (!holds(column, row) || surfaces_[index(column, row)] != surfaces_[middle]) return;
    most = std::max(most, glm::length(normals_[index(column, row)] - normals_[middle] - turn));
  };
  look(x + 1, y, right);
  look(x - 1, y, -right);
  look(x, y + 1, down);
  look(x, y - 1, -down);
  return most;
}

}  // namespace asos
