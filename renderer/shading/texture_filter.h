#pragma once

#include "renderer/shading/footprint.h"
#include "renderer/shading/mip_chain.h"

#include <glm/glm.hpp>

#include <cstdint>

// Textures averaged over the footprint of what a sample stands for: trilinear taps along the
// footprint's longer axis (as hardware does; McCormack et al. 1999, "Feline").

namespace asos {

/// A point of a triangle and what it stands for.
struct TexturePlace {
  std::uint32_t triangle = 0;
  float b1 = 0.0f;
  float b2 = 0.0f;
  Footprint footprint;
};

/// Taps at most along a footprint; longer ones are widened until these cover them.
inline constexpr int most_taps = 16;

/// The side of the texels that average a footprint of side 1. A bilinear tap of texels of side s
/// has a variance of s^2 / 4 about its place (its tent's s^2 / 6 and the texel's own s^2 / 12), a
/// box of side w has w^2 / 12: equal for s = w / sqrt(3).
inline constexpr float texel_share = 0.57735027f;

/// A texture's mean over the footprint, in linear light. `sample_texture`'s value to the last bit
/// where the footprint is a point, is smaller than a texel, or is not finite; as point samples from
/// there on where `mips` lacks the chain.
[[nodiscard]] glm::vec4 filtered_texture(const World& world, const MipChains& mips,
                                         const TextureUse& use, TexelKind kind,
                                         const TexturePlace& place);

/// A normal map's mean, as unsigned as its texels and of any length, and the variance about it that
/// the footprint averages away: the mean squared distance of its unit normals from their mean, 0 to
/// 1; 0 where the footprint is smaller than a texel.
struct MeanNormal {
  glm::vec3 texel{0.5f, 0.5f, 1.0f};
  float variance = 0.0f;
};
[[nodiscard]] MeanNormal filtered_normal(const World& world, const MipChains& mips,
                                         const TextureUse& use, const TexturePlace& place);

}  // namespace asos
