#include "renderer/shading/cube_sky.h"

#include "renderer/shading/texture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace asos {
namespace {

/// The linear texels of one side of a cube.
struct LinearSide {
  int size = 0;
  std::vector<glm::vec3> texels;

  explicit LinearSide(const EnvironmentCube::Side& side) : size(side.image.width) {
    const auto& rgba = side.image.rgba.get();
    texels.reserve(rgba.size() / 4);
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
      glm::vec3 c(srgb_byte_to_linear(rgba[i]), srgb_byte_to_linear(rgba[i + 1]),
                  srgb_byte_to_linear(rgba[i + 2]));
      if (side.divided) c *= rgba[i + 3] > 0 ? 255.0f / static_cast<float>(rgba[i + 3]) : 0.0f;
      texels.push_back(c);
    }
  }

  [[nodiscard]] glm::vec3 texel(int x, int y) const {
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, size - 1));
    const auto column = static_cast<std::size_t>(std::clamp(x, 0, size - 1));
    return texels[row * static_cast<std::size_t>(size) + column];
  }
  /// Returns the bilinear value at a place from 0 to 1 to the right and down.
  [[nodiscard]] glm::vec3 at(double right, double down) const {
    const double x = right * size - 0.5, y = down * size - 0.5;
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    const auto u = static_cast<float>(x - x0), v = static_cast<float>(y - y0);
    return glm::mix(glm::mix(texel(x0, y0), texel(x0 + 1, y0), u),
                    glm::mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), u), v);
  }
};

/// Returns the radiance from a direction in the cube's own axes.
glm::vec3 shown(const std::vector<LinearSide>& sides, glm::dvec3 d) {
  const glm::dvec3 size = glm::abs(d);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const bool negative = d[axis] < 0.0;
  // Right and up, from a camera in the centre that looks at that side.
  glm::dvec3 right, up(0, 1, 0);
  if (axis == 0) {
    right = {0, 0, negative ? -1 : 1};
  } else if (axis == 2) {
    right = {negative ? 1 : -1, 0, 0};
  } else {
    right = {-1, 0, 0};
    up = {0, 0, negative ? 1 : -1};
  }
  const double scale = 0.5 / size[axis];
  const auto side = static_cast<std::size_t>(2 * axis + (negative ? 1 : 0));
  return sides[side].at(0.5 + scale * glm::dot(d, right), 0.5 - scale * glm::dot(d, up));
}

}  // namespace

SkyMap sky_map_of(const EnvironmentCube& surroundings) {
  constexpr int widest = 4096;
  const std::vector<LinearSide> sides(surroundings.sides.begin(), surroundings.sides.end());
  const int width = std::clamp(4 * sides.front().size, 4, widest), height = width / 2;
  const glm::dmat3 cube_from_world = glm::transpose(surroundings.world_from_cube);
  std::vector<glm::vec3> texels;
  texels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      glm::vec3 sum(0.0f);
      for (const double dy : {0.25, 0.75}) {
        for (const double dx : {0.25, 0.75}) {
          // As in SkyRows, column 0 is at +Z and columns continue through -X.
          const double turn = 2.0 * std::numbers::pi * (x + dx) / width;
          const double fall = std::numbers::pi * (y + dy) / height;
          const glm::dvec3 d(-std::sin(turn) * std::sin(fall), std::cos(fall),
                             std::cos(turn) * std::sin(fall));
          sum += shown(sides, cube_from_world * d);
        }
      }
      texels.push_back(0.25f * surroundings.intensity * sum);
    }
  }
  return {width, height, std::move(texels)};
}

}  // namespace asos
