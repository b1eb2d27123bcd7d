#include "renderer/asos/sample_goal.h"

#include <algorithm>
#include <bit>

namespace asos {

RegionSampler::Goal sample_goal(const EyeContext& eye, double weight, std::uint32_t fewest) {
  return sample_goal(eye.error_budget, weight, fewest);
}

RegionSampler::Goal sample_goal(const ErrorBudget& error_budget, double weight,
                                std::uint32_t fewest) {
  constexpr double most = 1u << 20;
  RegionSampler::Goal goal;
  goal.standard_error = error_budget.standard_error(weight);
  goal.share = error_budget.weight * weight;
  goal.most =
      std::bit_floor(static_cast<std::uint32_t>(std::min(most, error_budget.most_samples(weight))));
  goal.least = std::min(goal.most, std::max(error_budget.pilot_samples(weight), fewest));
  return goal;
}

}  // namespace asos
