#include "tests/support/light_oracle.h"
#include "tests/support/make_light.h"
#include "tests/support/random_space.h"
#include "tests/support/shadow_fixture.h"
#include "tests/support/shadow_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Penumbrae of round lights and of polygons with holes behind a half-plane, against slow
// quadrature: the plane through the receiver and the occluder's edge acts as another horizon.

namespace asos::test::penumbra_round_test {
namespace {

/// A half-plane between receiver and light; the plane of its edge has an offset from the light's
/// centre.
struct Case {
  Receiver receiver;
  Receiver behind;  ///< the same with the occluder's edge as its second horizon
};

/// Adds a screen to `world` at the fraction `height` of the way from the receiver to `middle`. Its
/// edge appears at `offset` times the light's `radius` from the centre.
Case add_screen(World& world, RandomSpace& random, const Receiver& receiver, glm::dvec3 middle,
                double radius, double offset) {
  const glm::dvec3 way = middle - receiver.position;
  const double height = random.between(0.2, 0.6);
  const glm::dvec3 across = random.perpendicular(glm::normalize(way));
  const glm::dvec3 through = receiver.position + height * (way + offset * radius * across);
  const glm::dvec3 edge =
      glm::normalize(glm::cross(across, way) / glm::length(way) + 0.1 * random.direction());
  const glm::dvec3 inwards =
      glm::normalize(across + random.between(-0.2, 0.2) * glm::normalize(way));
  const Polygon3 quad = add_occluder(world, through - 50.0 * edge, 100.0 * edge, 50.0 * inwards);
  Case c{receiver, receiver};
  glm::dvec3 open =
      glm::normalize(glm::cross(quad[0] - receiver.position, quad[1] - receiver.position));
  if (glm::dot(open, quad[2] - receiver.position) > 0.0) open = -open;
  c.behind.geometric = open;
  return c;
}

/// Receivers at the origin: facing the light, tilted away, and with the light at the horizon.
Receiver receiver_of(RandomSpace& random, glm::dvec3 middle, int kind) {
  Receiver receiver = random.receiver({0, 0, 0}, middle, kind % 3);
  if (kind % 4 == 0) receiver.normal = glm::normalize(middle);
  receiver.normal = glm::dvec3(glm::vec3(receiver.normal));
  receiver.geometric = receiver.normal;
  return receiver;
}

using Form = double (*)(const Light& light, const Receiver& receiver);

/// For 300 screens: the visible fraction is the ratio of the oracle's two forms.
void expect_screens(std::uint64_t seed, Light (*make)(RandomSpace&), double reach, Form oracle) {
  RandomSpace random(seed);
  double worst = 0.0;
  int partly = 0;
  for (int i = 0; i < 300; ++i) {
    const Light light = make(random);
    const bool sun = light.type == Light::Type::directional;
    const glm::dvec3 middle = sun ? -3.0 * light.direction : light.position;
    const double radius =
        sun ? 3.0 * std::tan(0.5 * light.angular_diameter_rad) : std::max(light.radius, reach);
    const Receiver receiver = receiver_of(random, middle, i);
    World world;
    const Case c = add_screen(world, random, receiver, middle, radius, random.between(-1.05, 1.05));
    const double all = oracle(light, receiver);
    if (all < 1e-4) continue;
    ShadowFixture fixture(std::move(world), light);
    const double exact = oracle(light, c.behind) / all;
    const double found = fixture.visibility(c.receiver);
    EXPECT_NEAR(found, exact, 1e-4) << i;
    worst = std::max(worst, std::abs(found - exact));
    partly += exact > 0.01 && exact < 0.99;
  }
  testing::Test::RecordProperty("worst_error", testing::PrintToString(worst));
  EXPECT_GT(partly, 100);
}

TEST(RoundPenumbra, OfABallIsExact) {
  expect_screens(
      1,
      [](RandomSpace& random) {
        Light light{.position = 3.0 * random.direction(),
                    .radius = std::pow(10.0, random.between(-3.0, 0.0))};
        return light;
      },
      0.0,
      [](const Light& light, const Receiver& receiver) {
        const double distance = glm::length(light.position);
        return cone_oracle(light.position / distance, std::asin(light.radius / distance), receiver);
      });
}

TEST(RoundPenumbra, OfASunIsExact) {
  expect_screens(
      2,
      [](RandomSpace& random) {
        Light light = make_sun(random.direction());
        light.angular_diameter_rad = random.between(0.005, 0.8);
        return light;
      },
      0.0,
      [](const Light& light, const Receiver& receiver) {
        return cone_oracle(-light.direction, 0.5 * light.angular_diameter_rad, receiver);
      });
}

/// Axes of a flat light's plane that are counter-clockwise as seen by a receiver at the origin.
std::pair<glm::dvec3, glm::dvec3> axes_of(const Light& light) {
  const double side = glm::dot(light.direction, light.position) > 0.0 ? 1.0 : -1.0;
  const glm::dvec3 x = glm::normalize(light.half_u);
  return {x, glm::cross(-side * light.direction, x)};
}

Light flat_light(RandomSpace& random) {
  Light light{.type = Light::Type::disk, .position = 3.0 * random.direction()};
  do light.direction = random.direction();
  while (std::abs(glm::dot(light.direction, light.position)) < 0.3);
  light.half_u = random.perpendicular(light.direction);  // of no effect on a disk
  light.two_sided = true;
  return light;
}

TEST(RoundPenumbra, OfADiskIsExact) {
  expect_screens(
      3,
      [](RandomSpace& random) {
        Light light = flat_light(random);
        light.radius = random.between(0.01, 1.0);
        return light;
      },
      0.0,
      [](const Light& light, const Receiver& receiver) {
        const auto [x, y] = axes_of(light);
        return flat_oracle(disk_region(light.position, x, y, light.radius), receiver, 1e-7);
      });
}

// An L with a hole, in units of its plane's axes.
const std::vector<std::vector<glm::dvec2>> outlines = {
    {{-0.6, -0.6}, {0.8, -0.6}, {0.8, 0.0}, {0.0, 0.1}, {0.0, 1.0}, {-0.6, 1.0}},
    {{-0.4, -0.4}, {-0.4, -0.1}, {-0.1, -0.3}}};

TEST(RoundPenumbra, OfAPolygonWithAHoleIsExact) {
  expect_screens(
      4,
      [](RandomSpace& random) {
        Light light = flat_light(random);
        light.type = Light::Type::polygon;
        const glm::dvec3 x = light.half_u, y = glm::cross(light.direction, x);
        for (const auto& outline : outlines) {
          auto& corners = light.outlines.emplace_back();
          for (const glm::dvec2& p : outline) corners.push_back(light.position + p.x * x + p.y * y);
        }
        return light;
      },
      0.8,
      [](const Light& light, const Receiver& receiver) {
        const auto [x, y] = axes_of(light);
        std::vector<std::vector<glm::dvec2>> flat;
        for (const auto& outline : light.outlines) {
          auto& corners = flat.emplace_back();
          for (const glm::dvec3& p : outline)
            corners.emplace_back(glm::dot(p - light.position, x), glm::dot(p - light.position, y));
        }
        return flat_oracle(polygon_region(light.position, x, y, flat), receiver, 1e-7);
      });
}

}  // namespace
}  // namespace asos::test::penumbra_round_test
