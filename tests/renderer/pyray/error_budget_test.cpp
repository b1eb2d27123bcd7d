#include "renderer/pyray/error_budget.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace asos::test::allowance_test {
namespace {

ErrorBudget allowance_of(int max_level, double eps = 1.0 / 256.0) {
  RenderSettings settings{.asos = {.max_level = max_level, .eps = eps}};
  return ErrorBudget::of(settings);
}

// AgX displays differences between dark colours enlarged. The allowed error shrinks accordingly,
// for leaves and for the pyrays that they start.
TEST(ErrorBudget, SteepToneCurveDividesEps) {
  RenderSettings settings{.asos = {.eps = 1.0 / 64.0}};
  const ErrorBudget plain = ErrorBudget::of(settings);
  EXPECT_EQ(plain.eps, settings.asos.eps);
  settings.judged_tone = ToneCurve::agx;
  const ErrorBudget steep = ErrorBudget::of(settings);
  const double times = steepness(ToneCurve::agx);
  EXPECT_GT(times, 1.5);
  EXPECT_NEAR(steep.eps * times, plain.eps, 1e-9);
  EXPECT_NEAR(static_cast<double>(steep.tolerance) * times, static_cast<double>(plain.tolerance),
              1e-6);
  EXPECT_NEAR(static_cast<double>(steep.nested(1, 0.5, 0).tolerance) * times,
              static_cast<double>(plain.nested(1, 0.5, 0).tolerance), 1e-6);
}

TEST(ErrorBudget, MaxBoundsSamplesByFourForEachFinestCell) {
  EXPECT_EQ(allowance_of(0).most_samples(1.0), 1.0);
  EXPECT_EQ(allowance_of(1).most_samples(1.0), 16.0);
  EXPECT_EQ(allowance_of(3).most_samples(1.0), 256.0);
  EXPECT_EQ(allowance_of(3).most_samples(0.25), 64.0);
  EXPECT_EQ(allowance_of(3).most_samples(1e-9), 1.0) << "every part has at least one sample";
  for (int max_level = 0; max_level <= max_level_limit; ++max_level) {
    const ErrorBudget error_budget = allowance_of(max_level, 0.0);
    for (double part = 1.0; part > 1e-6; part *= 0.7) {
      EXPECT_LE(error_budget.samples(part, 1.0), error_budget.most_samples(part));
      EXPECT_LE(error_budget.pilot_samples(part), error_budget.most_samples(part));
      EXPECT_TRUE(std::has_single_bit(error_budget.pilot_samples(part)));
    }
  }
}

TEST(ErrorBudget, EpsEndsSamplesSooner) {
  // 0.35 n^(-3/4) equals half of EPS.
  const double converged = std::pow(0.35 / (0.5 / 64.0), 4.0 / 3.0);
  EXPECT_NEAR(allowance_of(5, 1.0 / 64.0).samples(1.0, 1.0), converged, 1e-6);
  EXPECT_NEAR(allowance_of(5, 1.0 / 64.0).samples(1.0, 0.5), converged * std::pow(0.5, 4.0 / 3.0),
              1e-6);
  EXPECT_EQ(allowance_of(5, 1.0).samples(1.0, 1.0), 1.0);
  EXPECT_EQ(allowance_of(2, 0.0).samples(1.0, 1.0), 64.0) << "only MAX limits the samples";
  EXPECT_GT(allowance_of(8, 0.0).tolerance, 0.0f) << "smaller errors are invisible";
}

TEST(ErrorBudget, ASplitCostsAtLeastItsFourQuarters) {
  for (const double eps : {1.0 / 256.0, 1.0 / 16.0, 0.1, 0.25, 1.0})
    EXPECT_GE(allowance_of(4, eps).leaves(1.01 * eps), 4.0) << eps;
}

TEST(ErrorBudget, PartsWithoutAreaUseAllLevels) {
  EXPECT_EQ(ErrorBudget::levels_of(1.0), 0);
  EXPECT_EQ(ErrorBudget::levels_of(1.0 / 64.0), 3);
  EXPECT_GT(ErrorBudget::levels_of(std::numeric_limits<double>::denorm_min()), max_level_limit);
  EXPECT_GT(ErrorBudget::levels_of(0.0), max_level_limit);
}

// Errors of a pixel's parts are independent, so that their sum stays within EPS.
TEST(ErrorBudget, PartsTogetherErrAsOnePixel) {
  for (int max_level = 1; max_level <= 5; ++max_level) {
    const ErrorBudget pixel = allowance_of(max_level);
    double variance = 0.0, nested_variance = 0.0;
    for (const double part : {0.5, 0.25, 0.125, 0.0625, 0.0625}) {
      variance += std::pow(part * pixel.standard_error(part), 2.0);
      const ErrorBudget leaf = pixel.of_part(part).nested(ErrorBudget::levels_of(part), 1.0, 1);
      for (const double half : {0.5, 0.5}) {
        const ErrorBudget again = leaf.of_part(half).nested(ErrorBudget::levels_of(half), 1.0, 1);
        nested_variance += std::pow(part * half * again.standard_error(1.0), 2.0);
      }
    }
    EXPECT_NEAR(std::sqrt(variance), 0.5 / 256.0, 1e-9) << max_level;
    EXPECT_NEAR(std::sqrt(nested_variance), 0.5 / 256.0, 1e-9) << max_level;
  }
}

// Contrast that the pilot's samples miss by chance leaves an error of a few EPS in the pixel.
TEST(ErrorBudget, PilotLeavesLittleToChance) {
  const ErrorBudget error_budget = allowance_of(4);
  for (double part = 1.0 / 16.0; part > 1e-6; part *= 0.9) {
    const double samples = error_budget.pilot_samples(part);
    EXPECT_LE(0.5 * part / std::sqrt(samples), 3.0 * error_budget.eps) << part;
  }
}

// Each level leaves a quarter of the centre's error.
TEST(ErrorBudget, LeavesGrowWithTheError) {
  const ErrorBudget error_budget = allowance_of(4);
  const double tolerance = static_cast<double>(error_budget.tolerance);
  EXPECT_EQ(error_budget.leaves(0.5 * tolerance), 4.0) << "split once at least";
  EXPECT_EQ(error_budget.leaves(8.0 * tolerance), 16.0);
  EXPECT_EQ(error_budget.leaves(1.0), 0.25 / tolerance) << "no more than usual contrast needs";
}

}  // namespace
}  // namespace asos::test::allowance_test
