#pragma once

#include "renderer/geometry/box.h"

#include <cstdint>
#include <span>
#include <utility>

namespace asos {

/// An edge in the hierarchy's sort: its number and its box.
struct EdgeItem {
  Box box;
  std::uint32_t edge = 0;
};
using EdgeItems = std::span<EdgeItem>;

/// Splits the items into two halves by the cheapest plane between bins. The cost is the sum of both
/// boxes' extents, each times its number of items. If all centres are equal, splits by count.
/// Neither half is empty if there are two items.
[[nodiscard]] std::pair<EdgeItems, EdgeItems> binned_split(EdgeItems items);

}  // namespace asos
