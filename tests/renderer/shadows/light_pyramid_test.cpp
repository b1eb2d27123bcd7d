#include "renderer/shadows/light_pyramid.h"

#include "tests/support/make_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace asos::light_window_test {
namespace {

PreparedLight rectangle(glm::dvec3 middle, glm::dvec3 half_u, glm::dvec3 half_v) {
  Light light =
      test::make_panel(middle, glm::normalize(glm::cross(half_u, half_v)), half_u, half_v);
  light.two_sided = true;
  return prepare_light(light);
}

PreparedLight ball(glm::dvec3 centre, double radius) {
  Light light = test::make_bulb(centre);
  light.radius = radius;
  light.intensity = static_cast<float>(std::numbers::pi * radius * radius);  // 1 nit
  return prepare_light(light);
}

const LeafRegion whole{{0.0f, 0.0f, 1.0f}, {}};

class Directions {
 public:
  glm::dvec3 next() { return glm::normalize(glm::dvec3(d_(rng_), d_(rng_), d_(rng_))); }
  double uniform(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(rng_);
  }

 private:
  std::mt19937 rng_{17};
  std::normal_distribution<double> d_;
};

// The window's sum over its whole square is the closed form of the whole light.
TEST(LightPyramid, TheWholeOfALightIsItsClosedForm) {
  Directions random;
  int seen = 0;
  for (int i = 0; i < 2000; ++i) {
    Receiver receiver;
    receiver.normal = receiver.geometric = random.next();
    const glm::dvec3 u = random.next();
    const glm::dvec3 v = glm::normalize(glm::cross(u, random.next()));
    const double size = std::pow(10.0, random.uniform(-3.0, 1.0));
    const glm::dvec3 middle = 3.0 * random.next();
    const PreparedLight light =
        i % 2 ? rectangle(middle, size * u, 0.5 * size * v) : ball(middle, std::min(size, 2.5));
    const auto window = LightPyramid::of(light, receiver);
    if (!window || !window->boundaries().empty()) continue;  // the horizon cuts it
    const double expected = static_cast<double>(unshadowed_irradiance(light, receiver).x) /
                            static_cast<double>(light.power.x);
    EXPECT_NEAR(window->form(whole), expected, 2e-6 * expected + 1e-12) << i;
    ++seen;
  }
  EXPECT_GT(seen, 500);
}

// The silhouette is a polygon of nearly the same solid angle.
TEST(LightPyramid, WholeOfCapsuleIsNearlyItsClosedForm) {
  Directions random;
  int seen = 0;
  for (int i = 0; i < 1000; ++i) {
    Receiver receiver;
    receiver.normal = receiver.geometric = random.next();
    Light capsule = test::make_bulb(3.0 * random.next());
    capsule.type = Light::Type::linear;
    capsule.half_u = random.uniform(0.1, 2.5) * random.next();
    capsule.radius = random.uniform(0.01, 0.5);
    const PreparedLight light = prepare_light(capsule);
    const auto window = LightPyramid::of(light, receiver);
    if (!window) continue;
    const double expected = static_cast<double>(unshadowed_irradiance(light, receiver).x) /
                            static_cast<double>(light.power.x);
    // Unless the horizon cuts it, the region is the light itself: two arcs and two sides.
    std::vector<BorderEdge> outline(window->boundaries().begin(), window->boundaries().end());
    if (outline.size() != 14 || !(expected > 0.0)) continue;
    const double form = window->form({whole.square, outline});
    EXPECT_NEAR(form, expected, 5e-3 * expected) << i;
    ++seen;
  }
  EXPECT_GT(seen, 200);
}

// The forms of disjoint parts add up: each arc of the rim belongs to one part.
TEST(LightPyramid, TheFormIsAdditive) {
  Directions random;
  for (int i = 0; i < 500; ++i) {
    Receiver receiver;
    const PreparedLight light = ball(glm::dvec3(0.3, 0.2, 3.0), random.uniform(0.01, 2.0));
    receiver.normal = receiver.geometric = {0, 0, 1};
    const auto window = LightPyramid::of(light, receiver);
    ASSERT_TRUE(window.has_value());
    const auto x = static_cast<float>(random.uniform(0.05, 0.95));
    const auto y = static_cast<float>(random.uniform(0.05, 0.95));
    const glm::vec2 a(x, 0.0f), b(y, 1.0f);
    const BorderEdge left[] = {{{0, 0}, a}, {a, b}, {b, {0, 1}}, {{0, 1}, {0, 0}}};
    const BorderEdge right[] = {{a, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, b}, {b, a}};
    const double all = window->form(whole);
    EXPECT_NEAR(window->form({whole.square, left}) + window->form({whole.square, right}), all,
                1e-9 * all);
  }
}

// A straight cut through a sphere's centre leaves the same light on either side, wherever the cut's
// ends are on the square's border: the rim touches the sides that bound one half.
TEST(LightPyramid, EitherHalfOfABallIsHalfOfItsLight) {
  Receiver receiver;
  receiver.normal = receiver.geometric = {0, 0, 1};
  const auto window = LightPyramid::of(ball({0, 0, 2}, 0.7), receiver);
  ASSERT_TRUE(window.has_value());
  const double half = 0.5 * window->form(whole);
  // Around the square's border, with both ends of the cut as corners.
  static constexpr glm::vec2 round[8] = {{0, 0}, {0.5f, 0}, {1, 0}, {1, 0.5f},
                                         {1, 1}, {0.5f, 1}, {0, 1}, {0, 0.5f}};
  for (std::size_t from = 0; from < 8; ++from) {
    BorderEdge border[5];
    for (std::size_t i = 0; i < 4; ++i)
      border[i] = {round[(from + i) % 8], round[(from + i + 1) % 8]};
    border[4] = {round[(from + 4) % 8], round[from]};
    EXPECT_NEAR(window->form({whole.square, border}), half, 1e-9) << from;
  }
}

// A sphere seen frontally, halved by a straight line through the window's centre.
TEST(LightPyramid, HalfOfABallIsHalfOfItsLight) {
  Receiver receiver;
  receiver.normal = receiver.geometric = {0, 0, 1};
  const auto window = LightPyramid::of(ball({0, 0, 2}, 0.7), receiver);
  ASSERT_TRUE(window.has_value());
  const BorderEdge half[] = {
      {{0, 0}, {0.5f, 0}}, {{0.5f, 0}, {0.5f, 1}}, {{0.5f, 1}, {0, 1}}, {{0, 1}, {0, 0}}};
  const double all = window->form(whole);
  EXPECT_NEAR(all, std::numbers::pi * 0.7 * 0.7 / 4.0, 1e-9);
  EXPECT_NEAR(window->form({whole.square, half}), 0.5 * all, 1e-9);
  const BorderEdge island[] = {{{0.4f, 0.4f}, {0.6f, 0.4f}},
                               {{0.6f, 0.4f}, {0.6f, 0.6f}},
                               {{0.6f, 0.6f}, {0.4f, 0.6f}},
                               {{0.4f, 0.6f}, {0.4f, 0.4f}}};
  EXPECT_GT(window->form({whole.square, island}), 0.0);
  EXPECT_LT(window->form({whole.square, island}), 0.1 * all);
}

TEST(LightPyramid, WhatLiesBelowTheHorizonIsCutOffByABoundary) {
  Receiver receiver;
  receiver.normal = receiver.geometric = {0, 1, 0};
  const PreparedLight light = rectangle({0, 0.25, 3}, {1, 0, 0}, {0, 1, 0});
  const auto window = LightPyramid::of(light, receiver);
  ASSERT_TRUE(window.has_value());
  ASSERT_EQ(window->boundaries().size(), 1u);
  int held = 0;
  for (int i = 0; i < 100; ++i) held += window->holds({0.5f, (static_cast<float>(i) + 0.5f) / 100});
  EXPECT_NEAR(held, 62.5, 1.0);  // 1.25 of 2 high
}

TEST(LightPyramid, ThereIsNoneFromWithinABallNorInTheLightsPlane) {
  Receiver receiver;
  receiver.normal = receiver.geometric = {0, 1, 0};
  EXPECT_FALSE(LightPyramid::of(ball({0, 0, 0.5}, 1.0), receiver).has_value());
  EXPECT_FALSE(LightPyramid::of(rectangle({0, 3, 0}, {1, 0, 0}, {0, 1, 0}), receiver).has_value());
}

}  // namespace
}  // namespace asos::light_window_test
