#include "renderer/lights/lights_without_geometry.h"

#include "tests/support/make_light.h"

#include <gtest/gtest.h>

#include <random>

namespace asos {
namespace {

PreparedLight ball_at(glm::dvec3 position, double radius) {
  const Light light = test::make_bulb(position, 5.0f, radius);
  return prepare_light(light);
}

TEST(MayShow, IsNeverWrongAboutABall) {
  // Rays in a cone that hit the sphere, which makes it visible.
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> r(-1.0, 1.0);
  int met = 0, denied = 0;
  for (int i = 0; i < 4000; ++i) {
    const PreparedLight light = ball_at({4.0 * r(rng), 4.0 * r(rng), 4.0 * r(rng)}, 0.3);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(r(rng), r(rng), r(rng) + 1e-3));
    const double half_angle = 0.2;
    const glm::dvec3 aside = glm::normalize(glm::cross(axis, glm::dvec3(r(rng), r(rng), 1.1)));
    const Ray ray{
        .origin = glm::vec3(0.0f),
        .direction = glm::vec3(std::cos(half_angle) * axis + std::sin(half_angle) * aside)};
    const bool shows = may_show(light, glm::dvec3(0.0), axis, half_angle + 1e-6);
    denied += !shows;
    if (!meet_light(light, ray)) continue;
    ++met;
    EXPECT_TRUE(shows);
  }
  EXPECT_GT(met, 10);
  EXPECT_GT(denied, 2000);
}

TEST(MayShow, LightsWithoutAnAreaAreNotShown) {
  const Light light = test::make_bulb({0, 0, 1});
  EXPECT_FALSE(may_show(prepare_light(light), glm::dvec3(0.0), {0, 0, 1}, 1.0));
  EXPECT_TRUE(may_show(ball_at({0, 0, 1}, 2.0), glm::dvec3(0.0), {0, 0, -1}, 0.1)) << "from within";
}

}  // namespace
}  // namespace asos
