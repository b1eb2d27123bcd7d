#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace asos {

/// Tells what the passes over a picture that are left will cost, from what its blocks cost so far.
/// Blocks differ a hundredfold, but one that is dear in a pass is dear in the next. So a pass is
/// forecast from the pass before, by the ratio of the two over the blocks that both have done, and
/// until there are enough of these by a ratio that is known beforehand. The first pass is forecast
/// by the mean of its blocks, which therefore have to be spread over the picture. One thread at a
/// time.
class CostForecast {
 public:
  /// `growth`: how many times the work of the pass before each pass but the first takes.
  explicit CostForecast(std::size_t blocks, std::vector<double> growth = {});

  /// What a block cost in a pass, in seconds of one processor. What is done of a block again counts
  /// as work.
  void add(std::size_t pass, std::size_t block, double seconds);
  /// Passes before the last one that are not taken after all.
  void leave_out(std::size_t pass);

  [[nodiscard]] double seconds_done() const { return done_; }
  /// None before there is a block to tell from.
  [[nodiscard]] std::optional<double> seconds_left() const;
  /// The share of the work that is done, 0 to 1; 0 before anything is known.
  [[nodiscard]] double share_done() const;

 private:
  struct PassCosts {
    std::vector<float> by_block;  // negative: not done
    double growth = 1.0;          // over the pass before, as known beforehand
    std::size_t count = 0;
    double sum = 0.0;
    bool left_out = false;
  };
  /// Of a pass over the blocks that it shares with another.
  struct Shared {
    double here = 0.0, there = 0.0;
  };
  [[nodiscard]] Shared shared(const PassCosts& pass, const PassCosts& before) const;

  std::size_t blocks_;
  std::vector<PassCosts> passes_;
  double done_ = 0.0;
};

}  // namespace asos
