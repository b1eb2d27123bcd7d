#pragma once

#include "renderer/shading/mip_levels.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace asos {

/// Levels 1, 2, ... of an image down to a single texel; level 0 is the image itself.
using MipChain = std::vector<MipLevel>;

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
