#include "renderer/reflections/blur_kernel.h"

#include "renderer/reflections/horizon.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace asos {
namespace {

const LeafRegion whole{{0.0f, 0.0f, 1.0f}, {}};

/// Integral of the kernel over the area where `holds` is true, by the centres of n x n cells.
template <typename Holds>
double brute_force(double share_u, double share_v, Holds holds) {
  constexpr int n = 1000;
  const auto trapezoid = [](double share, double x) {
    const double ramp = std::min(share, 1.0 - share);
    const double from_side = std::min(x, 1.0 - x);
    return (ramp > 0.0 && from_side < ramp ? from_side / ramp : 1.0) / (1.0 - ramp);
  };
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = (i + 0.5) / n, v = (j + 0.5) / n;
      if (holds(u, v)) sum += trapezoid(share_u, u) * trapezoid(share_v, v);
    }
  }
  return sum / (n * n);
}

class EveryShare : public testing::TestWithParam<double> {};

TEST_P(EveryShare, OfTheWholeSquareIsOne) {
  EXPECT_NEAR(BlurKernel({GetParam(), 0.3}).integral(whole), 1.0, 1e-12);
  const std::array<BorderEdge, 4> sides{
      {{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{0, 1}, {0, 0}}}};
  EXPECT_NEAR(BlurKernel({GetParam(), 0.3}).integral({whole.square, sides}), 1.0, 1e-6);
}

TEST_P(EveryShare, OfPartsWithStraightSidesIsExact) {
  const double share = GetParam();
  const BlurKernel kernel({share, 0.2});
  const std::array<BorderEdge, 3> sides{{{{0.05f, 0.1f}, {0.9f, 0.3f}},
                                         {{0.9f, 0.3f}, {0.4f, 0.95f}},
                                         {{0.4f, 0.95f}, {0.05f, 0.1f}}}};
  const double expected = brute_force(share, 0.2, [&](double u, double v) {
    return winds_around(sides, glm::vec2(static_cast<float>(u), static_cast<float>(v)));
  });
  EXPECT_NEAR(kernel.integral({whole.square, sides}), expected, 1e-3);
  const LeafRegion quarter{{0.5f, 0.0f, 0.5f}, {}};
  EXPECT_NEAR(kernel.integral(quarter), 0.25, 1e-12);
}

TEST_P(EveryShare, OfAHalfPlaneIsItsClosedForm) {
  // The half-plane left of x: the integral of two convolved boxes.
  const double share = GetParam();
  const BlurKernel kernel({share, 0.5});
  const double ramp = std::min(share, 1.0 - share);
  for (const float x : {0.03f, 0.2f, 0.5f, 0.77f, 0.99f}) {
    const std::array<BorderEdge, 4> sides{
        {{{0, 0}, {x, 0}}, {{x, 0}, {x, 1}}, {{x, 1}, {0, 1}}, {{0, 1}, {0, 0}}}};
    const auto ramp_integral = [&](double at) {
      return at <= 0.0 ? 0.0 : at < ramp ? 0.5 * at * at / ramp : at - 0.5 * ramp;
    };
    const auto left = static_cast<double>(x);
    const double expected =
        (ramp_integral(left) -
         (ramp > 0.0 ? std::pow(std::max(0.0, left - 1.0 + ramp), 2.0) / (2.0 * ramp) : 0.0)) /
        (1.0 - ramp);
    EXPECT_NEAR(kernel.integral({whole.square, sides}), expected, 1e-6) << x;
  }
}

TEST_P(EveryShare, WarpsUniformPointsToItsOwnDistribution) {
  const BlurKernel kernel({GetParam(), 0.1});
  const LeafRegion left{{0.25f, 0.5f, 0.25f}, {}}, right{{0.5f, 0.5f, 0.25f}, {}};
  const double expected = kernel.integral(left) / (kernel.integral(left) + kernel.integral(right));
  const Bounds2 both{{0.25f, 0.5f}, {0.75f, 0.75f}};
  constexpr int n = 4096;
  int found = 0;
  for (int i = 0; i < n; ++i) {
    const float u = 0.25f + 0.5f * (static_cast<float>(i) + 0.5f) / n;
    const glm::vec2 at = kernel.warped({u, 0.6f}, both);
    EXPECT_GE(at.y, both.lo.y);
    EXPECT_LE(at.y, both.hi.y);
    found += at.x < 0.5f;
  }
  EXPECT_NEAR(found / static_cast<double>(n), expected, 1.0 / n);
}

TEST_P(EveryShare, MatchesTheMomentsOfItsUniformApproximation) {
  const BlurKernel kernel({GetParam(), 0.1});
  for (const glm::vec2 range : {glm::vec2(0, 1), {0.25f, 0.5f}, {0.1f, 0.95f}, {0.5f, 1.0f}}) {
    // The integrals of strips, as masses at their centres.
    constexpr int n = 4000;
    double mass = 0.0, first = 0.0, second = 0.0;
    for (int i = 0; i < n; ++i) {
      const float x = range.x + (range.y - range.x) * static_cast<float>(i) / n;
      const float to = range.x + (range.y - range.x) * static_cast<float>(i + 1) / n;
      const std::array<BorderEdge, 4> sides{
          {{{x, 0}, {to, 0}}, {{to, 0}, {to, 1}}, {{to, 1}, {x, 1}}, {{x, 1}, {x, 0}}}};
      const double m = kernel.integral({whole.square, sides});
      const double at = 0.5 * (static_cast<double>(x) + static_cast<double>(to));
      mass += m, first += m * at, second += m * at * at;
    }
    const Bounds2 found = kernel.uniform_like({{range.x, 0.0f}, {range.y, 1.0f}});
    const double mean = first / mass, half = std::sqrt(3.0 * (second / mass - mean * mean));
    EXPECT_NEAR(found.lo.x, mean - half, 1e-3) << range.x;
    EXPECT_NEAR(found.hi.x, mean + half, 1e-3) << range.x;
    // The other coordinate is not cut: its width is the root of the sum of the boxes' squared
    // widths.
    EXPECT_NEAR(found.hi.y - found.lo.y, std::hypot(0.1, 0.9), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryShare, testing::Values(0.0, 0.1, 0.4, 0.5, 0.9, 1.0));

TEST(Horizon, SharesTheSquare) {
  EXPECT_EQ((Horizon{1.0, 0.5, 0.5}).share_above(), 1.0);
  EXPECT_FALSE((Horizon{1.0, 0.5, 0.5}).line());
  EXPECT_EQ((Horizon{-1.0, 0.5, 0.5}).share_above(), 0.0);
  EXPECT_NEAR((Horizon{0.25, 1.0, 0.0}).share_above(), 0.75, 1e-12);
  EXPECT_NEAR((Horizon{0.0, 1.0, 1.0}).share_above(), 0.5, 1e-12);
  // A corner with sides of 0.4 is cut off.
  EXPECT_NEAR((Horizon{0.6, 1.0, 1.0}).share_above(), 1.0 - 0.08, 1e-12);
  const auto line = Horizon{0.25, 1.0, 0.0}.line();
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->first.x, 0.25f, 1e-6f);
  EXPECT_NEAR(line->second.x, 0.25f, 1e-6f);
}

}  // namespace
}  // namespace asos
