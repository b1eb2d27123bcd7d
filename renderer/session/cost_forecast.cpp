#include "renderer/session/cost_forecast.h"

#include <algorithm>

namespace asos {

CostForecast::CostForecast(std::size_t blocks, std::vector<double> growth)
    : blocks_(blocks), passes_(growth.size() + 1) {
  for (PassCosts& pass : passes_) pass.by_block.assign(blocks, -1.0f);
  for (std::size_t i = 0; i < growth.size(); ++i) passes_[i + 1].growth = growth[i];
}

void CostForecast::add(std::size_t pass, std::size_t block, double seconds) {
  PassCosts& costs = passes_[pass];
  done_ += seconds;
  if (costs.by_block[block] >= 0.0f) return;
  costs.by_block[block] = static_cast<float>(seconds);
  costs.sum += seconds;
  ++costs.count;
}

void CostForecast::leave_out(std::size_t pass) {
  passes_[pass].left_out = true;
}

void CostForecast::guess(std::size_t pass) {
  passes_[pass].guessed = true;
}

bool CostForecast::guesses() const {
  return std::any_of(passes_.begin(), passes_.end(), [](const PassCosts& pass) {
    return pass.guessed && !pass.left_out && pass.count == 0;
  });
}

// A block that was completed in the pass before costs nothing here. Blocks done before but not here
// are therefore forecast from the blocks with a cost above 0 here; the others from both kinds.
double CostForecast::left_of(const PassCosts& pass, const Guide& guide) const {
  Shared going;              // blocks with a cost above 0 here
  double done_before = 0.0;  // all blocks done in the pass before
  double waiting = 0.0;      // the part of them not done in this pass
  for (std::size_t block = 0; block < blocks_; ++block) {
    const auto here = static_cast<double>(pass.by_block[block]);
    const auto there = static_cast<double>(guide.before.by_block[block]);
    if (there < 0.0) continue;
    done_before += there;
    if (here < 0.0) waiting += there;
    if (here > 0.0) going.here += here, going.there += there;
  }
  const double ratio = going.ratio(guide.known, guide.growth);
  const double share = done_before > 0.0 ? (going.there + waiting) / done_before : 1.0;
  return ratio * (waiting + share * std::max(0.0, guide.all_before - done_before));
}

std::optional<double> CostForecast::seconds_left() const {
  // The prior ratio weighs as much as this many blocks.
  constexpr double blocks_of_growth = 4.0;
  const PassCosts* before = nullptr;
  double growth = 1.0;      // from the pass `before` to this one
  double all_before = 0.0;  // all work of the pass `before`
  double left = 0.0;
  for (const PassCosts& pass : passes_) {
    growth *= pass.growth;
    if (pass.left_out) continue;
    double rest = 0.0;
    if (pass.count < blocks_) {
      if (before) {
        const Guide guide{*before, all_before, growth,
                          blocks_of_growth * all_before / static_cast<double>(blocks_)};
        rest = left_of(pass, guide);
      } else {
        if (pass.count == 0) return std::nullopt;
        rest =
            pass.sum * static_cast<double>(blocks_ - pass.count) / static_cast<double>(pass.count);
      }
    }
    left += rest;
    before = &pass;
    all_before = pass.sum + rest;
    growth = 1.0;
  }
  return left;
}

}  // namespace asos
