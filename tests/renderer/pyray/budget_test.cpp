#include "renderer/pyray/budget.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos::test::budget_test {
namespace {

// AgX shows differences of dark colours larger than they are: what may be off is as much less, for
// leaves as for the pyrays that they send on.
TEST(Budget, ASteepCurveLeavesAsMuchLessToBeOff) {
  RenderSettings settings;
  settings.asos.eps = 1.0 / 64.0;
  for (const int max_level : {2, 3}) {
    settings.asos.max_level = max_level;
    settings.judged_tone = ToneCurve::none;
    const Budget plain = Budget::of(settings);
    EXPECT_EQ(plain.eps, settings.asos.eps);
    settings.judged_tone = ToneCurve::neutral;
    EXPECT_EQ(Budget::of(settings).tolerance, plain.tolerance);
    settings.judged_tone = ToneCurve::agx;
    const Budget steep = Budget::of(settings);
    const double times = steepness(ToneCurve::agx);
    EXPECT_GT(times, 1.5);
    EXPECT_NEAR(steep.eps * times, plain.eps, 1e-9);
    EXPECT_NEAR(static_cast<double>(steep.tolerance) * times, static_cast<double>(plain.tolerance),
                1e-6);
    // Of what a mirror shows by half.
    EXPECT_NEAR(static_cast<double>(steep.nested(1, 0.5, 0).tolerance) * times,
                static_cast<double>(plain.nested(1, 0.5, 0).tolerance), 1e-6);
  }
  settings.asos.refine_shading = false;
  EXPECT_TRUE(std::isinf(Budget::of(settings).tolerance));
}

}  // namespace
}  // namespace asos::test::budget_test
