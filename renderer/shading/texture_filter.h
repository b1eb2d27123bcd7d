#pragma once

#include "renderer/shading/footprint.h"
#include "renderer/shading/mip_chain.h"
#include "renderer/shading/texel_means.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

// Averages textures over a sample's footprint: the integral over a parallelogram (TexelWindow), in
// a level of a mip chain that is much finer than the footprint.

namespace asos {

/// A point of a triangle with its footprint.
struct TexturePlace {
  std::uint32_t triangle = 0;
  float b1 = 0.0f;
  float b2 = 0.0f;
  Footprint footprint;
};

/// The meaning of texels in a lookup.
struct TexelUse {
  TexelKind kind = TexelKind::color;
  /// For colours with a cut-off: the least alpha at which they are visible. Nothing: alpha blends
  /// them.
  std::optional<float> cutoff = std::nullopt;
};

/// Returns a texture's mean over the footprint, in linear light. With alpha blending or cut-off, it
/// is the mean of the visible part, or of everything if nothing is visible. It equals
/// `sample_texture`, bit for bit, where the footprint is a point, smaller than a quarter of a
/// texel, within one nearest texel, or not finite. It is point-sampled if `mips` lacks the chain.
[[nodiscard]] glm::vec4 filtered_texture(const World& world, const MipChains& mips,
                                         const TextureUse& use, const TexelUse& texels,
                                         const TexturePlace& place);

/// Returns a normal map's mean over a footprint.
[[nodiscard]] MeanNormal filtered_normal(const World& world, const MipChains& mips,
                                         const TextureUse& use, const TexturePlace& place);

}  // namespace asos
