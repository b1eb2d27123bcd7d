#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/mip_levels.h"
#include "renderer/shading/texel_window.h"
#include "renderer/shading/texture.h"

#include <algorithm>
#include <cstddef>

// Selects the level of a mip chain for a footprint, and the footprint's place in it.

namespace asos {

/// The resolution at which a footprint is sampled. It grows with the footprint's size in the
/// picture.
struct TexelBudget {
  float across = 8.0f;   ///< smallest width in texels, if the finest level has that many
  float most = 1024.0f;  ///< largest number of texels; longer footprints use coarser levels
  static constexpr float fewest = 16.0f;  ///< `most` is at least this

  /// Returns the budget for a footprint that a square of `side` pixels covers.
  [[nodiscard]] static TexelBudget of(float side) {
    const TexelBudget whole;
    const float share = side < 1.0f ? side : 1.0f;
    return {std::max(1.0f, share * whole.across), std::max(fewest, share * share * whole.most)};
  }
};
/// Up to this size, in texels, the footprint of a bilinear texture is treated as a point.
inline constexpr float least_footprint = 0.25f;
/// The same of nearest texels, which have sharp borders, however large they appear in the picture.
/// Places closer than this do not differ in large textures.
inline constexpr float least_nearest_footprint = 1e-4f;
/// Shorter edges are invisible; this length keeps areas above 0.
inline constexpr float thinnest_patch = 1.0f / 32.0f;
/// Longer edges make no difference, since every texture repeats along them. Their fourth powers are
/// still finite.
inline constexpr float longest_patch_edge = 1e9f;

/// Returns the size of a level of an image, relative to the image.
[[nodiscard]] inline glm::vec2 scale_of_level(std::size_t level, int width, int height) {
  return {static_cast<float>(side_of_level(width, level)) / static_cast<float>(width),
          static_cast<float>(side_of_level(height, level)) / static_cast<float>(height)};
}

/// A level, 0 being the image itself, and a patch of its texels.
struct LevelPatch {
  std::size_t level = 0;
  TexelPatch patch;

  [[nodiscard]] bool point() const { return patch.right == glm::vec2(0.0f); }
};

/// Selects the level for `patch`, given in the finest level's texels. `levels` is the number of
/// coarser ones. Bilinear patches no longer
/// than least_footprint become points. Coarser levels are used while the patch stays wide enough,
/// or contains too many texels.
[[nodiscard]] LevelPatch patch_in(std::size_t levels, const Image& image, Filter filter,
                                  TexelPatch patch, TexelBudget budget);

/// Converts a patch of the finest level to level 1.
[[nodiscard]] LevelPatch coarser(const LevelPatch& patch, const Texels& finest);

}  // namespace asos
