#include "tests/support/random_space.h"
#include "tests/support/sample_lights.h"
#include "tests/support/shadow_fixture.h"
#include "tests/support/shadow_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

// Surfaces that intersect a flat light, against the light's polygon clipped by their planes.

namespace asos::test::through_light_test {
namespace {

/// A light in the plane y = 2, with a radius of about one unit; two-sided.
Light level_light(Light::Type type) {
  Light light;
  light.type = type;
  light.position = {0, 2, 0};
  light.direction = {0, -1, 0};
  light.half_u = {1, 0, 0};
  light.half_v = {0, 0, 0.75};
  light.radius = 1.0;
  light.two_sided = true;
  if (type == Light::Type::polygon)
    light.outlines = {{{-1, 2, -0.5}, {1, 2, -0.75}, {0.25, 2, 0.875}}};
  return light;
}

Polygon3 polygon_of(const Light& light) {
  if (light.type == Light::Type::rectangle) return corners_of(light);
  if (light.type == Light::Type::polygon) return light.outlines.front();
  Polygon3 circle;
  constexpr int sides = 2048;  // the disk's area has an error of 2e-6
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    circle.push_back(light.position + glm::dvec3(std::cos(angle), 0.0, std::sin(angle)));
  }
  return circle;
}

/// A random point of the lights' plane: inside the rectangle and the disk, not always inside the
/// polygon.
glm::dvec3 on_light(RandomSpace& random) {
  return {random.between(-0.6, 0.6), 2.0, random.between(-0.4, 0.4)};
}

Receiver receiver_below(RandomSpace& random) {
  Receiver receiver;
  receiver.position =
      glm::dvec3(glm::vec3(random.between(-1, 1), random.between(0, 1), random.between(-1, 1)));
  receiver.normal = receiver.geometric = {0, 1, 0};
  return receiver;
}

// The largest error over some receivers; also counts those that see a part of the light.
double worst_error(ShadowFixture& fixture, const std::vector<Polygon3>& walls, RandomSpace& random,
                   int& partly) {
  double worst = 0.0;
  const Polygon3 shape = polygon_of(fixture.source());
  for (int i = 0; i < 20; ++i) {
    const Receiver receiver = receiver_below(random);
    const double exact = seen_form(shape, walls, receiver) / form_of(shape, receiver);
    worst = std::max(worst, std::abs(fixture.visibility(receiver) - exact));
    partly += exact > 0.01 && exact < 0.99;
  }
  return worst;
}

class ThroughLight : public testing::TestWithParam<Light::Type> {};

TEST_P(ThroughLight, AWallHidesWhatLiesBehindIt) {
  RandomSpace random(11);
  int partly = 0;
  for (int w = 0; w < 60; ++w) {
    World world;
    const glm::dvec3 edge = random.direction();
    // Walls from smaller than the light to larger than the view.
    const double size = std::exp(random.between(-1.5, 3.0));
    const glm::dvec3 a = size * edge, b = size * random.perpendicular(edge);
    const glm::dvec3 corner =
        on_light(random) - random.between(0.2, 0.8) * a - random.between(0.2, 0.8) * b;
    const std::vector<Polygon3> walls{add_occluder(world, corner, a, b)};
    ShadowFixture fixture(std::move(world), level_light(GetParam()));
    EXPECT_LT(worst_error(fixture, walls, random, partly), 1e-4) << w;
  }
  EXPECT_GT(partly, 300);
}

TEST_P(ThroughLight, TwoWallsThatCrossInItHideTogether) {
  RandomSpace random(12);
  int partly = 0;
  for (int w = 0; w < 20; ++w) {
    World world;
    std::vector<Polygon3> walls;
    for (int i = 0; i < 2; ++i) {
      const glm::dvec3 along(random.between(-1, 1), 0, random.between(-1, 1));
      const glm::dvec3 up(random.between(-0.5, 0.5), 1, random.between(-0.5, 0.5));
      walls.push_back(add_occluder(world,
                                   on_light(random) - 10.0 * along - random.between(0.2, 0.9) * up,
                                   20.0 * along, up));
    }
    ShadowFixture fixture(std::move(world), level_light(GetParam()));
    EXPECT_LT(worst_error(fixture, walls, random, partly), 1e-4) << w;
  }
  EXPECT_GT(partly, 100);
}

TEST_P(ThroughLight, AWallThatEndsInItsPlaneCountsAsWell) {
  RandomSpace random(13);
  int partly = 0;
  for (int w = 0; w < 20; ++w) {
    World world;
    const glm::dvec3 along(random.between(-1, 1), 0, random.between(-1, 1));
    const glm::dvec3 down(random.between(-0.5, 0.5), -1.5, random.between(-0.5, 0.5));
    const std::vector<Polygon3> walls{
        add_occluder(world, on_light(random) - 8.0 * along, 16.0 * along, down)};
    ShadowFixture fixture(std::move(world), level_light(GetParam()));
    EXPECT_LT(worst_error(fixture, walls, random, partly), 1e-4) << w;
  }
  EXPECT_GT(partly, 100);
}

INSTANTIATE_TEST_SUITE_P(Lights, ThroughLight,
                         testing::Values(Light::Type::rectangle, Light::Type::polygon,
                                         Light::Type::disk));

}  // namespace
}  // namespace asos::test::through_light_test
