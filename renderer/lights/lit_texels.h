#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The parts of a texture that are brighter than black, as a summed-area table of blocks of texels.
/// Most emissive textures are black almost everywhere, and need not be sampled there.
class LitTexels {
 public:
  /// sRGB bytes that count as black: lossy compression may make 12 of black next to white.
  static constexpr std::uint8_t black = 12;

  /// Reads a texture's image. Without one, everything counts as lit.
  LitTexels(const World& world, int texture);

  /// Returns false if all bilinear look-ups between two places read black texels, of coordinates
  /// from `low` to `high` in each axis.
  [[nodiscard]] bool any(glm::vec2 low, glm::vec2 high) const;

 private:
  struct Axis {
    int texels = 0;
    Wrap wrap = Wrap::repeat;
  };
  struct Blocks {
    std::size_t begin, end;
  };
  [[nodiscard]] static Blocks blocks_of(const Axis& axis, double low, double high);
  [[nodiscard]] std::uint32_t sum(std::size_t x, std::size_t y) const {
    return sums_[y * (columns_ + 1) + x];
  }

  Axis u_, v_;
  std::size_t columns_ = 0;  // blocks of a row
  std::vector<std::uint32_t>
      sums_;  // lit blocks above and left of a block's corner; empty: no image
};

}  // namespace asos
