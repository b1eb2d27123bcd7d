#include "renderer/lights/prepared_light.h"
#include "tests/support/light_oracle.h"
#include "tests/support/random_space.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos::irradiance_test {
namespace {

using std::numbers::pi;
using test::RandomSpace;

const glm::dvec3 up(0, 1, 0);

/// Irradiance of the red channel, in which the lights of tests/support have an intensity of 5.
float irradiance(const Light& light, const Receiver& receiver,
                 LightRule rule = LightRule::physical) {
  return unshadowed_irradiance(prepare_light(light, rule), receiver).r;
}

TEST(Irradiance, OfAPointFallsWithTheSquareAndTheCosine) {
  EXPECT_FLOAT_EQ(irradiance(test::point_light(), {{0, 0, 0}, up, up}), 5.0f / 4.0f);
  const glm::dvec3 tilted = glm::normalize(glm::dvec3(1, 1, 0));
  EXPECT_FLOAT_EQ(irradiance(test::point_light(), {{0, -1, 0}, tilted, up}),
                  5.0f / 9.0f * std::sqrt(0.5f));
  EXPECT_EQ(irradiance(test::point_light(), {{0, -1, 0}, tilted, -up}), 0.0) << "its back";
  EXPECT_EQ(irradiance(test::point_light(), {{0, -1, 0}, -up, up}), 0.0);
  EXPECT_EQ(irradiance(test::point_light(), {{0, 2, 0}, up, up}), 0.0)
      << "at the light's own position";
}

TEST(Irradiance, KeepsTheColour) {
  for (const Light& light : test::all_lights()) {
    const glm::vec3 e = unshadowed_irradiance(prepare_light(light), {{0.1, 0, 0}, up, up});
    EXPECT_GT(e.r, 0.0f) << light.name;
    EXPECT_NEAR(e.g / e.r, 0.5f, 1e-6) << light.name;
    EXPECT_NEAR(e.b / e.r, 0.25f, 1e-6) << light.name;
  }
}

TEST(Irradiance, OfADirectionalLightIsItsLux) {
  const Receiver facing{{3, -7, 2}, up, up};
  EXPECT_FLOAT_EQ(irradiance(test::distant_light(), facing), 5.0f);
  for (const double diameter : {1e-8, 0.0093, 1.0, 3.0})
    EXPECT_NEAR(irradiance(test::sun_light(diameter), facing), 5.0, 1e-5) << diameter;
}

TEST(Irradiance, OfASphereMatchesAPointAtItsCentre) {
  // A sphere light that the horizon does not cut acts as a point light at its centre.
  for (const double radius : {1e-4, 0.5, 1.9}) {
    EXPECT_NEAR(irradiance(test::ball_light(radius), {{0, 0, 0}, up, up}), 1.25, 1e-6) << radius;
  }
  Light spot = test::spot_light();
  const Receiver aside{{1.0, 0, 0}, up, up};
  const double point = irradiance(spot, aside);
  spot.radius = 0.5;
  EXPECT_NEAR(irradiance(spot, aside), point, 1e-6) << "cone and range use its centre";
  EXPECT_GT(point, 0.0);
}

TEST(Irradiance, OfALinearLightIsItsCandelaFarAwayAndSquareOn) {
  const Light light = test::linear_light();
  const glm::dvec3 square_on = glm::normalize(glm::dvec3(-0.2, 0.9, 0));
  for (const LightRule rule : {LightRule::physical, LightRule::published}) {
    const Receiver far{light.position - 1000.0 * square_on, square_on, square_on};
    EXPECT_NEAR(irradiance(light, far, rule) * 1e6 / 5.0, 1.0, 1e-5);
  }
}

TEST(Irradiance, OfFlatLightsIsRadianceTimesAreaOverTheSquareFarAway) {
  const Receiver far{{0, -998, 0}, up, up};
  const double areas[] = {4 * 0.8 * 0.5, pi * 0.49, 0.84 + 0.6 + 0.04 - 0.045};
  const Light lights[] = {test::rectangle_light(), test::disk_light(), test::polygon_light()};
  for (int i = 0; i < 3; ++i) {
    for (const LightRule rule : {LightRule::physical, LightRule::published})
      EXPECT_NEAR(irradiance(lights[i], far, rule) * 1e6 / 5.0, areas[i], 1e-5) << lights[i].name;
  }
}

TEST(Irradiance, OfOneSidedLightsStopsAtTheirPlane) {
  for (Light light : {test::rectangle_light(), test::disk_light(), test::polygon_light()}) {
    const Receiver below{{0.2, 1, 0.1}, up, up};
    const Receiver above{{0.2, 3, 0.1}, -up, -up};
    for (const LightRule rule : {LightRule::physical, LightRule::published}) {
      EXPECT_GT(irradiance(light, below, rule), 0.0) << light.name;
      EXPECT_EQ(irradiance(light, above, rule), 0.0) << light.name;
      Light both = light;
      both.two_sided = true;
      EXPECT_FLOAT_EQ(irradiance(both, below, rule), irradiance(light, below, rule)) << light.name;
      EXPECT_FLOAT_EQ(irradiance(both, above, rule), irradiance(light, below, rule)) << light.name;
    }
  }
}

/// A flat light of this type with a random orientation and place.
Light turned_light(Light::Type type, RandomSpace& space) {
  Light light = test::rectangle_light();
  light.type = type;
  light.position = 7.0 * space.direction();
  light.direction = space.direction();
  light.half_u = 0.8 * space.perpendicular(light.direction);
  light.half_v = 0.5 / 0.8 * glm::cross(light.direction, light.half_u);
  light.radius = 0.6;
  light.two_sided = true;
  light.outlines = {{}};
  for (int k = 0; k < 5; ++k) {
    const double angle = 0.4 * pi * k;
    light.outlines[0].push_back(light.position + std::cos(angle) * light.half_u +
                                std::sin(angle) * light.half_v);
  }
  return light;
}

// An emissive surface is in the plane of its own light, except for rounding. The light would fill
// half of all directions or none, depending on the rounding.
TEST(Irradiance, IsNothingInTheLightsOwnPlane) {
  RandomSpace space(7);
  for (const Light::Type type : {Light::Type::rectangle, Light::Type::polygon, Light::Type::disk}) {
    for (int i = 0; i < 200; ++i) {
      const Light light = turned_light(type, space);
      const PreparedLight prepared = prepare_light(light);
      const glm::dvec3 at = light.position + space.between(-0.3, 0.3) * light.half_u +
                            space.between(-0.3, 0.3) * light.half_v;
      const double side = i % 2 == 0 ? 1.0 : -1.0;
      const glm::dvec3 normal = side * prepared.towards;
      const Receiver in_it{glm::dvec3(glm::vec3(at)), normal, normal};
      EXPECT_EQ(unshadowed_irradiance(prepared, in_it), glm::vec3(0.0f)) << i;
      for (const glm::dvec2 p : {glm::dvec2(0.1, 0.9), glm::dvec2(0.5, 0.5)})
        EXPECT_EQ(sample_light(prepared, in_it, p.x, p.y).irradiance, glm::vec3(0.0f)) << i;
      // A millimetre behind one metre of light, it fills nearly all of the hemisphere.
      const Receiver beside{at - 1e-3 * normal, normal, normal};
      EXPECT_GT(unshadowed_irradiance(prepared, beside).r, 0.99 * pi * 5.0) << i;
    }
  }
}

TEST(Irradiance, ByThePublishedRuleIsThatOfTheMiddle) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.1, 1, 0));
  const Receiver receiver{{1, 0, 0}, normal, up};
  const auto at_middle = [&](const Light& light) {
    const glm::dvec3 middle = prepare_light(light).position - receiver.position;
    const double d = glm::length(middle);
    return std::array{glm::dot(middle, normal) / (d * d * d), middle.y / d};
  };
  const auto published = [&](const Light& light) {
    return irradiance(light, receiver, LightRule::published);
  };
  const auto [flat, flat_cosine] = at_middle(test::rectangle_light());
  EXPECT_NEAR(published(test::rectangle_light()), 5 * 1.6 * flat * flat_cosine, 1e-5);
  EXPECT_NEAR(published(test::disk_light()), 5 * pi * 0.49 * flat * flat_cosine, 1e-5);
  EXPECT_NEAR(published(test::ball_light()), 5 * flat, 1e-6) << "without the light's cosine";
  const double tangent = std::tan(0.25);
  const double sine = std::sin(0.25);
  EXPECT_NEAR(published(test::sun_light()), 5 * normal.y * tangent * tangent / (sine * sine), 1e-5);
}

