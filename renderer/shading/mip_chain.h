#pragma once

#include "renderer/world/needs.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace asos {

/// The meaning of an image's texels, and so of their mean.
enum class TexelKind {
  color,   ///< sRGB with linear alpha: averaged as light
  cover,   ///< the same where alpha cuts or blends: colours count by their alpha
  data,    ///< four independent linear values
  normal,  ///< a normal map's directions; the mean is shorter than 1, and the rest is variance
};
inline constexpr std::size_t texel_kinds = 4;

/// An image averaged over boxes of 2^level by 2^level texels, or what comes nearest to that in
/// whole texels: the borders never move, whatever the size.
struct MipLevel {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> rgba;  ///< linear, of 65535; see MipChain for normals

  /// For normals (x, y, z) as in the map, unsigned like its bytes, and the variance around them:
  /// the mean squared distance from the mean, 0 to 1; both of what a bilinear look-up shows, as
  /// unit normals.
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

/// Levels 1, 2, ... of an image down to a single texel; level 0 is the image itself. Averages are
/// kept to 16 bits, so that dark ones stay exact. Empty for images of one texel or none.
using MipChain = std::vector<MipLevel>;
[[nodiscard]] MipChain make_mip_chain(const Image& image, TexelKind kind);

/// The chains of a world's images, each in the kinds that materials on triangles use it as. A small
/// value: copies share the chains.
class MipChains {
 public:
  MipChains() = default;
  /// `known`: those of a world with the same images, which are not made again; null: none.
  MipChains(const World& world, const SceneNeeds& needs, const MipChains* known = nullptr);

  /// Empty where nothing uses `image` as `kind`.
  [[nodiscard]] const MipChain& chain(int image, TexelKind kind) const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  using Shared = std::shared_ptr<const MipChain>;        // null: nothing uses it
  std::vector<std::array<Shared, texel_kinds>> chains_;  // by image
};

/// The kind of a material's base colour texture.
[[nodiscard]] TexelKind base_color_kind(const Material& material);
/// That of its emissive texture: where it is the base colour's, which says how much is there, what
/// it sends out counts by its alpha, too.
[[nodiscard]] TexelKind emissive_kind(const Material& material);

}  // namespace asos
