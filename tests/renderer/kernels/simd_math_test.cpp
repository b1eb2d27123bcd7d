#include "renderer/kernels/simd_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

// The kernels' math functions against the standard library, with the baseline's lanes.
// light_kernel_test checks that all instruction sets give equal bits.

namespace asos::test::simd_math_test {
namespace {

namespace lanes = asos::HWY_NAMESPACE;
using DoubleLane = lanes::LaneOf<hwy::HWY_NAMESPACE::CappedTag<double, 1>>;
using FloatLane = lanes::LaneOf<hwy::HWY_NAMESPACE::CappedTag<float, 1>>;
constexpr int steps = 200'000;

TEST(SimdMath, SineAndCosineOfAnEighthOfATurn) {
  double worst = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const auto x = static_cast<float>((2.0 * i / steps - 1.0) * 0.25 * std::numbers::pi);
    const auto found = sin_cos_of_eighth(FloatLane(x));
    const double sin = hwy::HWY_NAMESPACE::GetLane(found.sin.raw);
    const double cos = hwy::HWY_NAMESPACE::GetLane(found.cos.raw);
    if (x != 0.0f) worst = std::max(worst, std::abs(sin / std::sin(double{x}) - 1.0));
    worst = std::max(worst, std::abs(cos / std::cos(double{x}) - 1.0));
  }
  EXPECT_LT(worst, 1.6e-7);
  EXPECT_GT(worst, 1e-9) << "floats cannot be that good: this test looks wrong";
}

TEST(SimdMath, SineAndCosineOfAWholeTurn) {
  double worst = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double x = 2.0 * std::numbers::pi * i / steps;
    const auto found = sin_cos(DoubleLane(x));
    worst = std::max(worst, std::abs(hwy::HWY_NAMESPACE::GetLane(found.sin.raw) - std::sin(x)));
    worst = std::max(worst, std::abs(hwy::HWY_NAMESPACE::GetLane(found.cos.raw) - std::cos(x)));
  }
  EXPECT_LT(worst, 5e-16);
}

TEST(SimdMath, ArcTangentAllAround) {
  const auto found = [](double y, double x) {
    return hwy::HWY_NAMESPACE::GetLane(arc_tangent(DoubleLane(y), DoubleLane(x)).raw);
  };
  double worst = 0.0;
  for (const double length : {1e-30, 1e-6, 1.0, 1e30}) {
    for (int i = 1; i < steps; ++i) {
      const double angle = (2.0 * i / steps - 1.0) * std::numbers::pi;
      const double y = length * std::sin(angle), x = length * std::cos(angle);
      const double expected = std::atan2(y, x);
      if (expected != 0.0) worst = std::max(worst, std::abs(found(y, x) / expected - 1.0));
    }
    // Small angles, where only the relative error matters.
    for (double y = 1.0; y > 1e-20; y *= 0.37)
      worst = std::max(worst, std::abs(found(length * y, length) / std::atan2(y, 1.0) - 1.0));
  }
  EXPECT_LT(worst, 2e-15);
  EXPECT_EQ(found(0.0, 0.0), 0.0);
  EXPECT_EQ(found(0.0, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(found(0.0, -1.0), std::numbers::pi);
  EXPECT_DOUBLE_EQ(found(1.0, 0.0), 0.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(found(-1.0, 0.0), -0.5 * std::numbers::pi);
}

TEST(SimdMath, CubeRootAndArcSine) {
  double worst_root = 0.0, worst_arc = 0.0;
  for (double x = 1e-30; x < 1e30; x *= 1.37) {
    const double root = hwy::HWY_NAMESPACE::GetLane(cbrt(DoubleLane(x)).raw);
    worst_root = std::max(worst_root, std::abs(root / std::cbrt(x) - 1.0));
  }
  for (int i = 1; i <= steps; ++i) {
    const double x = 2.0 * i / steps - 1.0;
    const double arc = hwy::HWY_NAMESPACE::GetLane(asin(DoubleLane(x)).raw);
    worst_arc = std::max(worst_arc, std::abs(arc - std::asin(x)));
  }
  EXPECT_LT(worst_root, 1e-15);
  EXPECT_LT(worst_arc, 1e-15);
  EXPECT_EQ(hwy::HWY_NAMESPACE::GetLane(cbrt(DoubleLane(0.0)).raw), 0.0);
}

}  // namespace
}  // namespace asos::test::simd_math_test
