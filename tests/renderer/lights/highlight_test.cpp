#include "renderer/lights/prepared_light.h"
#include "tests/support/random_space.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos::highlight_test {
namespace {

const glm::dvec3 origin(0.0);

void expect_direction(const Highlight& highlight, glm::dvec3 along) {
  EXPECT_LT(glm::length(glm::dvec3(highlight.direction) - glm::normalize(along)), 1e-6)
      << highlight.direction.x << ' ' << highlight.direction.y << ' ' << highlight.direction.z;
}

TEST(Highlight, OfPointsIsTheirDirection) {
  const glm::dvec3 ray = glm::normalize(glm::dvec3(1, 1, 0));
  for (const Light& light : {test::point_light(), test::distant_light()}) {
    const Highlight highlight = highlight_of(prepare_light(light), origin, ray);
    expect_direction(highlight, {0, 1, 0});
    EXPECT_EQ(highlight.half_angle_tangent, 0.0f);
  }
}

TEST(Highlight, IsTheRayItselfWhereItHitsTheLight) {
  const glm::dvec3 ray = glm::normalize(glm::dvec3(0.12, 1, -0.1));
  for (const Light& light : {test::ball_light(), test::sun_light(), test::capsule_light(),
                             test::rectangle_light(), test::disk_light(), test::polygon_light()}) {
    expect_direction(highlight_of(prepare_light(light), origin, ray), ray);
  }
}

TEST(Highlight, IsTheNearestEndWhereTheRayMisses) {
  const glm::dvec3 ray = glm::normalize(glm::dvec3(3, 1, 0));
  expect_direction(highlight_of(prepare_light(test::rectangle_light()), origin, ray), {0.8, 2, 0});
  expect_direction(highlight_of(prepare_light(test::disk_light()), origin, ray), {0.7, 2, 0});
  expect_direction(highlight_of(prepare_light(test::linear_light()), origin, ray), {0.9, 2.2, 0});
  // The nearest point is at right angles to the ray from the sphere's centre.
  const glm::dvec3 nudge = 0.6 * glm::normalize(glm::dvec3(1, -3, 0));
  expect_direction(highlight_of(prepare_light(test::ball_light()), origin, ray),
                   glm::dvec3(0, 2, 0) + nudge);
}

TEST(Highlight, OfASegmentIsNearestToTheRay) {
  const PreparedLight light = prepare_light(test::linear_light());
  test::RandomSpace random(31);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec3 ray = glm::normalize(glm::dvec3(0, 2, 0) + 1.5 * random.direction());
    const glm::dvec3 found = highlight_of(light, origin, ray).direction;
    // Distance of the ray from every point of the light, and from the point found.
    double least = 1e9;
    double of_found = 1e9;
    for (int k = -1000; k <= 1000; ++k) {
      const glm::dvec3 p = light.position + k * 1e-3 * light.half_u;
      const double off = glm::length(glm::cross(p, ray));
      least = std::min(least, off);
      if (glm::dot(glm::normalize(p), found) > 1.0 - 1e-6) of_found = std::min(of_found, off);
    }
    EXPECT_NEAR(of_found, least, 1e-3) << i;
  }
}

TEST(Highlight, TurnsWithoutAJumpAsTheRayLeavesThePlane) {
  for (const Light& light : {test::rectangle_light(), test::disk_light()}) {
    const PreparedLight prepared = prepare_light(light);
    glm::dvec3 last(0.0);
    for (int i = 0; i <= 2000; ++i) {
      const double angle = i * 1e-3;  // from the light's centre to well below its plane
      const glm::dvec3 ray = glm::normalize(glm::dvec3(std::sin(angle), std::cos(angle), 0.05));
      const glm::dvec3 now = highlight_of(prepared, origin, ray).direction;
      if (i > 0) {
        ASSERT_LT(glm::length(now - last), 2e-3) << light.name << " at " << angle;
      }
      last = now;
    }
    EXPECT_GT(last.x, 0.3) << light.name;
  }
}

TEST(Highlight, HasTheSizeOverTheDistance) {
  const glm::dvec3 ray(0, 1, 0);
  const auto tangent = [&](const Light& light) {
    return highlight_of(prepare_light(light), origin, ray).half_angle_tangent;
  };
  EXPECT_FLOAT_EQ(tangent(test::ball_light(0.6)), 0.3f);
  EXPECT_FLOAT_EQ(tangent(test::disk_light()), 0.35f);
  EXPECT_NEAR(tangent(test::rectangle_light()), std::sqrt(1.6 / std::numbers::pi) / 2.0, 1e-6);
  EXPECT_NEAR(tangent(test::sun_light(0.5)), std::tan(0.25), 1e-6);
  EXPECT_FLOAT_EQ(tangent(test::ball_light(5.0)), 1.0f) << "inside";
}

}  // namespace
}  // namespace asos::highlight_test
