#include "renderer/shading/unevenness.h"

#include "tests/support/make_light.h"
#include "tests/support/tiny_world.h"
#include "tests/support/white_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asos::test {
namespace {

Material white() {
  return {.base_color = glm::vec4(1.0f)};
}

/// A triangle in the plane z = 0 whose normals rotate about the y axis by `turn` per unit of x.
World bent(float turn) {
  World world;
  const auto normal = [&](float x) {
    return glm::vec3(std::sin(turn * x), 0.0f, std::cos(turn * x));
  };
  add_part(world,
           {{{-1, -1, 0}, normal(-1), {}}, {{1, -1, 0}, normal(1), {}}, {{0, 1, 0}, normal(0), {}}},
           {{0, 1, 2}}, white());
  return world;
}

const Hit middle{0, 1.0f, 0.25f, 0.5f};  // at the origin
constexpr glm::vec3 up{0, 0, 1};
constexpr float far = std::numeric_limits<float>::infinity();
const Ray from_above{.origin = up, .direction = -up};

Patch square(float side) {
  return {{side, 0, 0}, {0, side, 0}};
}

TEST(MidpointError, FlatShadingUnderDistantLightsHasNone) {
  EXPECT_EQ(midpoint_error(bent(0.0f), {}, from_above, middle, square(1.0f), far), 0.0f);
}

// The mean of a cosine over an angle is sin(turn / 2) / (turn / 2) of its value at the centre. If
// the centre is at a right angle to the light, the half beyond it is dark.
TEST(MidpointError, OfATurningNormalIsBetweenThoseOfALitAndAGrazedCosine) {
  const auto error = [](float turn) {
    return midpoint_error(bent(turn), {}, from_above, middle, square(1.0f), far);
  };
  const auto grazed = [](float turn) { return (1.0f - std::cos(0.5f * turn)) / turn; };
  for (const float turn : {0.05f, 0.2f, 0.5f}) {
    const float lit = 1.0f - std::sin(0.5f * turn) / (0.5f * turn);
    // The chord between normals is shorter than their arc by turn^2 / 6 over the whole triangle.
    EXPECT_NEAR(error(turn), 8.0f * lit, 8.0f * lit * turn * turn) << turn;
    EXPECT_GT(8.0f * grazed(turn), error(turn)) << turn;
  }
  EXPECT_GT(error(0.4f), grazed(0.4f));
  EXPECT_GT(error(0.8f), grazed(0.8f));
}

TEST(MidpointError, FallsWithTheSquareOfTheSize) {
  const World world = bent(0.3f);
  EXPECT_NEAR(midpoint_error(world, {}, from_above, middle, square(0.5f), far),
              midpoint_error(world, {}, from_above, middle, square(1.0f), far) / 4.0f, 1e-7f);
}

// Along the line to the light, 1 / (r - x)^2 has the mean 1 / (r^2 - h^2 / 4) over an edge of
// length h, so the relative error is h^2 / 4 r^2 = 6 / 24 (h / r)^2 to second order.
TEST(MidpointError, NearALightIsThatOfTheInverseSquare) {
  const World world = bent(0.0f);
  Light light{.position = {0, 0, 2}};
  const float side = 0.2f;
  const Patch edge{{side, 0, 0}, {0, 0, 0}};
  EXPECT_NEAR(midpoint_error(world, {&light, 1}, from_above, middle, edge, far),
              side * side / (4.0f * 4.0f), 1e-6f);
  light.type = Light::Type::directional;
  EXPECT_EQ(midpoint_error(world, {&light, 1}, from_above, middle, edge, far), 0.0f);
}

TEST(MidpointError, IsNoMoreThanWhatTheMaterialReflects) {
  World world = bent(1.0f);
  world.materials.front().base_color = glm::vec4(0.0f, 0.1f, 0.05f, 1.0f);
  EXPECT_NEAR(midpoint_error(world, {}, from_above, middle, square(1.0f), far),
              0.1f * midpoint_error(bent(1.0f), {}, from_above, middle, square(1.0f), far), 1e-7f);
  world.materials.front().unlit = true;
  EXPECT_EQ(midpoint_error(world, {}, from_above, middle, square(1.0f), far), 0.0f);
}

// A highly glossy cylinder under a light behind the viewer: the highlight is where the normal
// points at both. Elsewhere its tail is far below one display step.
TEST(MidpointError, KnowsWhereAHighlightMayLie) {
  World world = bent(0.1f);
  Material& material = world.materials.front();
  material.metallic = 1.0f;
  material.roughness = 0.2f;
  Light light = make_sun({0, 0, -1}, 3.0f);
  const float diffuse = midpoint_error(bent(0.1f), {}, from_above, middle, square(1.0f), far);
  EXPECT_GT(midpoint_error(world, {&light, 1}, from_above, middle, square(1.0f), far), 0.5f);
  light.direction = glm::normalize(glm::vec3(-1, 0, -1));
  EXPECT_LT(midpoint_error(world, {&light, 1}, from_above, middle, square(1.0f), far),
            diffuse + 1.0f / 1024.0f);
  light.direction = {0, 0, -1};
  world.materials.front().roughness = 1.0f;
  EXPECT_NEAR(midpoint_error(world, {&light, 1}, from_above, middle, square(1.0f), far), diffuse,
              1e-7f);
}

// With a near viewer or a near light, the half vector varies over a flat surface.
TEST(MidpointError, KnowsWhereAHighlightOnAFlatSurfaceIsNarrow) {
  World world = bent(0.0f);
  Material& material = world.materials.front();
  material.metallic = 1.0f;
  material.roughness = 0.2f;
  Light light = make_sun({0, 0, -1}, 3.0f);
  const auto error = [&](float side, float viewer_distance) {
    return midpoint_error(world, {&light, 1}, from_above, middle, square(side), viewer_distance);
  };
  EXPECT_EQ(error(0.01f, far), 0.0f);
  const float near = error(0.01f, 1.0f);
  EXPECT_GT(near, 0.0f);
  // The half vector changes by half of the change of the view direction.
  EXPECT_NEAR(error(0.01f, 2.0f), near / 4.0f, 1e-3f * near);
  light.type = Light::Type::point;
  light.position = {0, 0, 2};
  light.intensity *= 4.0f;
  const float falls_off = 2.0f * 0.01f * 0.01f / (4.0f * 4.0f);  // with the square of the distance
  EXPECT_NEAR(error(0.01f, far), near / 4.0f + falls_off, 1e-3f * near);
  EXPECT_GT(error(0.3f, 1.0f), 0.1f);
}

TEST(MidpointError, IsTheMostAtALightAndNothingWhereNothingIsKnown) {
  const World world = bent(0.5f);
  const Light light;  // at the very point
  EXPECT_EQ(midpoint_error(world, {&light, 1}, from_above, middle, square(1.0f), far), 1.0f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(midpoint_error(world, {&light, 1}, from_above, middle, square(nan), far), 0.0f);
}

TEST(GlintError, IsThatOfNormalsThatScatterAHighlight) {
  Light light = make_sun({0, 0, -1}, 3.0f);
  const auto error = [&](float roughness, float variance) {
    SurfacePoint point;
    point.shading_normal = up;
    point.spread.variance = variance;
    return glint_error({&light, 1}, white_lobe(roughness), point, up);
  };
  EXPECT_EQ(error(0.2f, 0.0f), 0.0f);
  EXPECT_GT(error(0.2f, 0.01f), 0.5f);
  EXPECT_EQ(error(1.0f, 0.01f), 0.0f);
  EXPECT_LT(error(0.2f, 1e-6f), 0.01f);
  // Far from the highlight.
  light.direction = glm::normalize(glm::vec3(-1, 0, -0.2f));
  EXPECT_LT(error(0.2f, 1e-4f), 0.01f);
}

// A spot light above the origin, whose circle of light on z = 0 has radius 1.
PreparedLight spot(double inner, double outer) {
  Light light{.type = Light::Type::spot,
              .intensity = 100.0f,
              .position = {0, 0, 1},
              .direction = {0, 0, -1},
              .inner_cone_rad = inner,
              .outer_cone_rad = outer};
  return prepare_light(light);
}

Receiver on_floor(double x) {
  Receiver receiver{.position = {x, 0, 0}};
  receiver.normal = receiver.geometric = {0, 0, 1};
  return receiver;
}

TEST(ConeError, IsFoundWhereTheRimIs) {
  const double quarter = std::numbers::pi / 4.0;
  const PreparedLight sharp = spot(quarter - 1e-4, quarter);
  EXPECT_NEAR(cone_error(sharp, on_floor(1.0), square(0.1f)), 1.0f / 6.0f, 1e-6f);
  EXPECT_NEAR(cone_error(sharp, on_floor(1.04), square(0.1f)), 1.0f / 6.0f, 1e-6f);
  EXPECT_EQ(cone_error(sharp, on_floor(0.8), square(0.1f)), 0.0f);
  EXPECT_EQ(cone_error(sharp, on_floor(1.2), square(0.1f)), 0.0f);
  EXPECT_EQ(cone_error(sharp, on_floor(0.0), square(0.1f)), 0.0f);
}

TEST(ConeError, FallsWithTheSquareOfTheSizeForSoftRims) {
  const PreparedLight soft = spot(0.2, 1.2);
  const float large = cone_error(soft, on_floor(0.7), square(0.04f));
  const float small = cone_error(soft, on_floor(0.7), square(0.01f));
  EXPECT_GT(large, 0.0f);
  EXPECT_LT(large, 0.01f);
  EXPECT_NEAR(large / small, 16.0f, 1.0f);
}

TEST(ConeError, OnlySpotsHaveOneAndDimOnesLess) {
  const Light light = make_bulb({0, 0, 1}, 100.0f);
  EXPECT_EQ(cone_error(prepare_light(light), on_floor(1.0), square(0.1f)), 0.0f);
  PreparedLight dim = spot(0.7, 0.7001);
  const float bright = cone_error(dim, on_floor(std::tan(0.7)), square(0.1f));
  dim.power *= 1e-4f;
  EXPECT_LT(cone_error(dim, on_floor(std::tan(0.7)), square(0.1f)), 0.01f * bright);
}

}  // namespace
}  // namespace asos::test
