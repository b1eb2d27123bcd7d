#include "renderer/pyray/fat_search.h"

#include <algorithm>
#include <bit>

namespace asos {

void FatSearch::run(BoundarySearch& search, const FatPyray& fat, const OccluderOf& occluder_of) {
  search_ = &search;
  fat_ = &fat;
  occluder_of_ = &occluder_of;
  found_.resize(std::max(found_.size(), static_cast<std::size_t>(fat.side * fat.side)));
  hand_down(0, 0, fat.side, search.lists().root());
}

// `parent` may be the list of any square that holds this one.
void FatSearch::hand_down(int x, int y, int size, std::span<const std::uint32_t> parent) {
  const Square square = fat_->searched_square(x, y, size);
  // Any sample inside the square can hide boundaries behind it.
  const OccluderPlane cover = (*occluder_of_)(x + size / 2, y + size / 2);
  const BoundarySearch::Sight sight = search_->sight(square, cover);
  // Find the boundaries of the square among its parent's.
  BoundarySearch::List& list =
      size == 1 ? found_[fat_->index(x, y)].list
                : lists_[static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(size)))];
  search_->refine(square, sight, parent, list, true);
  const bool clear = search_->all_hidden(list, sight);
  if (size == 1) {
    found_[fat_->index(x, y)].bounded = !clear;
    return;
  }
  // A clear square holds clear pyrays only.
  if (clear) {
    for (int v = y; v < y + size; ++v) {
      for (int u = x; u < x + size; ++u) {
        found_[fat_->index(u, v)].list.clear();
        found_[fat_->index(u, v)].bounded = false;
      }
    }
    return;
  }
  // Hand the list down to the quarters.
  const int half = size / 2;
  for (int i = 0; i < 4; ++i) hand_down(x + (i & 1) * half, y + (i >> 1) * half, half, list);
}

}  // namespace asos
