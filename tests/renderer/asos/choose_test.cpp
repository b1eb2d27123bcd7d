#include "renderer/asos/leaf_chooser.h"

#include <gtest/gtest.h>

#include <limits>

namespace asos::test::choose_test {
namespace {

ErrorBudget allowance_of(int max_level, double eps = 1.0 / 256.0) {
  RenderSettings settings;
  settings.asos.max_level = max_level;
  settings.asos.eps = eps;
  return ErrorBudget::of(settings);
}

LeafChoice leaf_of(double error, double weight = 1.0) {
  LeafChoice leaf;
  leaf.weight = weight;
  leaf.bound = ErrorBound::of(error);
  leaf.price = 3.0;
  leaf.may_split = true;
  return leaf;
}

TEST(Choose, ChoosesCentreWithinTheAllowance) {
  EXPECT_EQ(choose(allowance_of(3), leaf_of(1.0 / 256.0)), Estimator::centre);
  EXPECT_EQ(choose(allowance_of(3), leaf_of(0.0)), Estimator::centre);
  EXPECT_NE(choose(allowance_of(3), leaf_of(1.01 / 256.0)), Estimator::centre);
  EXPECT_EQ(choose(allowance_of(3, 1.0 / 16.0), leaf_of(1.01 / 256.0)), Estimator::centre);
}

TEST(Choose, SamplesWithoutABound) {
  LeafChoice leaf = leaf_of(0.0);
  leaf.bound += ErrorBound::unknown();
  EXPECT_EQ(choose(allowance_of(3), leaf), Estimator::samples);
  leaf.may_split = false;
  EXPECT_EQ(choose(allowance_of(3), leaf), Estimator::samples);
}

TEST(Choose, ChoosesCheaperOfSplitAndSamples) {
  // An error of twice the tolerance; a split costs four leaves.
  LeafChoice leaf = leaf_of(2.0 / 256.0);
  const double samples = allowance_of(4).samples(1.0, ErrorBudget::usual_contrast);
  leaf.price = 0.99 * samples / 4.0;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::split);
  leaf.price = 1.01 * samples / 4.0;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::samples);
  // A leaf with a small weight needs few samples.
  leaf.price = 3.0;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::split);
  leaf.weight = 1.0 / 256.0;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::samples);
}

TEST(Choose, ChoosesLeastErrorAtMax) {
  LeafChoice leaf = leaf_of(1.0);
  leaf.may_split = false;
  leaf.weight = 1.0 / 256.0;  // a cell at level MAX 4: four samples
  const double of_samples = ErrorBudget::error_of_samples(4.0, ErrorBudget::usual_contrast);
  leaf.bound.error = 1.02 * of_samples;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::samples);
  leaf.bound.error = 0.98 * of_samples;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::centre);
  leaf.bound.contrast = 4.0;
  leaf.bound.error = 1.02 * of_samples;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::centre) << "highlights make samples noisy";
}

TEST(Choose, InfiniteErrorIsNeverTheCentre) {
  LeafChoice leaf = leaf_of(std::numeric_limits<double>::infinity());
  for (const bool may_split : {false, true}) {
    leaf.may_split = may_split;
    EXPECT_NE(choose(allowance_of(3), leaf), Estimator::centre);
  }
}

TEST(Choose, SmallMaxLeavesAllToSamples) {
  EXPECT_TRUE(samples_cost_least(allowance_of(1), 1.0));
  EXPECT_FALSE(samples_cost_least(allowance_of(2), 1.0));
  EXPECT_TRUE(samples_cost_least(allowance_of(2), 1.0 / 8.0));
  EXPECT_TRUE(samples_cost_least(allowance_of(8, 1.0 / 8.0), 1.0)) << "EPS needs no more samples";
}

TEST(ErrorBound, AddsUpInAnyOrder) {
  const ErrorBound a = ErrorBound::of(0.25), b{0.5, 2.0, false}, c = ErrorBound::unknown();
  const ErrorBound one = a + b + c, other = c + b + a;
  EXPECT_EQ(one.error, 0.75);
  EXPECT_EQ(other.error, one.error);
  EXPECT_EQ(one.contrast, 2.0);
  EXPECT_TRUE(one.unbounded && other.unbounded);
  EXPECT_FALSE((a + b).unbounded);
}

}  // namespace
}  // namespace asos::test::choose_test
