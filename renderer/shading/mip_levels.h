#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The meaning of an image's texels, which determines how they are averaged.
enum class TexelKind {
  color,   ///< sRGB with linear alpha: averaged as light
  cover,   ///< the same with an alpha that cuts or blends: colours are weighted by alpha
  data,    ///< four independent linear values
  normal,  ///< directions of a normal map; the mean is shorter than 1, and the rest is variance
};
inline constexpr std::size_t texel_kinds = 4;

/// An image averaged over boxes of 2^level by 2^level texels, or the nearest to that in whole
/// texels. The image's borders stay in place, whatever the size.
struct MipLevel {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> rgba;  ///< linear, 0 to 65535; see `at` for normals

  /// Returns a texel. For normals, xyz is the mean, encoded like the map's bytes, and w is the
  /// variance: the mean squared distance from the mean, 0 to 1. Both are those of a bilinear
  /// look-up with unit normals.
  [[nodiscard]] glm::vec4 at(int x, int y) const {
    const std::uint16_t* p = texel(x, y);
    return glm::vec4(p[0], p[1], p[2], p[3]) * unit;
  }

  static constexpr float unit = 1.0f / 65535.0f;
  [[nodiscard]] const std::uint16_t* texel(int x, int y) const {
    return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x));
  }
};

/// Returns the number of levels after the image itself, down to a single texel; 0 for images of one
/// texel or none.
[[nodiscard]] std::size_t mip_levels_of(const Image& image);

/// Returns a level's width, or height, from the image's.
[[nodiscard]] inline int side_of_level(int side, std::size_t level) {
  return std::max(1, side >> level);
}

/// Returns levels 1, 2, ... of an image. Averages have 16 bits, so that dark ones stay exact.
[[nodiscard]] std::vector<MipLevel> make_mip_levels(const Image& image, TexelKind kind);

}  // namespace asos
