#include "renderer/pyray/estimate.h"
#include "renderer/pyray/tuning.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

namespace asos::test::choose_test {
namespace {

ErrorBudget allowance_of(int max_level, double eps = 1.0 / 256.0) {
  RenderSettings settings{.asos = {.max_level = max_level, .eps = eps}};
  return ErrorBudget::of(settings);
}

struct Choice {
  ErrorBound centre;
  double weight = 1.0;
  std::optional<double> price = 3.0;
};

Choice leaf_of(double error) {
  return {ErrorBound::of(error)};
}

Estimator choose(const ErrorBudget& error_budget, const Choice& leaf) {
  return asos::choose(error_budget, leaf.weight, leaf.centre, {0.0, leaf.price});
}

TEST(Choose, ChoosesCentreWithinTheAllowance) {
  EXPECT_EQ(choose(allowance_of(3), leaf_of(1.0 / 256.0)), Estimator::centre);
  EXPECT_EQ(choose(allowance_of(3), leaf_of(0.0)), Estimator::centre);
  EXPECT_NE(choose(allowance_of(3), leaf_of(1.01 / 256.0)), Estimator::centre);
  EXPECT_EQ(choose(allowance_of(3, 1.0 / 16.0), leaf_of(1.01 / 256.0)), Estimator::centre);
}

TEST(Choose, SamplesWithoutABound) {
  Choice leaf = leaf_of(0.0);
  leaf.centre += ErrorBound::unknown();
  EXPECT_EQ(choose(allowance_of(3), leaf), Estimator::samples);
  leaf.price.reset();
  EXPECT_EQ(choose(allowance_of(3), leaf), Estimator::samples);
}

TEST(Choose, ChoosesCheaperOfSplitAndSamples) {
  // An error of twice the tolerance; a split costs four leaves.
  Choice leaf = leaf_of(2.0 / 256.0);
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
  Choice leaf = leaf_of(1.0);
  leaf.price.reset();
  leaf.weight = 1.0 / 256.0;  // a cell at level MAX 4: four samples
  const double of_samples = ErrorBudget::error_of_samples(4.0, ErrorBudget::usual_contrast);
  leaf.centre.error = 1.02 * of_samples;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::samples);
  leaf.centre.error = 0.98 * of_samples;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::centre);
  leaf.centre.contrast = 4.0;
  leaf.centre.error = 1.02 * of_samples;
  EXPECT_EQ(choose(allowance_of(4), leaf), Estimator::centre) << "highlights make samples noisy";
}

TEST(Choose, InfiniteErrorIsNeverTheCentre) {
  Choice leaf = leaf_of(std::numeric_limits<double>::infinity());
  EXPECT_NE(choose(allowance_of(3), leaf), Estimator::centre);
  leaf.price.reset();
  EXPECT_NE(choose(allowance_of(3), leaf), Estimator::centre);
}

bool samples_cost_least(const ErrorBudget& error_budget, double weight,
                        const EstimatorCosts& costs = {LeafCosts::exact_leaf}) {
  return asos::choose(error_budget, weight, ErrorBound::none(), costs) == Estimator::samples;
}

TEST(Choose, SmallMaxLeavesAllToSamples) {
  EXPECT_TRUE(samples_cost_least(allowance_of(1), 1.0));
  EXPECT_FALSE(samples_cost_least(allowance_of(2), 1.0));
  EXPECT_TRUE(samples_cost_least(allowance_of(2), 1.0 / 8.0));
  EXPECT_TRUE(samples_cost_least(allowance_of(8, 1.0 / 8.0), 1.0)) << "EPS needs no more samples";
}

TEST(Choose, SamplesReplaceACentreThatCostsAsMuch) {
  const ErrorBudget error_budget = allowance_of(3);
  const double samples = error_budget.samples(1.0 / 16.0, 0.5);
  EXPECT_TRUE(samples_cost_least(error_budget, 1.0 / 16.0, {1.01 * samples, {}, 0.5}));
  EXPECT_FALSE(samples_cost_least(error_budget, 1.0 / 16.0, {0.99 * samples, {}, 0.5}));
  EXPECT_TRUE(samples_cost_least(allowance_of(1), 1.0, {16.0, {}, 1.0})) << "MAX allows no more";
  RenderSettings settings{.asos = {.refine_shading = false}};
  EXPECT_FALSE(samples_cost_least(ErrorBudget::of(settings), 1.0, {1e9, {}, 0.5}))
      << "nothing is sampled";
  EXPECT_FALSE(ErrorBudget::of(settings).refines());
}

TEST(Estimate, IsWithinAnAllowanceIfItsErrorIsBounded) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(Estimate::exact(glm::dvec3(1.0)).within(0.0));
  EXPECT_TRUE((Estimate{glm::dvec3(1.0), 0.5}.within(0.5)));
  EXPECT_FALSE((Estimate{glm::dvec3(1.0), 0.5}.within(0.25)));
  EXPECT_TRUE((Estimate{glm::dvec3(1.0), 0.5}.within(infinity)));
  EXPECT_FALSE(Estimate{}.within(infinity)) << "nothing is known of its error";
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
