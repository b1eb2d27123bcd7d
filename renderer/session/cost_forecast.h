#pragma once

#include "renderer/settings/settings.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Tells what the blocks that are left will cost, from what others cost. Blocks differ a
/// hundredfold, but one that is dear at a low MAX is dear at a high one: so each pass is forecast
/// by its ratio to the pass before over the blocks that both have done, and only the first one by
/// the mean of its blocks, which therefore have to be spread over the picture. One thread at a
/// time.
class CostForecast {
 public:
  /// Passes are told by their MAX; the final one follows.
  static constexpr std::size_t final_pass = max_level_limit + 1;

  explicit CostForecast(std::size_t blocks);

  /// The passes that all blocks go through before the final one, in this order. What was added of
  /// others is work that was done and is not repeated.
  void set_levels(std::span<const int> levels);
  /// What a block cost in a pass, in seconds of one processor.
  void add(std::size_t pass, std::size_t block, double seconds);

  [[nodiscard]] double seconds_done() const { return done_; }
  /// None before there is a block to tell from.
  [[nodiscard]] std::optional<double> seconds_left() const;
  /// The share of the work that is done, 0 to 1; 0 before anything is known.
  [[nodiscard]] double share_done() const;

 private:
  struct PassCosts {
    std::vector<float> by_block;  // negative: not done
    std::size_t count = 0;
    double sum = 0.0;
    // Over the blocks that the pass before has done as well: here, and there.
    double common = 0.0;
    double common_before = 0.0;
  };

  void compare(PassCosts& pass, const PassCosts& before, std::size_t block);

  std::size_t blocks_;
  std::array<PassCosts, final_pass + 1> passes_;
  std::vector<std::size_t> order_{final_pass};
  double done_ = 0.0;
};

}  // namespace asos
