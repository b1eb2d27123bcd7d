#pragma once

#include "renderer/geometry/view.h"
#include "renderer/settings/settings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// Side of the groups of blocks that are published together: a window uploads few large tiles
/// faster than many small ones.
inline constexpr int group_size = 32;

/// A group of blocks: `rect` is aligned to group_size in the whole picture and clipped to it.
struct BlockGroup {
  PixelRect rect;
  std::size_t first_block = 0;  ///< into WorkPlan::blocks
  std::size_t block_count = 0;
};

/// The division of a picture, or of the part that a crop touches, into work. Blocks are aligned to
/// block_side(settings) in the whole picture, independent of the crop, so that a crop's pixels
/// equal those of the whole picture. Groups are ordered from the centre of the visible part
/// outwards; the order is the same on every machine.
struct WorkPlan {
  struct Block {
    PixelRect rect;
    std::size_t group = 0;
  };
  PixelRect visible;
  std::vector<BlockGroup> groups;
  std::vector<Block> blocks;  ///< group by group

  WorkPlan() = default;
  explicit WorkPlan(const RenderSettings& settings);

  /// Returns the indices of all blocks, or groups, in an order whose beginnings are evenly spread
  /// over the picture, so that finished work predicts the remaining work (StepQueue).
  [[nodiscard]] std::vector<std::size_t> spread_blocks() const;
  [[nodiscard]] std::vector<std::size_t> spread_groups() const;
};

/// A pixel of the picture, in a block of a plan.
struct PlannedPixel {
  std::uint32_t block = 0;
  int x = 0, y = 0;
};

/// Returns the numbers below `count` in an order whose beginnings are evenly spread: by the
/// multiples of the golden section.
[[nodiscard]] std::vector<std::size_t> spread_order(std::size_t count);

}  // namespace asos
