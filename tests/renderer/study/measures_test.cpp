#include "renderer/study/measures.h"

#include "renderer/study/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace asos {
namespace {

Film grey(int width, int height, float value) {
  Film film(width, height);
  for (glm::vec3& v : film.radiance) v = glm::vec3(value);
  return film;
}

TEST(Measures, EqualPicturesHaveNoError) {
  const Film film = grey(3, 2, 0.4f);
  const Measures m = measure(film, film);
  for (const double value :
       {m.rmse, m.rmse_raw, m.mae, m.p99, m.p999, m.max, m.rmse_display, m.perceptual})
    EXPECT_EQ(value, 0.0);
}

// Four pixels; one differs by (0.3, 0, 0.6), with a mean square of 0.15.
TEST(Measures, AreTheHandComputedOnes) {
  const Film reference = grey(2, 2, 0.25f);
  Film film = reference;
  film.radiance[2] = {0.55f, 0.25f, 0.85f};
  const Measures m = measure(film, reference);
  EXPECT_NEAR(m.rmse, std::sqrt(0.15 / 4.0), 1e-7);
  EXPECT_NEAR(m.rmse_raw, m.rmse, 1e-12);
  EXPECT_NEAR(m.mae, 0.9 / 12.0, 1e-7);
  EXPECT_NEAR(m.max, std::sqrt(0.15), 1e-7);
  EXPECT_NEAR(m.p99, std::sqrt(0.15), 1e-7);  // rank 4 of 4
}

TEST(Measures, ClipWhatADisplayClips) {
  const Film reference = grey(1, 1, 1.5f);
  const Film film = grey(1, 1, 4.5f);
  const Measures m = measure(film, reference);
  EXPECT_EQ(m.rmse, 0.0);
  EXPECT_EQ(m.rmse_display, 0.0);
  EXPECT_EQ(m.perceptual, 0.0);
  EXPECT_NEAR(m.rmse_raw, 3.0, 1e-6);
}

TEST(Measures, TheDisplayTransformIsSrgb) {
  // 0.0031308 is the end of the linear piece; 0.5 is displayed as 0.7354.
  const Measures m = measure(grey(1, 1, 0.5f), grey(1, 1, 0.002f));
  EXPECT_NEAR(m.rmse_display, 0.735357 - 12.92 * 0.002, 1e-5);
}

// Greys differ only in lightness: black and white by 100 / S_L = 100 / 1, because their mean is 50.
TEST(Measures, ThePerceptualOneIsCiede2000) {
  EXPECT_NEAR(measure(grey(2, 1, 1.0f), grey(2, 1, 0.0f)).perceptual, 100.0, 1e-6);
}

TEST(Measures, PercentilesGoByNearestRank) {
  const Film reference(1000, 1);
  Film film = reference;
  for (int i = 0; i < 1000; ++i)
    film.radiance[static_cast<std::size_t>(i)] = glm::vec3(static_cast<float>(i + 1) / 1000.0f);
  const Measures m = measure(film, reference);
  EXPECT_NEAR(m.p99, 0.990, 1e-6);
  EXPECT_NEAR(m.p999, 0.999, 1e-6);
  EXPECT_NEAR(m.max, 1.0, 1e-6);
}

TEST(Measures, WhatIsNoNumberNeverPassesUnseen) {
  const Film reference = grey(1, 1, 0.25f);
  Film film = reference;
  film.radiance[0].y = std::numeric_limits<float>::quiet_NaN();
  const Measures m = measure(film, reference);
  EXPECT_GT(m.rmse, 0.4);
  EXPECT_TRUE(std::isfinite(m.rmse));
  EXPECT_TRUE(std::isinf(m.rmse_raw));
}

TEST(RegionErrors, AddUpToTheWhole) {
  const Film reference = grey(4, 1, 0.5f);
  Film film = reference;
  film.radiance[0] = glm::vec3(0.8f);  // squared error 0.09
  film.radiance[1] = glm::vec3(0.6f);  // 0.01
  const RegionErrors errors = region_errors(
      film, reference, {Region::outlines, Region::penumbrae, Region::penumbrae, Region::rest});
  EXPECT_EQ(errors[0].pixels, 1u);
  EXPECT_NEAR(errors[0].rmse, 0.3, 1e-6);
  EXPECT_NEAR(errors[0].share, 0.9, 1e-6);
  EXPECT_EQ(errors[1].pixels, 2u);
  EXPECT_NEAR(errors[1].rmse, std::sqrt(0.005), 1e-6);
  EXPECT_NEAR(errors[1].share, 0.1, 1e-6);
  EXPECT_EQ(errors[2].pixels, 0u);
  EXPECT_EQ(errors[4].share, 0.0);
}

// Halves are weighted by samples; for a constant difference d between them, the noise is d / 2.
TEST(Reference, IsTheMeanAndKnowsItsNoise) {
  Reference reference;
  reference.add(grey(2, 2, 0.2f), grey(2, 2, 0.4f), 64);
  EXPECT_NEAR(reference.noise(), 0.1, 1e-6);
  reference.add(grey(2, 2, 0.5f), grey(2, 2, 0.3f), 192);
  // Halves: (0.2 + 3 * 0.5) / 4 and (0.4 + 3 * 0.3) / 4.
  EXPECT_NEAR(reference.film().radiance[3].y, 0.375, 1e-6);
  EXPECT_NEAR(reference.noise(), 0.05, 1e-6);
  EXPECT_EQ(reference.samples(), 512);
  EXPECT_EQ(reference.passes(), 2);
}

// Independent noise with standard deviation s in each half leaves s / sqrt 2 in their mean.
TEST(Reference, ItsNoiseIsTheStandardErrorOfTheMean) {
  std::mt19937 random(11);
  std::normal_distribution<float> normal(0.0f, 0.05f);
  Film first(200, 200);
  Film second(200, 200);
  for (Film* film : {&first, &second})
    for (glm::vec3& v : film->radiance)
      v = glm::vec3(0.5f + normal(random), 0.5f + normal(random), 0.5f + normal(random));
  Reference reference;
  reference.add(first, second, 1);
  EXPECT_NEAR(reference.noise(), 0.05 / std::sqrt(2.0), 5e-4);
  // The noise equals the true error; the exact value is 0.5.
  EXPECT_NEAR(root_mean_square(reference.film(), grey(200, 200, 0.5f), true), reference.noise(),
              5e-4);
}

}  // namespace
}  // namespace asos
