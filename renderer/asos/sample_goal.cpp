#include "renderer/asos/sample_goal.h"

#include <algorithm>
#include <bit>

namespace asos {

std::uint32_t enough_samples_for(const Budget& budget, double weight) {
  constexpr double of_a_pixel = 256.0;
  constexpr std::uint32_t fewest = 2;
  const double share = of_a_pixel * budget.share * weight;
  return std::bit_ceil(static_cast<std::uint32_t>(
      std::clamp(share, static_cast<double>(fewest), static_cast<double>(enough_samples))));
}

// The standard error that the part's weight deserves, and twice that where noise is all there is,
// or rather, as measured, 0.85 of that: more is allowed of what takes many samples. One for each
// finest cell at least, and at most sixteen. Of noise that the camera sees sixty-four: a few pixels
// that show something tiny and bright have most of a picture's error.
RegionSampler::Goal sample_goal(const EyeContext& eye, double weight, std::uint32_t fewest,
                                Sampled what) {
  const bool reflected = eye.viewer.bounces > 0;
  if (reflected) fewest = few_samples;
  const bool noisy = what != Sampled::smooth;
  const Budget budget = eye.budget.for_samples();
  RegionSampler::Goal goal;
  goal.standard_error = 0.85 * (noisy ? 2.0 : 1.0) * budget.standard_error(weight);
  goal.share = budget.share * weight;
  goal.least = budget.samples(weight, 1.0, fewest);
  goal.most = budget.samples(weight, noisy && !reflected ? 64.0 : 16.0, fewest);
  return goal;
}

}  // namespace asos
