#pragma once

#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
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

/// Levels 1, 2, ... of an image down to a single texel; level 0 is the image itself. Averages have
/// 16 bits, so that dark ones stay exact. Empty for images of one texel or none.
using MipChain = std::vector<MipLevel>;
[[nodiscard]] MipChain make_mip_chain(const Image& image, TexelKind kind);

/// The chains of a world's images, for each kind of use by a material on a triangle. A small value:
/// copies share the chains.
class MipChains {
 public:
  MipChains() = default;
  /// `known`: the chains of a world with the same images, which are reused; null: none.
  MipChains(const World& world, const RenderFeatures& render_features,
            const MipChains* known = nullptr);

  /// Returns the chain, which is empty if no material uses `image` as `kind`.
  [[nodiscard]] const MipChain& chain(int image, TexelKind kind) const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  using Shared = std::shared_ptr<const MipChain>;        // null: not used
  std::vector<std::array<Shared, texel_kinds>> chains_;  // by image
};

/// Returns the kind of a material's base colour texture.
[[nodiscard]] TexelKind base_color_kind(const Material& material);
/// Returns the kind of a material's emissive texture. If that is also the base colour's texture,
/// whose alpha is coverage, its emission is weighted by alpha, too.
[[nodiscard]] TexelKind emissive_kind(const Material& material);

}  // namespace asos
