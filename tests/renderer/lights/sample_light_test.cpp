#include "renderer/lights/kinds/shared.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/scene/make_light.h"
#include "tests/support/random_space.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asos::sample_light_test {
namespace {

/// Mean irradiance of the red channel over the centres of count x count cells.
double mean(const PreparedLight& light, const Receiver& receiver, int count) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < count; ++k)
      sum += sample_light(light, receiver, (i + 0.5) / count, (k + 0.5) / count).irradiance.r;
  }
  return sum / (count * count);
}

std::vector<PreparedLight> prepared_lights() {
  std::vector<PreparedLight> lights;
  for (const Light& light : test::all_lights()) lights.push_back(prepare_light(light));
  Light inside = test::ball_light(8.0);
  lights.push_back(prepare_light(inside));
  Light small = test::scaled(test::rectangle_light(), 1e-4);
  small.position = {0, 2, 0};
  lights.push_back(prepare_light(small));
  return lights;
}

/// With equal horizons the integrand has only kinks, which cost a fraction of the brightest cells
/// (of a receiver that faces the light). A polygon's map has steps at the height of a notch, which
/// the grid may misplace by one row.
TEST(SampleLight, HasTheIrradianceAsItsMean) {
  test::RandomSpace random(21);
  for (const PreparedLight& light : prepared_lights()) {
    const bool steps = light.shape == LightShape::polygon;
    int lit = 0;
    for (int i = 0; i < 12; ++i) {
      const Receiver receiver = random.receiver(1.2 * random.direction(), {0, 2, 0}, i % 3);
      const glm::dvec3 facing = glm::normalize(glm::dvec3(0, 2, 0) - receiver.position);
      const double most = unshadowed_irradiance(light, {receiver.position, facing, facing}).r;
      const double expected = unshadowed_irradiance(light, receiver).r;
      EXPECT_NEAR(mean(light, receiver, 300), expected,
                  (steps ? 2e-3 : 2e-4) * expected + 2e-5 * most)
          << "shape " << static_cast<int>(light.shape) << ", round " << i;
      if (expected > 0.0) ++lit;
    }
    EXPECT_GT(lit, 4);
  }
}

/// The second horizon cuts with a step, which a grid locates to about one cell per row.
TEST(SampleLight, GivesNothingBelowTheSecondHorizon) {
  test::RandomSpace random(22);
  for (const PreparedLight& light : prepared_lights()) {
    for (int i = 0; i < 6; ++i) {
      const glm::dvec3 position = 1.2 * random.direction();
      Receiver receiver = random.receiver(position, {0, 2, 0}, 0);
      receiver.geometric = random.perpendicular(glm::normalize(glm::dvec3(0, 2, 0) - position));
      const double whole =
          unshadowed_irradiance(light, {position, receiver.normal, receiver.normal}).r;
      EXPECT_NEAR(mean(light, receiver, 300), unshadowed_irradiance(light, receiver).r,
                  0.02 * whole)
          << "shape " << static_cast<int>(light.shape) << ", round " << i;
    }
  }
}

TEST(SampleLight, LandsOnTheLight) {
  const Receiver receiver{{0.3, 0, -0.2}, {0, 1, 0}, {0, 1, 0}};
  for (const PreparedLight& light : prepared_lights()) {
    for (int i = 0; i <= 10; ++i) {
      for (int k = 0; k <= 10; ++k) {
        const LightSample sample = sample_light(light, receiver, 0.1 * i, 0.1 * k);
        if (std::isinf(sample.distance)) {
          const double angle = std::atan(light.radius);
          EXPECT_GT(glm::dot(sample.direction, light.towards), std::cos(angle) - 1e-12);
          continue;
        }
        const glm::dvec3 off =
            receiver.position + sample.distance * sample.direction - light.position;
        if (light.shape == LightShape::ball) {
          EXPECT_NEAR(glm::length(off), light.radius, 2e-7 * light.radius);
        } else if (light.shape == LightShape::capsule) {
          const double along = glm::dot(off, light.half_u) / glm::dot(light.half_u, light.half_u);
          const glm::dvec3 beside = off - std::clamp(along, -1.0, 1.0) * light.half_u;
          EXPECT_NEAR(glm::length(beside), light.radius, 2e-7 * light.radius);
        } else if (light.shape == LightShape::segment) {
          EXPECT_LT(glm::length(glm::cross(off, light.half_u)), 1e-12);
          EXPECT_LE(glm::length(off), glm::length(light.half_u) * (1.0 + 1e-12));
        } else if (light.extended()) {
          const glm::dvec2 at(glm::dot(off, light.half_u) / glm::dot(light.half_u, light.half_u),
                              glm::dot(off, light.half_v) / glm::dot(light.half_v, light.half_v));
          EXPECT_NEAR(glm::dot(off, light.towards), 0.0, 1e-12);
          EXPECT_LE(std::max(std::abs(at.x), std::abs(at.y)), 1.0 + 1e-9);
        } else {
          EXPECT_LT(glm::length(off), 1e-12);
        }
      }
    }
  }
}