TEST(Irradiance, OfPreparedPolygonsDoesNotDependOnHowTheyWereWritten) {
  const Light light = test::polygon_light();
  test::RandomSpace random(11);
  std::vector<std::vector<glm::dvec2>> flat;
  for (const auto& outline : light.outlines) {
    auto& corners = flat.emplace_back();
    for (const glm::dvec3& p : outline) corners.emplace_back(p.x, p.z);
  }
  const test::FlatRegion region = test::polygon_region({0, 2, 0}, {1, 0, 0}, {0, 0, 1}, flat);
  for (int i = 0; i < 60; ++i) {
    Light written = light;
    if (i & 1) std::reverse(written.outlines[0].begin(), written.outlines[0].end());
    if (i & 2) std::reverse(written.outlines[1].begin(), written.outlines[1].end());
    if (i & 4) std::swap(written.outlines[0], written.outlines[1]);
    written.position = random.direction();
    const glm::dvec3 place(random.between(-1, 1), random.between(0, 1.9), random.between(-1, 1));
    const Receiver receiver = random.receiver(place, {0, 2, 0}, i);
    const double expected = 5.0 * test::flat_oracle(region, receiver);
    EXPECT_NEAR(irradiance(written, receiver), expected, 1e-5 * expected + 1e-9) << i;
  }
}

