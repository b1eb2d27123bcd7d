#pragma once

#include "renderer/shading/footprint.h"
#include "renderer/shading/mip_chain.h"

#include <glm/glm.hpp>

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

/// What texels mean where they are looked up.
struct TexelUse {
  TexelKind kind = TexelKind::color;
  /// Of colours that alpha cuts: the alpha from which on they are seen. Nothing: alpha blends them.
  std::optional<float> cutoff = std::nullopt;
};

/// A texture's mean over the footprint, in linear light; of colours that alpha blends or cuts, that
/// of what is seen, or of all where nothing is. `sample_texture`'s value to the last bit
/// where the footprint is a point, is no larger than a quarter of a texel, lies in one nearest
/// texel, or is not finite; as point samples from there on where `mips` lacks the chain.
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
