#include "renderer/asos/sample_goal.h"

#include <algorithm>
#include <bit>

namespace asos {

RegionSampler::Goal sample_goal(const EyeContext& eye, double weight, std::uint32_t fewest) {
  return sample_goal(eye.allowance, weight, fewest);
}

RegionSampler::Goal sample_goal(const Allowance& allowance, double weight, std::uint32_t fewest) {
  constexpr double most = 1u << 20;
  RegionSampler::Goal goal;
  goal.standard_error = allowance.standard_error(weight);
  goal.share = allowance.weight * weight;
  goal.most =
      std::bit_floor(static_cast<std::uint32_t>(std::min(most, allowance.most_samples(weight))));
  goal.least = std::min(goal.most, std::max(allowance.pilot_samples(weight), fewest));
  return goal;
}

}  // namespace asos