TEST(Irradiance, DoesNotChangeWithTheScaleOfTheWorld) {
  test::RandomSpace random(12);
  for (const Light& light : test::all_lights()) {
    for (int i = 0; i < 24; ++i) {
      const Receiver receiver = random.receiver(1.5 * random.direction(), {0, 2, 0}, i);
      for (const LightRule rule : {LightRule::physical, LightRule::published}) {
        const double once = irradiance(light, receiver, rule);
        for (const double scale : {1e-4, 1e4}) {
          Receiver moved = receiver;
          moved.position *= scale;
          EXPECT_NEAR(irradiance(test::scaled(light, scale), moved, rule), once, 1e-5 * once + 1e-9)
              << light.name << " times " << scale << ", round " << i;
        }
      }
    }
  }
}

TEST(Irradiance, OfASegmentIsThatOfItsParts) {
  test::RandomSpace random(13);
  for (const LightRule rule : {LightRule::physical, LightRule::published}) {
    const PreparedLight light = prepare_light(test::linear_light(), rule);
    for (int i = 0; i < 24; ++i) {
      const Receiver receiver = random.receiver(random.direction(), {0, 2, 0}, i);
      const double split = random.between(-1, 1);
      const double sum = segment_irradiance(light, receiver, -1.0, split).r +
                         segment_irradiance(light, receiver, split, 1.0).r;
      EXPECT_NEAR(sum, unshadowed_irradiance(light, receiver).r, 1e-6);
    }
  }
}

TEST(Attenuation, IsTheExtensionsRangeAndCone) {
  Light light = test::point_light();
  light.range = 4.0;
  EXPECT_DOUBLE_EQ(attenuation(prepare_light(light), {0, 0, 0}), 1.0 - 1.0 / 16.0);
  EXPECT_EQ(attenuation(prepare_light(light), {0, -2, 0}), 0.0);
  EXPECT_EQ(attenuation(prepare_light(light), {0, -1e300, 0}), 0.0);

  light = test::spot_light();
  light.range = std::numeric_limits<double>::infinity();
  const PreparedLight spot = prepare_light(light);
  const auto at_angle = [&](double angle) {
    return attenuation(spot, {std::sin(angle), 2.0 - std::cos(angle), 0.0});
  };
  EXPECT_EQ(at_angle(0.29), 1.0);
  EXPECT_EQ(at_angle(1.21), 0.0);
  const double share = (std::cos(0.8) - std::cos(1.2)) / (std::cos(0.3) - std::cos(1.2));
  EXPECT_NEAR(at_angle(0.8), share * share, 1e-14);
  EXPECT_EQ(attenuation(prepare_light(test::linear_light()), {0, -100, 0}), 1.0);
}

}  // namespace
}  // namespace asos::irradiance_test
