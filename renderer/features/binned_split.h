#pragma once

#include "renderer/geometry/box.h"

#include <cstdint>
#include <span>
#include <utility>

namespace asos {

/// An edge as the hierarchy sorts it: its number and its box.
struct EdgeItem {
  Box box;
  std::uint32_t edge = 0;
};
using EdgeItems = std::span<EdgeItem>;

/// Sorts the items into two halves by the cheapest of the planes between bins, by the sum of the
/// boxes' extents, or by count where all centres agree. Neither is empty where there are two.
[[nodiscard]] std::pair<EdgeItems, EdgeItems> binned_split(EdgeItems items);

}  // namespace asos
