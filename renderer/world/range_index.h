#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// Finds the range that contains a number among many consecutive ranges. Takes constant time if the
/// ranges have similar lengths.
class RangeIndex {
 public:
  RangeIndex() = default;
  /// `first` is where each range begins, starting with 0; none is empty. `end` is the end of the
  /// last one.
  RangeIndex(std::vector<std::uint32_t> first, std::uint32_t end) : first_(std::move(first)) {
    if (first_.empty()) return;
    while ((end >> shift_) > 2 * first_.size()) ++shift_;
    std::uint32_t range = 0;
    for (std::uint64_t at = 0; at < end; at += std::uint64_t{1} << shift_) {
      while (range + 1 < first_.size() && first_[range + 1] <= at) ++range;
      of_block_.push_back(range);
    }
    of_block_.push_back(static_cast<std::uint32_t>(first_.size() - 1));
  }

  /// Returns the index of the range that contains `number`, which is below the end.
  [[nodiscard]] std::size_t find(std::uint32_t number) const {
    const std::uint32_t block = number >> shift_;
    const auto from = first_.begin() + of_block_[block];
    const auto to = first_.begin() + of_block_[block + 1] + 1;
    return static_cast<std::size_t>(std::upper_bound(from, to, number) - first_.begin()) - 1;
  }
  [[nodiscard]] std::uint32_t first(std::size_t range) const { return first_[range]; }
  [[nodiscard]] bool empty() const { return first_.empty(); }
  [[nodiscard]] std::size_t memory_bytes() const {
    return (first_.capacity() + of_block_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> of_block_;  // the range at the first number of each block
  unsigned shift_ = 0;
};

}  // namespace asos
