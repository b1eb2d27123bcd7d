#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/mip_chain.h"
#include "renderer/shading/texel_window.h"
#include "renderer/shading/texture.h"

#include <algorithm>
#include <cstddef>

// In which level of a mip chain a footprint is looked at, and where it lies there.

namespace asos {

/// How finely a footprint is looked at: the finer, the more of the picture it is.
struct TexelBudget {
  float across = 8.0f;   ///< texels that it is wide at least, where it has so many
  float most = 1024.0f;  ///< texels that count for it, at most; those of longer ones are coarser

  /// The budget for a footprint that is seen through a square of `side` pixels.
  [[nodiscard]] static TexelBudget of(float side) {
    const TexelBudget whole;
    const float share = side < 1.0f ? side : 1.0f;
    return {std::max(1.0f, share * whole.across), std::max(16.0f, share * share * whole.most)};
  }
};
/// Sides, in texels, up to which a footprint is a point of a bilinear texture.
inline constexpr float least_footprint = 0.25f;

/// A level, 0 being the image itself, and a patch of its texels.
struct LevelPatch {
  std::size_t level = 0;
  TexelPatch patch;

  [[nodiscard]] bool point() const { return patch.right == glm::vec2(0.0f); }
};

/// Of `patch`, in the finest level's texels: a point where it is no longer than least_footprint.
/// Coarser levels are taken while it stays wide enough, or holds too many.
[[nodiscard]] LevelPatch patch_in(const MipChain& chain, const Image& image, Filter filter,
                                  TexelPatch patch, TexelBudget budget);

/// The same patch of the finest level, in the next one.
[[nodiscard]] LevelPatch coarser(const LevelPatch& patch, const MipChain& chain,
                                 const Texels& finest);

}  // namespace asos
