#include "renderer/sampling/sequential_mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace asos::test::sequential_mean_test {
namespace {

TEST(SamplingGoal, RoundsDouble) {
  const SamplingGoal goal{0.1, 4, 16};
  EXPECT_EQ(goal.after_next_round(0), 4u);
  EXPECT_EQ(goal.after_next_round(4), 8u);
  EXPECT_FALSE(goal.exhausted(8));
  EXPECT_TRUE(goal.exhausted(16));
}

TEST(SamplingGoal, AllowsTheRootOfTheSamplesMore) {
  const SamplingGoal goal{0.1, 4, 1024};
  EXPECT_NEAR(goal.allowed_error(4), 0.1, 1e-12);
  EXPECT_NEAR(goal.allowed_error(64), 0.4, 1e-12);
  EXPECT_TRUE(goal.met(64, 0.39));
  EXPECT_FALSE(goal.met(64, 0.41));
  EXPECT_TRUE(goal.met(1024, 100.0)) << "no more are allowed";
  const SamplingGoal fixed{0.1, 4, 1024, false};
  EXPECT_NEAR(fixed.allowed_error(64), 0.1, 1e-12);
  EXPECT_FALSE(fixed.met(64, 0.11));
  const SamplingGoal all{-1.0, 4, 16};
  EXPECT_FALSE(all.met(8, 0.0)) << "all that are allowed";
}

TEST(SequentialMean, IsTheMeanOfAnyNumberOfSamples) {
  SequentialMean mean;
  double sum = 0.0, weights = 0.0;
  for (int i = 1; i <= 1000; ++i) {
    const double value = std::sin(i), weight = 1.0 + i % 3;
    mean.add(glm::dvec3(value), weight);
    sum += weight * value;
    weights += weight;
    ASSERT_EQ(mean.count(), static_cast<std::uint32_t>(i));
    ASSERT_NEAR(mean.mean().y, sum / weights, 1e-12) << i;
    ASSERT_NEAR(mean.weight(), weights, 1e-9) << i;
  }
  mean.clear();
  EXPECT_EQ(mean.count(), 0u);
  EXPECT_EQ(mean.mean(), glm::dvec3(0.0));
}

TEST(SequentialMean, KnowsNothingOfOneSample) {
  SequentialMean mean;
  mean.add(glm::dvec3(1.0));
  EXPECT_TRUE(std::isinf(mean.standard_error()));
  mean.add(glm::dvec3(1.0));
  EXPECT_EQ(mean.standard_error(), 0.0);
}

// The mean of n independent samples of variance 1 has a standard error of n^(-1/2).
TEST(SequentialMean, StandardErrorIsThatOfIndependentSamples) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (const int count : {8, 16, 24, 100, 640}) {
    double squares = 0.0;
    constexpr int runs = 4000;
    for (int run = 0; run < runs; ++run) {
      SequentialMean mean;
      for (int i = 0; i < count; ++i) mean.add({normal(random), 0.0, 0.0});
      squares += std::pow(mean.standard_error(), 2.0);
    }
    EXPECT_NEAR(std::sqrt(squares / runs) * std::sqrt(count), 1.0, 0.05) << count;
  }
}

TEST(SequentialMean, WorstChannelCounts) {
  SequentialMean mean;
  for (int i = 0; i < 16; ++i) mean.add({0.0, i < 8 ? 1.0 : 0.0, i < 8 ? 0.1 : 0.0});
  EXPECT_NEAR(mean.standard_error(), 0.5 / std::sqrt(7.0), 1e-12);
}

}  // namespace
}  // namespace asos::test::sequential_mean_test
