#pragma once

#include "renderer/shading/footprint.h"
#include "renderer/shading/mip_chain.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

// Textures averaged over the footprint of what a sample stands for: the integral over a
// parallelogram (TexelWindow), in a level of a mip chain that is much finer.

namespace asos {

/// A point of a triangle and what it stands for.
struct TexturePlace {
  std::uint32_t triangle = 0;
  float b1 = 0.0f;
  float b2 = 0.0f;
  Footprint footprint;
};

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

/// What texels mean where they are looked up.
struct TexelUse {
  TexelKind kind = TexelKind::color;
  /// Of colours that alpha cuts: the alpha from which on they are seen. Nothing: alpha blends them.
  std::optional<float> cutoff = std::nullopt;
};

/// A texture's mean over the footprint, in linear light; of colours that alpha blends or cuts, that
/// of what is seen, or of all where nothing is. `sample_texture`'s value to the last bit
/// where the footprint is a point, is no larger than least_footprint, lies in one nearest texel, or
/// is not finite; as point samples from there on where `mips` lacks the chain.
[[nodiscard]] glm::vec4 filtered_texture(const World& world, const MipChains& mips,
                                         const TextureUse& use, const TexelUse& texels,
                                         const TexturePlace& place);

/// A normal map's mean, as unsigned as its texels and of any length, and the variance about it that
/// the footprint averages away: the mean squared distance of its unit normals from their mean, 0 to
/// 1; 0 where it is a point.
struct MeanNormal {
  glm::vec3 texel{0.5f, 0.5f, 1.0f};
  float variance = 0.0f;
};
[[nodiscard]] MeanNormal filtered_normal(const World& world, const MipChains& mips,
                                         const TextureUse& use, const TexturePlace& place);

}  // namespace asos
