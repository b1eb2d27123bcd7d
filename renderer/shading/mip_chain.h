#pragma once

#include "renderer/shading/mip_levels.h"
#include "renderer/world/render_features.h"
#include "renderer/world/world.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace asos {

/// Levels 1, 2, ... of an image down to a single texel; level 0 is the image itself. They are made
/// when the first texel of one is read, by one thread, since many images are never read.
class MipChain {
 public:
  MipChain() = default;  ///< no levels
  /// Shares the bytes of `image`.
  MipChain(Image image, TexelKind kind);
  MipChain(const MipChain&) = delete;
  MipChain& operator=(const MipChain&) = delete;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  /// Returns whether it is that of an image: of the same bytes in memory.
  [[nodiscard]] bool is_of(const Image& image) const {
    return image_.rgba.data() == image.rgba.data() && image_.width == image.width &&
           image_.height == image.height;
  }
  /// Returns the level after `finer` ones, the image not included.
  [[nodiscard]] const MipLevel& operator[](std::size_t finer) const {
    if (!made_.load(std::memory_order_acquire)) make();
    return levels_[finer];
  }
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  void make() const;

  Image image_;
  TexelKind kind_ = TexelKind::data;
  std::size_t size_ = 0;
  mutable std::mutex making_;
  mutable std::atomic<bool> made_{false};
  mutable std::vector<MipLevel> levels_;  // immutable once made
};

/// The chains of a world's images, for each kind of use by a material on a triangle. A small value:
/// copies share the chains.
class MipChains {
 public:
  MipChains() = default;
  /// `known`: the chains of a world whose images may be the same, which are reused; null: none.
  MipChains(const World& world, const RenderFeatures& render_features,
            const MipChains* known = nullptr);

  /// Returns the chain, which is empty if no material uses `image` as `kind`.
  [[nodiscard]] const MipChain& chain(int image, TexelKind kind) const;
  /// Returns the memory of the levels that exist so far.
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
