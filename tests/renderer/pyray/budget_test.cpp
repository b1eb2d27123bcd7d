#include "renderer/pyray/budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

// What a small MAX leaves to samples is known as well as what is cut.
TEST(Budget, SamplesAreHeldToEpsWhateverMaxIs) {
  RenderSettings settings;
  const auto error = [&](int max_level, double eps) {
    settings.asos.max_level = max_level;
    settings.asos.eps = eps;
    return Budget::of(settings).for_samples().standard_error(1.0);
  };
  for (int max_level = 1; max_level <= 4; ++max_level)
    EXPECT_NEAR(error(max_level, 1.0 / 256.0), 0.5 / 256.0, 1e-9) << max_level;
  EXPECT_NEAR(error(0, 1.0 / 256.0), 0.5 / 4.0, 1e-9) << "one sample";
  EXPECT_NEAR(error(2, 0.0), 0.5 / 64.0, 1e-9) << "MAX alone decides";
  EXPECT_NEAR(error(2, 1.0 / 16.0), 0.5 / 16.0, 1e-9) << "EPS is larger than what MAX asks for";
  settings.asos.refine_shading = false;
  EXPECT_TRUE(std::isinf(error(2, 1.0 / 256.0))) << "nothing is sampled then";
}

// The samples of a mirror's parts err by as much together as those of a whole pixel, however deep
// these are and whatever they are divided into themselves.
TEST(Budget, WhatMirrorsSampleErrsAsAWholePixelDoes) {
  RenderSettings settings;
  for (settings.asos.max_level = 1; settings.asos.max_level <= 5; ++settings.asos.max_level) {
    const Budget pixel = Budget::of(settings);
    double variance = 0.0;
    for (const double weight : {0.5, 0.25, 0.125, 0.0625, 0.0625}) {
      const Budget leaf = pixel.of_part(weight).nested(Budget::levels_of(weight), 1.0, 1);
      for (const double part : {0.5, 0.5}) {
        const Budget again = leaf.of_part(part).nested(Budget::levels_of(part), 1.0, 1);
        const double error = weight * part * again.for_samples().standard_error(1.0);
        variance += error * error;
      }
    }
    EXPECT_NEAR(std::sqrt(variance), 0.5 / 256.0, 1e-9) << settings.asos.max_level;
  }
}

// What one thing at a time costs, many cost as many times; samples cost what their accuracy does.
TEST(Budget, SamplesTakeThePlaceOfManyParts) {
  RenderSettings settings;
  settings.asos.max_level = 3;
  const auto suffice = [&](double eps, double price, double weight = 1.0) {
    settings.asos.eps = eps;
    return Budget::of(settings).samples_suffice_for_parts(weight, price);
  };
  // 0.175 / EPS to the power 4/3, of a 16th of a pixel by 16 to the power 2/3 less.
  const double samples = std::pow(0.175 * 256.0, 4.0 / 3.0) / std::pow(16.0, 2.0 / 3.0);
  EXPECT_TRUE(suffice(1.0 / 256.0, 1.01 * samples, 1.0 / 16.0));
  EXPECT_FALSE(suffice(1.0 / 256.0, 0.99 * samples, 1.0 / 16.0));
  EXPECT_FALSE(suffice(1.0 / 16.0, 1e9)) << "few are enough";
  EXPECT_FALSE(suffice(1.0 / 256.0, 255.0)) << "four for each finest cell";
  EXPECT_TRUE(suffice(1.0 / 256.0, 257.0));
  settings.asos.max_level = 1;
  EXPECT_FALSE(suffice(1.0 / 256.0, 255.0)) << "held to EPS, for cuts are exact";
  EXPECT_TRUE(suffice(1.0 / 256.0, 257.0));
  settings.asos.max_level = 4;
  EXPECT_FALSE(suffice(1.0 / 256.0, 1023.0));
  EXPECT_TRUE(suffice(1.0 / 256.0, 1025.0));
  settings.asos.max_level = 5;
  EXPECT_FALSE(suffice(0.0, 1e9)) << "MAX alone decides";
  settings.asos.refine_shading = false;
  EXPECT_FALSE(suffice(1.0 / 256.0, 1e9)) << "nothing is sampled then";
}

// MAX 1 splits penumbrae as MAX 2 does; EPS and MAX 0 say what they say.
TEST(Budget, PenumbraeAreHeldToWhatMaxTwoAllowsAtLeast) {
  RenderSettings settings;
  const auto held_to = [&](int max_level, double eps) {
    settings.asos.max_level = max_level;
    settings.asos.eps = eps;
    return static_cast<double>(Budget::of(settings).penumbra_tolerance(2));
  };
  EXPECT_EQ(held_to(3, 1.0 / 256.0), 2.0 / 256.0);
  EXPECT_EQ(held_to(2, 1.0 / 256.0), 2.0 / 64.0);
  EXPECT_EQ(held_to(1, 1.0 / 256.0), 2.0 / 64.0);
  EXPECT_EQ(held_to(1, 1.0 / 32.0), 2.0 / 32.0);
  EXPECT_EQ(held_to(0, 1.0 / 256.0), 2.0 / 4.0);
  // Errors of many lights add up.
  const auto of_many = [&](std::size_t lights) {
    settings.asos.max_level = 2;
    settings.asos.eps = 1.0 / 256.0;
    return static_cast<double>(Budget::of(settings).penumbra_tolerance(lights));
  };
  EXPECT_EQ(of_many(4), 2.0 / 64.0);
  EXPECT_EQ(of_many(8), 2.0 / 128.0);
  EXPECT_EQ(of_many(1000), 2.0 / 256.0) << "EPS is enough";
  settings.asos.refine_shading = false;
  EXPECT_EQ(held_to(1, 1.0 / 256.0), std::numeric_limits<double>::infinity());
}

// Each level leaves a quarter of what a bent part's middle is off by.
TEST(Budget, BentPartsTakeAsManyLeavesAsTheyAreOff) {
  RenderSettings settings;
  const Budget budget = Budget::of(settings);
  const double tolerance = static_cast<double>(budget.tolerance);
  EXPECT_EQ(budget.leaves_of_bent(0.5 * tolerance), 4.0) << "split once at least";
  EXPECT_EQ(budget.leaves_of_bent(8.0 * tolerance), 16.0) << "whose errors are half a tolerance";
  EXPECT_EQ(budget.leaves_of_bent(1.0), budget.leaves_of_uneven()) << "until each of them is even";
}

}  // namespace
}  // namespace asos::test::budget_test
