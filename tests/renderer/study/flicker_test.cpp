#include "renderer/study/flicker.h"

#include "renderer/study/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace asos {
namespace {

Film grey_film(float value) {
  Film film(4, 3);
  for (glm::vec3& v : film.radiance) v = glm::vec3(value);
  return film;
}

TEST(Flicker, AnErrorThatStaysDoesNotFlicker) {
  FlickerMeter meter;
  for (const float light : {0.2f, 0.5f, 0.3f}) meter.add(grey_film(light + 0.1f), grey_film(light));
  EXPECT_NEAR(meter.flicker(), 0.0, 1e-7);
  EXPECT_NEAR(meter.step(), 0.0, 1e-7);
  EXPECT_NEAR(meter.steady(), 0.1, 1e-7);
  EXPECT_NEAR(meter.rmse(), 0.1, 1e-7);
}

// Errors a sin(2 pi k f / F) over whole periods have mean 0 and mean square a^2 / 2; between frames
// they change by 2 a sin(pi k / F) cos(...).
TEST(Flicker, OfASineIsItsAmplitudeOverTheRootOfTwo) {
  constexpr int frames = 64, waves = 3;
  constexpr double amplitude = 0.25;
  FlickerMeter meter;
  for (int f = 0; f < frames + 1; ++f) {
    const double phase = 2.0 * std::numbers::pi * waves * f / frames;
    const auto error = static_cast<float>(0.1 + amplitude * std::sin(phase));
    if (f == frames) {  // whole periods of steps, too
      EXPECT_NEAR(meter.flicker(), amplitude / std::numbers::sqrt2, 1e-6);
      EXPECT_NEAR(meter.steady(), 0.1, 1e-6);
      EXPECT_NEAR(meter.rmse(), std::hypot(amplitude / std::numbers::sqrt2, 0.1), 1e-6);
    }
    meter.add(grey_film(0.5f + error), grey_film(0.5f));
  }
  EXPECT_NEAR(meter.step(),
              2.0 * amplitude * std::sin(std::numbers::pi * waves / frames) / std::numbers::sqrt2,
              1e-6);
}

TEST(Flicker, WithTheSteadyPartIsTheWholeError) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(-0.2f, 1.2f);
  FlickerMeter meter;
  double squares = 0.0;
  for (int f = 0; f < 9; ++f) {
    Film film = grey_film(0.0f), reference = grey_film(0.0f);
    for (glm::vec3& v : film.radiance) v = {any(random), any(random), any(random)};
    for (glm::vec3& v : reference.radiance) v = {any(random), any(random), any(random)};
    meter.add(film, reference);
    squares += std::pow(root_mean_square(film, reference, true), 2.0);
  }
  EXPECT_NEAR(meter.rmse(), std::sqrt(squares / 9.0), 1e-12);
  EXPECT_GT(meter.flicker(), meter.steady());
  double of_pixels = 0.0;
  for (const double v : meter.map()) of_pixels += v * v / 12.0;
  EXPECT_NEAR(std::sqrt(of_pixels), meter.flicker(), 1e-12);
}

TEST(Flicker, OfOnePixelInOneFrameIsFoundThere) {
  FlickerMeter meter;
  for (int f = 0; f < 4; ++f) {
    Film film = grey_film(0.5f);
    if (f == 2) film.radiance[5] = {0.5f, 0.9f, 0.5f};
    meter.add(film, grey_film(0.5f));
  }
  // 0.4 in one of four frames: variance 0.4^2 (1/4) (3/4), in one of three channels.
  const std::vector<double> map = meter.map();
  for (std::size_t i = 0; i < map.size(); ++i)
    EXPECT_NEAR(map[i], i == 5 ? 0.4 * std::sqrt(0.25 * 0.75 / 3.0) : 0.0, 1e-7) << i;
  EXPECT_NEAR(meter.step(), 0.4 * std::sqrt(2.0 / (3.0 * 12.0 * 3.0)), 1e-7);
}

// A sine hidden in both halves of the reference by their own, larger noise.
TEST(Flicker, IsFreeOfTheReferencesNoise) {
  std::mt19937 random(11);
  std::normal_distribution<float> noise(0.0f, 0.02f);
  constexpr int frames = 32;
  constexpr double amplitude = 0.01;
  FlickerMeter meter, nothing, halves, one;
  for (int f = 0; f < frames; ++f) {
    const auto wave = static_cast<float>(amplitude * std::sin(2.0 * std::numbers::pi * f / frames));
    Film film(80, 60), still(80, 60), first(80, 60), second(80, 60);
    for (std::size_t i = 0; i < film.radiance.size(); ++i) {
      film.radiance[i] = glm::vec3(0.5f + wave);
      still.radiance[i] = glm::vec3(0.5f);
      for (Film* half : {&first, &second})
        half->radiance[i] = {0.5f + noise(random), 0.5f + noise(random), 0.5f + noise(random)};
    }
    meter.add(film, first, second);
    nothing.add(still, first, second);
    one.add(film, first);
    halves.add(first, second);
  }
  EXPECT_GT(one.flicker(), 0.02) << "with it";
  EXPECT_NEAR(meter.flicker(), amplitude / std::numbers::sqrt2, 1e-4);
  // The noise is 0.02 everywhere: v is 4e-4, and the floor is the root of 2 v / sqrt(3 F n).
  const double floor = std::sqrt(2.0 * 4e-4 / std::sqrt(3.0 * frames * 4800.0));
  EXPECT_NEAR(flicker_floor(halves), floor, 0.03 * floor);
  EXPECT_LT(nothing.flicker(), 1.5 * floor);
  EXPECT_GT(meter.flicker(), 4.0 * floor);
}

TEST(Flicker, OfWhatIsNotANumberIsSeen) {
  FlickerMeter meter;
  meter.add(grey_film(0.25f), grey_film(0.25f));
  meter.add(grey_film(std::nanf("")), grey_film(0.25f));
  EXPECT_NEAR(meter.flicker(), 0.375, 1e-7);
}

}  // namespace
}  // namespace asos
