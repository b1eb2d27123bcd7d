#include "renderer/session/cost_forecast.h"

#include <algorithm>

namespace asos {

CostForecast::CostForecast(std::size_t blocks) : blocks_(blocks) {}

void CostForecast::set_levels(std::span<const int> levels) {
  order_.clear();
  for (const int level : levels) order_.push_back(static_cast<std::size_t>(level));
  order_.push_back(final_pass);
  for (std::size_t i = 1; i < order_.size(); ++i) {
    PassCosts& pass = passes_[order_[i]];
    pass.common = pass.common_before = 0.0;
    for (std::size_t block = 0; block < pass.by_block.size(); ++block)
      compare(pass, passes_[order_[i - 1]], block);
  }
}

void CostForecast::add(std::size_t pass, std::size_t block, double seconds) {
  PassCosts& costs = passes_[pass];
  if (costs.by_block.empty()) costs.by_block.assign(blocks_, -1.0f);
  done_ += seconds;
  if (costs.by_block[block] >= 0.0f) return;
  costs.by_block[block] = static_cast<float>(seconds);
  costs.sum += seconds;
  ++costs.count;
  const auto at = std::find(order_.begin(), order_.end(), pass);
  if (at == order_.end()) return;
  if (at != order_.begin()) compare(costs, passes_[*(at - 1)], block);
  if (at + 1 != order_.end()) compare(passes_[*(at + 1)], costs, block);
}

void CostForecast::compare(PassCosts& pass, const PassCosts& before, std::size_t block) {
  if (pass.by_block.empty() || before.by_block.empty()) return;
  const float here = pass.by_block[block], there = before.by_block[block];
  if (here < 0.0f || there < 0.0f) return;
  pass.common += static_cast<double>(here);
  pass.common_before += static_cast<double>(there);
}

std::optional<double> CostForecast::seconds_left() const {
  double left = 0.0;
  double before = 0.0;  // all of the pass before
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const PassCosts& pass = passes_[order_[i]];
    const bool by_ratio = i > 0 && pass.common_before > 0.0;
    if (pass.count == 0 && blocks_ > 0) return std::nullopt;
    double total = pass.sum;
    if (pass.count < blocks_) {
      total = by_ratio ? before * pass.common / pass.common_before
                       : pass.sum * static_cast<double>(blocks_) / static_cast<double>(pass.count);
    }
    left += std::max(0.0, total - pass.sum);
    before = total;
  }
  return left;
}

double CostForecast::share_done() const {
  const std::optional<double> left = seconds_left();
  if (!left || !(done_ > 0.0)) return 0.0;
  return done_ / (done_ + *left);
}

}  // namespace asos
