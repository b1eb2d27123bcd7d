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

CostForecast::Shared CostForecast::shared(const PassCosts& pass, const PassCosts& before) const {
  Shared sums;
  for (std::size_t block = 0; block < blocks_; ++block) {
    const float here = pass.by_block[block], there = before.by_block[block];
    if (here < 0.0f || there < 0.0f) continue;
    sums.here += static_cast<double>(here);
    sums.there += static_cast<double>(there);
  }
  return sums;
}

std::optional<double> CostForecast::seconds_left() const {
  // What is known beforehand counts as so many blocks do.
  constexpr double blocks_of_growth = 4.0;
  const PassCosts* before = nullptr;
  double growth = 1.0;      // over it
  double all_before = 0.0;  // of its work
  double left = 0.0;
  for (const PassCosts& pass : passes_) {
    growth *= pass.growth;
    if (pass.left_out) continue;
    double all = pass.sum;
    if (pass.count < blocks_) {
      if (before) {
        const Shared both = shared(pass, *before);
        const double known = blocks_of_growth * all_before / static_cast<double>(blocks_);
        const double there = both.there + known;
        const double ratio = there > 0.0 ? (both.here + growth * known) / there : 0.0;
        all = pass.sum + ratio * std::max(0.0, all_before - both.there);
      } else {
        if (pass.count == 0) return std::nullopt;
        all *= static_cast<double>(blocks_) / static_cast<double>(pass.count);
      }
    }
    left += std::max(0.0, all - pass.sum);
    before = &pass;
    all_before = all;
    growth = 1.0;
  }
  return left;
}

double CostForecast::share_done() const {
  const std::optional<double> left = seconds_left();
  if (!left || !(done_ > 0.0)) return 0.0;
  return done_ / (done_ + *left);
}

}  // namespace asos
