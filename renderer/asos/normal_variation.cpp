#include "renderer/asos/normal_variation.h"

#include <algorithm>
#include <cstddef>

namespace asos {

void NormalVariation::find(int side, std::span<const glm::vec3> normals,
                           std::span<const std::uint32_t> surfaces) {
  side_ = side;
  normals_.assign(normals.begin(), normals.end());
  surfaces_.assign(surfaces.begin(), surfaces.end());
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
