#pragma once

#include "renderer/pyray/boundary_search.h"
#include "renderer/pyray/pyray.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace asos {

/// Finds the boundaries near each pyray of a fat one. Hit lists pass from the whole to its
/// quarters, and so on (CGF'98 sections 6.1 and 6.4). Reuses its memory; one object per thread.
class FatSearch {
 public:
  /// Returns the cover of the sample of pyray (x, y), which is at the centre of a square.
  using OccluderOf = std::function<OccluderPlane(int x, int y)>;

  /// `search` must have been started in the fat pyray's frame.
  void run(BoundarySearch& search, const FatPyray& fat, const OccluderOf& occluder_of);

  /// Returns whether a boundary that may be visible passes through a pyray.
  [[nodiscard]] bool bounded(std::uint32_t index) const { return found_[index].bounded; }
  /// Returns a pyray's hit list; empty if a larger square around it has no visible boundary.
  [[nodiscard]] std::span<const std::uint32_t> list(std::uint32_t index) const {
    return found_[index].list;
  }

 private:
  struct Found {
    bool bounded = false;
    BoundarySearch::List list;
  };
  void hand_down(int x, int y, int size, std::span<const std::uint32_t> parent);

  static constexpr std::size_t most_sizes = 5;  // 1, 2, 4, 8, 16 pyrays

  BoundarySearch* search_ = nullptr;
  const FatPyray* fat_ = nullptr;
  const OccluderOf* occluder_of_ = nullptr;
  std::vector<Found> found_;
  std::array<BoundarySearch::List, most_sizes> lists_;  // of larger squares, by size
};

}  // namespace asos