TEST(SampleLight, BySolidAngleIsEvenUnderALargeRectangle) {
  // Samples of equal solid angle differ only by the receiver's cosine.
  const PreparedLight light = prepare_light(test::rectangle_light());
  const Receiver receiver{{0, 1.9, 0}, {0, 1, 0}, {0, 1, 0}};
  const double first = sample_light(light, receiver, 0.1, 0.2).irradiance.r /
                       sample_light(light, receiver, 0.1, 0.2).direction.y;
  for (const glm::dvec2& uv : {glm::dvec2(0.5, 0.5), glm::dvec2(0.99, 0.3), glm::dvec2(0, 1)}) {
    const LightSample sample = sample_light(light, receiver, uv.x, uv.y);
    EXPECT_NEAR(sample.irradiance.r / sample.direction.y / first, 1.0, 1e-5);
  }
}

// No sample is wasted below a floor for an upright rectangle that stands in it; few are for a
// tilted one.
TEST(SampleLight, SamplesOnlyThePartAboveTheHorizons) {
  Light wall = test::rectangle_light();
  wall.position = {0, -0.2, -1.0};
  wall.direction = {0, 0, 1};
  wall.half_u = {0.2, 0, 0};
  wall.half_v = {0, 0.5, 0};
  Light leaning = wall;
  leaning.half_u = {0.2, 0.08, 0};
  leaning.half_v = {-0.2, 0.5, 0};
  const glm::dvec3 up(0, 1, 0), tilted = glm::normalize(glm::dvec3(0.3, 1, 0.2));
  const auto share_above = [](const Light& light, const Receiver& receiver) {
    const PreparedLight prepared = prepare_light(light);
    int above = 0;
    for (int i = 0; i < 20; ++i)
      for (int k = 0; k < 20; ++k)
        above +=
            sample_light(prepared, receiver, (i + 0.5) / 20, (k + 0.5) / 20).irradiance.r > 0.0f;
    return above / 400.0;
  };
  EXPECT_EQ(share_above(wall, {{0, 0, 0}, up, up}), 1.0);
  for (const Receiver& receiver : {Receiver{{0, 0, 0}, tilted, up}, {{0, 0, 0}, up, tilted}})
    EXPECT_GT(share_above(wall, receiver), 0.55);
  EXPECT_GT(share_above(leaning, {{0, 0, 0}, up, up}), 0.7);
}

/// Returns the solid angle of a rectangle's part above a horizon through the origin.
double solid_angle(glm::dvec3 middle, glm::dvec3 u, glm::dvec3 v, glm::dvec3 horizon = {0, 0, -1}) {
  const PreparedLight light = prepare_light(make_panel(middle, {0, 0, 1}, u, v));
  const Receiver receiver{{}, horizon, horizon};
  return SharedGeometry<LightShape::rectangle>::arcs(light, receiver, middle).solid_angle;
}

// The remaining part is as large as the part cut from it: two halves make the whole.
TEST(SphericalRectangle, KeepsWhatIsAboveAHorizon) {
  const glm::dvec3 middle(0.2, -0.1, -1), u(0.8, 0, 0), v(0, 0.5, 0);
  const glm::dvec3 up = glm::normalize(glm::dvec3(0, 1, 0.05));
  const double all = solid_angle(middle, u, v);
  const double upper = solid_angle(middle, u, v, up);
  const double lower = solid_angle(middle, u, v, -up);
  EXPECT_NEAR(upper + lower, all, 1e-12);
  EXPECT_GT(upper, 0.3 * all);
  EXPECT_LT(upper, 0.5 * all);
  EXPECT_EQ(solid_angle(middle, u, v, {0, 0, 1}), all) << "all is below";
}

TEST(SphericalRectangle, HasTheSolidAngleOfACubesFace) {
  EXPECT_NEAR(solid_angle({0, 0, -1}, {1, 0, 0}, {0, 1, 0}), 4.0 * std::numbers::pi / 6.0, 1e-14);
  const PreparedLight light =
      prepare_light(make_panel({0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}));
  const LightSample sample = sample_light(light, {{}, {0, 0, -1}, {0, 0, -1}}, 0.5, 0.5);
  EXPECT_LT(glm::length(sample.distance * sample.direction - glm::dvec3(0, 0, -1)), 1e-12);
}

}  // namespace
}  // namespace asos::sample_light_test
