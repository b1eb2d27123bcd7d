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

  /// Returns the budget for a footprint that a square of `side` pixels covers.
  [[nodiscard]] static TexelBudget of(float side) {
    const TexelBudget whole;
    const float share = side < 1.0f ? side : 1.0f;
    return {std::max(1.0f, share * whole.across), std::max(16.0f, share * share * whole.most)};
  }
};
/// Up to this size, in texels, the footprint of a bilinear texture is treated as a point.
inline constexpr float least_footprint = 0.25f;

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
