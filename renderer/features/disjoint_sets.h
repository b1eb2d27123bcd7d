#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace asos {

/// Sets of the numbers below n, each by itself at first (union-find).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  // The lower index stays the representative, so that the result does not depend on the order.
  void join(std::uint32_t x, std::uint32_t y) {
    x = find(x), y = find(y);
    if (x < y) parent_[y] = x;
    if (y < x) parent_[x] = y;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace asos
