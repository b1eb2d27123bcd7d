#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace asos {

/// Sets of the numbers below n; initially each number is its own set (union-find without locks,
/// after Anderson and Woll 1991). Any number of threads.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  /// Returns the lowest member, once all threads have finished joining.
  std::uint32_t find(std::uint32_t x) {
    for (;;) {
      const std::uint32_t up = parent(x).load(std::memory_order_relaxed);
      if (up == x) return x;
      const std::uint32_t above = parent(up).load(std::memory_order_relaxed);
      // Only a root's parent determines the set, and x is no root any more.
      if (above != up) parent(x).store(above, std::memory_order_relaxed);
      x = above;
    }
  }
  // A root becomes a child of lower ones only, so that the result does not depend on the order.
  void join(std::uint32_t x, std::uint32_t y) {
    for (;;) {
      x = find(x), y = find(y);
      if (x == y) return;
      if (x < y) std::swap(x, y);
      std::uint32_t root = x;
      if (parent(x).compare_exchange_strong(root, y, std::memory_order_relaxed)) return;
    }
  }

 private:
  std::atomic_ref<std::uint32_t> parent(std::uint32_t x) { return std::atomic_ref(parent_[x]); }

  std::vector<std::uint32_t> parent_;
};

}  // namespace asos
