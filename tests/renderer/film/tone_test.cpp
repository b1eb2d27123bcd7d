#include "renderer/film/tone.h"

#include "renderer/film/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace asos {
namespace {

TEST(Tone, NoneIsTheClippedCurve) {
  for (const float ev : {-2.0f, 0.0f, 1.5f}) {
    for (const float r : {0.0f, 0.001f, 0.2f, 0.9f, 7.0f}) {
      const glm::vec3 radiance(r, 0.5f * r, 0.1f);
      EXPECT_EQ(display_bytes(radiance, {ev, ToneCurve::none}), display_bytes(radiance, ev));
      EXPECT_EQ(display_rgb(radiance, {ev, ToneCurve::none}), display_rgb(radiance, ev));
    }
  }
}

// The specification's guarantee: the diffuse part of a dielectric, with the surface's specular 0.04
// added, is displayed as its base colour, up to 0.8 - 0.04.
TEST(Tone, NeutralGivesBaseColoursBack) {
  for (const glm::vec3 base :
       {glm::vec3(0.1f, 0.5f, 0.7f), glm::vec3(0.3f), glm::vec3(0.75f, 0.05f, 0.05f)}) {
    const glm::vec3 shown = tone_mapped(base + 0.04f, {0.0f, ToneCurve::neutral});
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(shown[k], base[k], 2e-3f) << k;
  }
}

// For every curve: monotonic, reaches white, and stays within 0 to 1.
TEST(Tone, RisesWithinTheScreensRange) {
  for (const NamedTone& tone : tone_names) {
    if (tone.value == ToneCurve::none) continue;
    for (const glm::vec3 hue : {glm::vec3(1.0f), glm::vec3(1.0f, 0.3f, 0.1f)}) {
      float before = -1.0f;
      for (float r = 1e-6f; r < 1e6f; r *= 1.1f) {
        const glm::vec3 shown = tone_mapped(r * hue, {0.0f, tone.value});
        EXPECT_GE(std::min({shown.x, shown.y, shown.z}), 0.0f) << tone.name << " " << r;
        EXPECT_LE(std::max({shown.x, shown.y, shown.z}), 1.0f) << tone.name << " " << r;
        const float luminance = glm::dot(shown, glm::vec3(0.2126f, 0.7152f, 0.0722f));
        const float dip = tone.value == ToneCurve::agx ? 0.1f / 255.0f : 1e-6f;  // see tone.h
        EXPECT_GE(luminance, before - dip) << tone.name << " " << r;
        before = std::max(before, luminance);
      }
      EXPECT_GT(before, 0.95f) << tone.name;
    }
  }
}

TEST(Tone, WhatIsJudgedIsWhatIsShown) {
  for (const glm::dvec3 radiance : {glm::dvec3(0.2, 0.5, 0.01), glm::dvec3(0.9, 3.0, 70.0)}) {
    EXPECT_EQ(displayed_intensity(radiance, ToneCurve::none), glm::min(radiance, 1.0));
    for (const ToneCurve curve : {ToneCurve::neutral, ToneCurve::agx})
      EXPECT_EQ(glm::vec3(displayed_intensity(radiance, curve)),
                tone_mapped(glm::vec3(radiance), {0.0f, curve}));
  }
}

// ASOS limits the error of radiance. If no channel falls, the displayed error is at most that times
// the curve's slope (Neutral adds two hundredths to the smallest channel, where bright hues fade).
// If the hue changes, Neutral's toe subtracts the smallest channel from all: the error is at most
// doubled.
TEST(Tone, NoDifferenceShowsLargerThanTheCurvesSteepnessSays) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const auto largest = [](glm::vec3 v) { return std::max({v.x, v.y, v.z}); };
  for (const NamedTone& tone : tone_names) {
    if (tone.value == ToneCurve::none) continue;
    float rising = 0.0f, any = 0.0f;
    for (int i = 0; i < 200000; ++i) {
      glm::vec3 a, rise;
      for (int k = 0; k < 3; ++k) {
        a[k] = std::exp2(-10.0f + 14.0f * unit(random));
        rise[k] = unit(random);
      }
      rise /= largest(rise);
      const float size = std::exp2(-7.0f + 7.0f * unit(random));  // 1/128 to 1
      const auto slope = [&](glm::vec3 b) {
        const DisplayTransform display{0.0f, tone.value};
        const glm::vec3 shown = tone_mapped(b, display) - tone_mapped(a, display);
        return largest(glm::abs(shown)) / largest(glm::abs(b - a));
      };
      rising = std::max(rising, slope(a + size * rise));
      any = std::max(any, slope(glm::max(a + size * (2.0f * rise - 1.0f), 0.0f)));
    }
    const auto steep = static_cast<float>(steepness(tone.value));
    EXPECT_LE(rising, 1.02f * steep) << tone.name;
    EXPECT_GT(rising, 0.9f * steep) << tone.name << ": the bound is too large";
    EXPECT_LE(any, 2.0f * steep) << tone.name;
  }
}

TEST(Tone, ExposureIsStops) {
  const glm::vec3 radiance(0.2f, 0.4f, 0.1f);
  for (const NamedTone& tone : tone_names)
    EXPECT_EQ(tone_mapped(2.0f * radiance, {0.0f, tone.value}),
              tone_mapped(radiance, {1.0f, tone.value}))
        << tone.name;
}

TEST(Tone, WhatIsNoNumberIsBlackAndInfinityIsWhite) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const NamedTone& tone : tone_names) {
    EXPECT_LT(display_bytes(glm::vec3(nan), {0.0f, tone.value}).x, 2) << tone.name;
    EXPECT_GT(display_bytes(glm::vec3(infinity), {0.0f, tone.value}).x, 250) << tone.name;
    EXPECT_LT(display_bytes(glm::vec3(-3.0f), {0.0f, tone.value}).x, 2) << tone.name;
  }
}

}  // namespace
}  // namespace asos
