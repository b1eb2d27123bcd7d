#include "renderer/lights/prepared_light.h"

#include "renderer/geometry/finite.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asos::prepared_light_test {
namespace {

using std::numbers::pi;

void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance = 1e-12) {
  EXPECT_LT(glm::length(a - b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(PrepareLight, GivesEachTypeItsShape) {
  const LightShape shapes[] = {LightShape::point,   LightShape::point,     LightShape::ball,
                               LightShape::distant, LightShape::sun,       LightShape::segment,
                               LightShape::capsule, LightShape::rectangle, LightShape::disk,
                               LightShape::polygon};
  const std::vector<Light> lights = test::all_lights();
  ASSERT_EQ(lights.size(), std::size(shapes));
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const PreparedLight light = prepare_light(lights[i]);
    EXPECT_EQ(light.shape, shapes[i]) << lights[i].name;
    const bool point = shapes[i] == LightShape::point || shapes[i] == LightShape::distant;
    EXPECT_EQ(light.extended(), !point) << lights[i].name;
  }
}

TEST(PrepareLight, GivesCapsuleTheRadianceOfItsSide) {
  const Light light = test::capsule_light(0.25);
  const PreparedLight capsule = prepare_light(light);
  const double half = glm::length(light.half_u);
  EXPECT_NEAR(capsule.power.r, 5.0 / (4.0 * half * 0.25 + pi * 0.0625), 1e-5);
  EXPECT_EQ(capsule.half_u, light.half_u);
  EXPECT_EQ(capsule.radius, 0.25);
  EXPECT_EQ(prepare_light(test::capsule_light(1e-9)).shape, LightShape::segment);
  EXPECT_EQ(light_shape(test::capsule_light(1e-9)), LightShape::segment);
  Light ball = light;
  ball.half_u = glm::dvec3(0.0);
  EXPECT_EQ(prepare_light(ball).shape, LightShape::ball);
}

TEST(PrepareLight, ConvertsPower) {
  EXPECT_FLOAT_EQ(prepare_light(test::point_light()).power.g, 2.5f);
  EXPECT_NEAR(prepare_light(test::ball_light(0.5)).power.r, 5.0 / (pi * 0.25), 1e-5);
  EXPECT_NEAR(prepare_light(test::sun_light(1.0)).power.r,
              5.0 / (pi * std::sin(0.5) * std::sin(0.5)), 1e-5);
  const PreparedLight segment = prepare_light(test::linear_light());
  EXPECT_NEAR(segment.power.r * 2.0 * glm::length(segment.half_u), 5.0, 1e-6);
  EXPECT_FLOAT_EQ(prepare_light(test::disk_light()).power.r, 5.0f);
}

TEST(PrepareLight, MakesLightsOfNoSizePointsOrNothing) {
  EXPECT_EQ(prepare_light(test::sun_light(0.0)).shape, LightShape::distant);
  EXPECT_EQ(prepare_light(test::ball_light(1e-30)).shape, LightShape::point)
      << "its radiance overflows a float";
  Light linear = test::linear_light();
  linear.half_u = {0, 0, 0};
  EXPECT_EQ(prepare_light(linear).shape, LightShape::point);
  EXPECT_FLOAT_EQ(prepare_light(linear).power.r, 5.0f);

  Light rectangle = test::rectangle_light();
  rectangle.half_v = 2.0 * rectangle.half_u;
  Light disk = test::disk_light();
  disk.radius = 0.0;
  Light line = test::polygon_light();
  line.outlines = {{{0, 2, 0}, {0.1, 2, 0.2}, {0.2, 2, 0.4}, {0.3, 2, 0.6}}};
  Light empty = test::polygon_light();
  empty.outlines.clear();
  for (const Light& light : {rectangle, disk, line, empty}) {
    const PreparedLight prepared = prepare_light(light);
    EXPECT_EQ(prepared.shape, LightShape::point) << light.name;
    EXPECT_EQ(prepared.power, glm::vec3(0.0f)) << light.name;
  }
}

TEST(PrepareLight, TurnsHalvesAndOutlinesAlongTheLight) {
  for (Light light : {test::rectangle_light(), test::disk_light(), test::polygon_light()}) {
    for (const glm::dvec3& direction : {glm::dvec3(0, -1, 0), glm::dvec3(0, 3, 0)}) {
      light.direction = direction;
      const PreparedLight prepared = prepare_light(light);
      expect_near(prepared.towards, glm::normalize(direction));
      expect_near(glm::normalize(glm::cross(prepared.half_u, prepared.half_v)), prepared.towards);
      if (prepared.shape == LightShape::disk) continue;
      glm::dvec3 area(0.0);
      for (const auto& outline : prepared.outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i)
          area += 0.5 * glm::cross(outline[i], outline[(i + 1) % outline.size()]);
      }
      expect_near(area, prepared.area * prepared.towards);
    }
  }
}

TEST(PrepareLight, PutsTheSmallestRectangleAroundAPolygon) {
  // A square on its corner with a notch: sampled by its own sides, not by the axes.
  Light light = test::polygon_light();
  light.outlines = {{{1, 2, 0}, {0, 2, 1}, {-0.5, 2, 0.5}, {-0.2, 2, 0.1}, {-1, 2, 0}, {0, 2, -1}}};
  const PreparedLight prepared = prepare_light(light);
  expect_near(prepared.position, {0, 2, 0});
  EXPECT_NEAR(glm::length(prepared.half_u), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(glm::length(prepared.half_v), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(std::abs(glm::normalize(prepared.half_u).x), std::sqrt(0.5), 1e-12);
}

TEST(PrepareLight, TakesAShearedRectangleForWhatItIs) {
  Light light = test::rectangle_light();
  light.half_v = {0.3, 0, -0.5};
  const PreparedLight prepared = prepare_light(light);
  EXPECT_EQ(prepared.shape, LightShape::polygon);
  EXPECT_NEAR(prepared.area, 1.6, 1e-12);
}

/// Receivers at every light and next to it, lights of extreme sizes, both rules.
TEST(PreparedLight, GivesFiniteResultsForAllFiniteInput) {
  const glm::dvec3 up(0, 1, 0);
  const glm::dvec3 places[] = {{0, 2, 0},     {0.9, 2.2, 0}, {0.8, 2, 0.5},     {0.7, 2, 0},
                               {0, 0, 0},     {0, 1e150, 0}, {0, 2 + 1e-12, 0}, {1e-170, 2, 0},
                               {1.8, 2.4, 0}, {0, 1.4, 0},   {5, 2, 0},         {-0.6, 2, -0.6}};
  std::vector<Light> lights = test::all_lights();
  for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
    for (Light light : test::all_lights()) {
      light = test::scaled(light, scale);
      light.position = {0, 2, 0};
      light.intensity = 5.0f;
      lights.push_back(light);
    }
  }
  int lit = 0;
  for (const Light& light : lights) {
    for (const LightRule rule : {LightRule::physical, LightRule::published}) {
      PreparedLight prepared = prepare_light(light, rule);
      for (const bool two_sided : {false, true}) {
        prepared.two_sided = two_sided;
        for (const glm::dvec3& place : places) {
          for (const glm::dvec3& normal : {up, -up, glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1)}) {
            const Receiver receiver{place, normal, normal};
            const glm::vec3 e = unshadowed_irradiance(prepared, receiver);
            ASSERT_TRUE(finite(e) && e.r >= 0.0f) << light.name << " at " << place.y;
            if (e.r > 0.0f) ++lit;
            for (const glm::dvec2& uv :
                 {glm::dvec2(0, 0), glm::dvec2(0.5, 0.5), glm::dvec2(1, 1)}) {
              const LightSample sample = sample_light(prepared, receiver, uv.x, uv.y);
              ASSERT_TRUE(finite(sample.irradiance)) << light.name << " at " << place.y;
              ASSERT_NEAR(glm::length(sample.direction), 1.0, 1e-9) << light.name;
              ASSERT_GE(sample.distance, 0.0) << light.name;
            }
            const Highlight highlight = highlight_of(prepared, place, normal);
            ASSERT_NEAR(glm::length(highlight.direction), 1.0f, 1e-5f) << light.name;
            ASSERT_TRUE(std::isfinite(highlight.half_angle_tangent)) << light.name;
          }
        }
      }
    }
  }
  EXPECT_GT(lit, 500);
}

}  // namespace
}  // namespace asos::prepared_light_test
