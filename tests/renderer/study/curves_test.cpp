#include "renderer/study/curves.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace asos {
namespace {

// error = 0.1 / sqrt(seconds): a hundred times longer for a tenth of the error.
const std::array square_root{CurvePoint{1, 0.1}, CurvePoint{4, 0.05}, CurvePoint{100, 0.01}};

TEST(Curves, ReadsBetweenPointsOfAPowerLawExactly) {
  const auto seconds = seconds_at_error(square_root, 0.02);
  ASSERT_TRUE(seconds);
  EXPECT_NEAR(seconds->value, 25.0, 1e-9);
  EXPECT_FALSE(seconds->beyond);
  const auto error = error_at_seconds(square_root, 25.0);
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->value, 0.02, 1e-12);
  EXPECT_FALSE(error->beyond);
}

TEST(Curves, GoesOnBeyondItsEndsAndSaysSo) {
  const auto finer = seconds_at_error(square_root, 0.001);
  ASSERT_TRUE(finer);
  EXPECT_NEAR(finer->value, 10000.0, 1e-6);
  EXPECT_TRUE(finer->beyond);
  const auto coarser = error_at_seconds(square_root, 0.25);
  ASSERT_TRUE(coarser);
  EXPECT_NEAR(coarser->value, 0.2, 1e-12);
  EXPECT_TRUE(coarser->beyond);
}

TEST(Curves, ThePointsThemselvesAreNotBeyond) {
  for (const CurvePoint& p : square_root) {
    const auto seconds = seconds_at_error(square_root, p.error);
    ASSERT_TRUE(seconds);
    EXPECT_NEAR(seconds->value, p.seconds, 1e-9 * p.seconds);
    EXPECT_FALSE(seconds->beyond);
  }
}

TEST(Curves, KnowsNothingFromOnePointOrAFlatStep) {
  const std::array one{CurvePoint{1, 0.1}};
  EXPECT_FALSE(seconds_at_error(one, 0.05));
  EXPECT_FALSE(error_at_seconds({}, 1.0));
  const std::array flat{CurvePoint{1, 0.1}, CurvePoint{2, 0.1}};
  EXPECT_FALSE(seconds_at_error(flat, 0.05));
}

TEST(ErrorShownAt, IsThatOfTheLatestPicture) {
  const std::vector<CurvePoint> curve{{1.0, 0.5}, {2.0, 0.25}, {4.0, 0.3}};
  EXPECT_EQ(error_shown_at(curve, 0.9), std::nullopt);
  EXPECT_EQ(error_shown_at(curve, 1.0), 0.5);
  EXPECT_EQ(error_shown_at(curve, 3.9), 0.25);
  EXPECT_EQ(error_shown_at(curve, 100.0), 0.3) << "though an earlier one was better";
  EXPECT_EQ(error_shown_at({}, 1.0), std::nullopt);
}

TEST(ParetoFront, KeepsWhatNothingBeats) {
  const auto front = pareto_front({{4, 0.2}, {1, 0.5}, {3, 0.1}, {2, 0.6}, {9, 0.05}, {3, 0.3}});
  std::vector<std::pair<double, double>> kept;
  for (const CurvePoint& p : front) kept.emplace_back(p.seconds, p.error);
  const std::vector<std::pair<double, double>> expected{{1, 0.5}, {3, 0.1}, {9, 0.05}};
  EXPECT_EQ(kept, expected);
}

TEST(Slope, IsThePowerOfAPowerLaw) {
  EXPECT_NEAR(log_log_slope(square_root).value(), -0.5, 1e-12);
  const std::array steep{CurvePoint{0.5, std::pow(0.5, -1.7)}, CurvePoint{3, std::pow(3, -1.7)},
                         CurvePoint{8, std::pow(8, -1.7)}, CurvePoint{40, std::pow(40, -1.7)}};
  EXPECT_NEAR(log_log_slope(steep).value(), -1.7, 1e-12);
}

// By hand: log2 seconds 0, 1, 2 and log2 error 0, -2, -1 have a slope of -1/2.
TEST(Slope, IsTheLeastSquaresOne) {
  const std::array points{CurvePoint{1, 1}, CurvePoint{2, 0.25}, CurvePoint{4, 0.5}};
  EXPECT_NEAR(log_log_slope(points).value(), -0.5, 1e-12);
  EXPECT_FALSE(log_log_slope(std::array{CurvePoint{1, 1}}));
  EXPECT_FALSE(log_log_slope(std::array{CurvePoint{1, 1}, CurvePoint{1, 0.5}}));
}

TEST(Median, IsTheMiddle) {
  EXPECT_EQ(median({3, 1, 2}), 2.0);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_EQ(median({7}), 7.0);
}

}  // namespace
}  // namespace asos
