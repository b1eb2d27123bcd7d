#include "renderer/asos/polynomial_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace asos::test::course_test {
namespace {

glm::dvec3 bent(glm::dvec2 p) {
  return {0.3 + 0.2 * p.x - 0.1 * p.y + 0.4 * p.x * p.y, 0.5 - p.x * p.x + 0.25 * p.y * p.y, 1.0};
}

/// Nine places, 3 x 3, of a part of the unit square, with the function's values.
template <typename Function>
std::vector<NoisyValue> nine(const Function& of, double variance) {
  std::vector<NoisyValue> known;
  for (int i = 0; i < 9; ++i) {
    const glm::dvec2 at(0.2 + 0.3 * (i % 3), 0.1 + 0.25 * (i / 3));
    known.push_back({at, of(at), variance});
  }
  return known;
}

TEST(PolynomialFit, FitsQuadraticsExactly) {
  const auto course = PolynomialFit::through(nine(bent, 1e-6));
  ASSERT_TRUE(course);
  EXPECT_LT(course->misfit(), 1e-9);
  for (const glm::dvec2 at : {glm::dvec2(0.2, 0.1), {0.3, 0.3}, {0.77, 0.55}, {0.41, 0.12}}) {
    const glm::dvec3 off = course->at(at) - bent(at);
    EXPECT_LT(std::abs(off.x) + std::abs(off.y) + std::abs(off.z), 1e-9) << at.x << ' ' << at.y;
  }
}

// The misfit, relative to the values' noise, reveals a step between the nodes.
TEST(PolynomialFit, MisfitDetectsAStep) {
  const auto step = [](glm::dvec2 p) { return glm::dvec3(p.x < 0.4 ? 0.2 : 0.8, 0.5, 0.5); };
  const auto course = PolynomialFit::through(nine(step, 1e-4));
  ASSERT_TRUE(course);
  // A step along x can be fitted by a quadratic through three columns; a diagonal one cannot.
  EXPECT_LT(course->misfit(), 1e-9);
  const auto diagonal = [](glm::dvec2 p) {
    return glm::dvec3(p.x + p.y < 0.65 ? 0.2 : 0.8, 0.5, 0.5);
  };
  const auto none = PolynomialFit::through(nine(diagonal, 1e-4));
  ASSERT_TRUE(none);
  EXPECT_GT(none->misfit(), 100.0);
}

// Noise of the assumed variance gives a mean misfit of 1.
TEST(PolynomialFit, MisfitOfNoiseIsOne) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01);
  double sum = 0.0;
  constexpr int runs = 2000;
  for (int run = 0; run < runs; ++run) {
    const auto course = PolynomialFit::through(
        nine([&](glm::dvec2 p) { return bent(p) + glm::dvec3(noise(random), 0.0, 0.0); }, 1e-4));
    ASSERT_TRUE(course);
    sum += course->misfit() / runs;
  }
  EXPECT_NEAR(sum, 1.0, 0.06);
}

TEST(PolynomialFit, NeedsPlacesThatSpanASurface) {
  std::vector<NoisyValue> known = nine(bent, 1.0);
  known.resize(4);
  EXPECT_FALSE(PolynomialFit::through(known)) << "too few";
  known = nine(bent, 1.0);
  for (NoisyValue& value : known) value.at.y = 2.0 * value.at.x;
  EXPECT_FALSE(PolynomialFit::through(known)) << "along a line";
  for (NoisyValue& value : known) value.at = {0.5, 0.5};
  EXPECT_FALSE(PolynomialFit::through(known)) << "one place";
}

// Values with less noise have more weight.
TEST(PolynomialFit, WeighsValuesByTheirNoise) {
  std::vector<NoisyValue> known;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec2 at(i % 2, i / 2);
    known.push_back({at, glm::dvec3(i < 4 ? 0.0 : 1.0), i < 4 ? 1e-6 : 1.0});
  }
  for (NoisyValue& value : known) value.at.y = std::fmod(value.at.y, 2.0);
  const auto course = PolynomialFit::through(known);
  ASSERT_TRUE(course);
  EXPECT_NEAR(course->at({0.5, 0.5}).x, 0.0, 1e-5);
}

}  // namespace
}  // namespace asos::test::course_test
