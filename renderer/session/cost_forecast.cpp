#include "renderer/session/cost_forecast.h"

#include <algorithm>
#include <numeric>

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

void CostForecast::set_likeness(std::span<const double> values) {
  alike_.resize(blocks_);
  std::iota(alike_.begin(), alike_.end(), 0u);
  std::stable_sort(alike_.begin(), alike_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return values[a] < values[b]; });
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

double CostForecast::left_by_likeness(const PassCosts& pass, const Guide& guide) const {
  // Number of neighbours in the order of likeness, on both sides together.
  constexpr std::size_t nearest = 8;
  // Prefix sums over the done blocks in the order of likeness. Blocks that cost nothing here are
  // left out: they were completed in the pass before, unlike the remaining ones.
  std::vector<Shared> sums{{}};
  for (const std::uint32_t block : alike_) {
    if (!(pass.by_block[block] > 0.0f)) continue;
    Shared sum = sums.back();
    sum.here += static_cast<double>(pass.by_block[block]);
    sum.there += static_cast<double>(guide.before.by_block[block]);
    sums.push_back(sum);
  }
  const std::size_t done = sums.size() - 1, taken = std::min(done, nearest);
  const double known = guide.known * static_cast<double>(nearest - taken) / nearest;
  // Forecast the blocks that are not done.
  double left = 0.0;
  std::size_t below = 0;  // done blocks before this one
  for (const std::uint32_t block : alike_) {
    if (pass.by_block[block] >= 0.0f) {
      below += pass.by_block[block] > 0.0f;
      continue;
    }
    const std::size_t first = std::min(below - std::min(below, taken / 2), done - taken);
    const Shared near{sums[first + taken].here - sums[first].here,
                      sums[first + taken].there - sums[first].there};
    left += near.ratio(known, guide.growth) * static_cast<double>(guide.before.by_block[block]);
  }
  return left;
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
        // Likeness is valid for the first pass ordered by it, once the pass before is complete.
        const bool by_likeness = !alike_.empty() && before->count == blocks_;
        rest = by_likeness ? left_by_likeness(pass, guide) : left_of(pass, guide);
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
