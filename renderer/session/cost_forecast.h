#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Forecasts the cost of the remaining passes over a picture from the cost of its blocks so far.
/// Blocks differ a hundredfold, but a block that is dear in a pass is dear in the next. So a pass
/// is forecast from the pass before, by the ratio of their costs over the blocks done in both. A
/// prior ratio counts until there are enough of these. The first pass is forecast by the mean of
/// its blocks, which therefore have to be spread over the picture. One thread at a time.
class CostForecast {
 public:
  /// `growth`: how many times the work of the pass before each pass but the first takes.
  explicit CostForecast(std::size_t blocks, std::vector<double> growth = {});

  /// What a block cost in a pass, in seconds of one processor. What is done of a block again counts
  /// as work.
  void add(std::size_t pass, std::size_t block, double seconds);
  /// Blocks of similar values have similar ratios: one value a block. A pass that goes by these
  /// values takes its dearest blocks first, so that each remaining block is forecast from the done
  /// ones that are next to it. A few blocks have to be done out of that order.
  void set_likeness(std::span<const double> values);
  /// Passes before the last one that are not taken after all.
  void leave_out(std::size_t pass);

  [[nodiscard]] double seconds_done() const { return done_; }
  /// None before there is a block to tell from.
  [[nodiscard]] std::optional<double> seconds_left() const;

 private:
  struct PassCosts {
    std::vector<float> by_block;  // negative: not done
    double growth = 1.0;          // over the pass before, as known beforehand
    std::size_t count = 0;
    double sum = 0.0;
    bool left_out = false;
  };
  /// Costs of blocks that are done in two passes.
  struct Shared {
    double here = 0.0, there = 0.0;

    [[nodiscard]] double ratio(double known, double growth) const {
      const double all = there + known;
      return all > 0.0 ? (here + growth * known) / all : 0.0;
    }
  };
  /// What is left of a pass. `known`: the work of the pass before that counts as done at `growth`.
  struct Guide {
    const PassCosts& before;
    double all_before = 0.0;
    double growth = 1.0;
    double known = 0.0;
  };
  [[nodiscard]] double left_of(const PassCosts& pass, const Guide& guide) const;
  [[nodiscard]] double left_by_likeness(const PassCosts& pass, const Guide& guide) const;

  std::size_t blocks_;
  std::vector<std::uint32_t> alike_;  // blocks in the order of their likeness; empty: not known
  std::vector<PassCosts> passes_;
  double done_ = 0.0;
};

}  // namespace asos
