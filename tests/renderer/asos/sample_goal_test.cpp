#include "renderer/asos/sample_goal.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace asos::sample_goal_test {
namespace {

// The smaller a part of its pixel, the fewer samples tell enough of it.
TEST(SampleGoal, AsksFewSamplesOfSmallParts) {
  Budget budget;
  EXPECT_EQ(enough_samples_for(budget, 1.0), enough_samples);
  EXPECT_EQ(enough_samples_for(budget, 1.0 / 16.0), enough_samples);
  EXPECT_EQ(enough_samples_for(budget, 1.0 / 32.0), enough_samples / 2);
  EXPECT_EQ(enough_samples_for(budget, 1.0 / 64.0), enough_samples / 4);
  EXPECT_EQ(enough_samples_for(budget, 1e-9), 2u);
  budget.share = 0.25;
  EXPECT_EQ(enough_samples_for(budget, 0.25), enough_samples) << "of what a mirror shows, as well";
  EXPECT_EQ(enough_samples_for(budget, 0.125), enough_samples / 2);
}

// Half of white, which nothing in a part is farther off the mean than, may be missed where samples
// agree by chance: a pixel is off by two EPS then at most.
TEST(SampleGoal, LeavesLittleToChance) {
  const Budget budget = Budget::of(RenderSettings{});
  for (double weight = 1.0 / 16.0; weight > 1e-7; weight *= 0.9) {
    const std::uint32_t samples = enough_samples_for(budget, weight);
    EXPECT_TRUE(std::has_single_bit(samples)) << weight;
    EXPECT_LE(0.5 * weight / std::sqrt(samples), 2.0 * budget.eps) << weight;
  }
}

}  // namespace
}  // namespace asos::sample_goal_test
