#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace asos {

/// Forecasts the cost of the remaining passes over a picture from the cost of its blocks so far.
/// The costs of blocks differ by a factor of a hundred, but a block that is expensive in one pass
/// is expensive in the next. So a pass is forecast from the pass before, by the ratio of their
/// costs over the blocks done in both. A prior ratio counts until there are enough of these. The
/// first pass is forecast by the mean of its blocks, which therefore have to be spread over the
/// picture. One thread at a time.
class CostForecast {
 public:
  /// `growth`: for each pass but the first, the ratio of its work to that of the pass before.
  explicit CostForecast(std::size_t blocks, std::vector<double> growth = {});

  /// Adds the cost of a block in a pass, in seconds of one processor. Repeated work on a block
  /// counts, too.
  void add(std::size_t pass, std::size_t block, double seconds);
  /// Adds costs that belong to no pass.
  void add(double seconds) { done_ += seconds; }
  /// Marks a pass before the last one as skipped.
  void leave_out(std::size_t pass);

  /// Marks the growth of a pass as a guess, which may be wrong by a factor of ten.
  void guess(std::size_t pass);

  [[nodiscard]] double seconds_done() const { return done_; }
  /// Returns true while no block of a pass with a guessed growth was measured.
  [[nodiscard]] bool guesses() const;
  /// Returns the forecast; none before the first block is done.
  [[nodiscard]] std::optional<double> seconds_left() const;

 private:
  struct PassCosts {
    std::vector<float> by_block;  // negative: not done
    double growth = 1.0;          // relative to the pass before, as a prior
    std::size_t count = 0;
    double sum = 0.0;
    bool left_out = false;
    bool guessed = false;
  };
  /// Costs of the blocks that are done in two passes.
  struct Shared {
    double here = 0.0, there = 0.0;

    [[nodiscard]] double ratio(double known, double growth) const {
      const double all = there + known;
      return all > 0.0 ? (here + growth * known) / all : 0.0;
    }
  };
  /// The data for forecasting the rest of a pass. `known` is the weight of the prior `growth`, as
  /// work of the pass before.
  struct Guide {
    const PassCosts& before;
    double all_before = 0.0;
    double growth = 1.0;
    double known = 0.0;
  };
  [[nodiscard]] double left_of(const PassCosts& pass, const Guide& guide) const;

  std::size_t blocks_;
  std::vector<PassCosts> passes_;
  double done_ = 0.0;
};

}  // namespace asos
