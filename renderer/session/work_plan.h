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

/// How a picture, or the part of it that a crop touches, is cut into work. Blocks are aligned to
/// block_side(settings) in the whole picture, whatever the crop, so that a crop's pixels are the
/// picture's. Groups run from the middle of what is visible outwards; the order is the same on
/// every machine.
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

  /// All blocks, or groups, by index, in an order that is spread evenly over the picture from the
  /// first to the last, so that what is done tells what is left (CostForecast).
  [[nodiscard]] std::vector<std::size_t> spread_blocks() const;
  [[nodiscard]] std::vector<std::size_t> spread_groups() const;
  /// The blocks of groups in that order.
  [[nodiscard]] std::vector<std::size_t> blocks_of(const std::vector<std::size_t>& order) const;
};

/// The numbers below `count` in an order of which any first few are spread evenly over all: by the
/// multiples of the golden section.
[[nodiscard]] std::vector<std::size_t> spread_order(std::size_t count);

}  // namespace asos
