#include "ui/edited_light.h"

#include "renderer/gltf/validate_light.h"
#include "renderer/lights/prepared_light.h"
#include "tests/support/tiny_scene.h"
#include "ui/new_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace asos {
using namespace ui;
namespace {

constexpr std::array all_kinds{LightKind::point,       LightKind::sphere, LightKind::spot,
                               LightKind::directional, LightKind::linear, LightKind::rectangle,
                               LightKind::disk,        LightKind::polygon};
static_assert(all_kinds.size() == light_kind_count);

const SceneSize unit_scene{glm::dvec3(0.0), 1.0};

Light small_ball() {
  return {.intensity = 40.0f, .position = {3, 4, 0}, .radius = 0.01};
}

// Irradiance at the centre on a surface that faces the light.
double irradiance_in_the_middle(const Light& light) {
  const glm::dvec3 up =
      light.type == Light::Type::directional ? -light.direction : glm::normalize(light.position);
  const glm::vec3 e = unshadowed_irradiance(prepare_light(light), {glm::dvec3(0.0), up, up});
  return static_cast<double>(e.x);
}

TEST(EditedLight, AnotherKindIsSoundAndAsBright) {
  for (const LightKind from : all_kinds) {
    const Light first = as_kind(small_ball(), from, unit_scene);
    for (const LightKind to : all_kinds) {
      const Light light = as_kind(first, to, unit_scene);
      EXPECT_EQ(kind_of(light), to);
      EXPECT_EQ(gltf::validate_light(light), "")
          << static_cast<int>(from) << " to " << static_cast<int>(to);
      if (from == LightKind::directional) continue;  // a sun has no position
      // The irradiance at the scene's centre stays.
      EXPECT_NEAR(irradiance_in_the_middle(light), 40.0 / 25.0, 40.0 / 25.0 * 0.01)
          << static_cast<int>(from) << " to " << static_cast<int>(to);
    }
  }
}

TEST(EditedLight, ALampThatWasDirectionalReturnsToItsPlace) {
  for (const LightKind kind : all_kinds) {
    if (kind == LightKind::directional) continue;
    const Light lamp = as_kind(small_ball(), kind, unit_scene);
    const Light sun = as_kind(lamp, LightKind::directional, unit_scene);
    const Light again = as_kind(sun, kind, unit_scene, true);
    EXPECT_EQ(again.position, lamp.position) << static_cast<int>(kind);
    EXPECT_NE(as_kind(sun, kind, unit_scene).position, lamp.position) << "a sun of the file";
    EXPECT_NEAR(irradiance_in_the_middle(again), 40.0 / 25.0, 40.0 / 25.0 * 0.01);
  }
}

TEST(EditedLight, SizeIsKeptFromKindToKind) {
  const Light disk = as_kind(small_ball(), LightKind::disk, unit_scene);
  EXPECT_DOUBLE_EQ(disk.radius, 0.01);
  const Light sun = as_kind(disk, LightKind::directional, unit_scene);
  EXPECT_NEAR(sun.angular_diameter_rad, 2.0 * std::atan(0.01 / 5.0), 1e-12);
  EXPECT_EQ(as_kind(small_ball(), LightKind::point, unit_scene).radius, 0.0);
}

// A lamp among small objects keeps its size for every kind of light. The brightness at the subject
// stays, even if the light is near and does not face it.
TEST(EditedLight, ASmallLampStaysSmallAsAnyKind) {
  Light lamp{.intensity = 185.0f, .position = {0.3, 0.5, 0.2}};
  const SceneSize looked_at{{0.1, 0.0, 0.0}, 0.5};
  const auto arriving = [&](const Light& light) {
    const glm::dvec3 way = light.type == Light::Type::directional
                               ? -light.direction
                               : glm::normalize(light.position - looked_at.middle);
    return static_cast<double>(
        unshadowed_irradiance(prepare_light(light), {looked_at.middle, way, way}).x);
  };
  const double before = arriving(lamp);
  for (const LightKind kind : all_kinds) {
    const Light other = as_kind(lamp, kind, looked_at);
    EXPECT_NEAR(arriving(other), before, 1e-3 * before) << static_cast<int>(kind);
    EXPECT_LT(std::sqrt(area_of(other)), 0.1) << static_cast<int>(kind);
    EXPECT_NEAR(arriving(as_kind(other, LightKind::disk, looked_at)), before, 1e-3 * before)
        << static_cast<int>(kind);
  }
}

// A tenth of the distance wide, for any scene size, so that the penumbra is visible.
TEST(EditedLight, ALightWithoutSizeGetsOneThatSoftensShadows) {
  Light bulb = small_ball();
  bulb.radius = 0.0;
  for (const double scene_radius : {0.1, 1.0, 40.0}) {
    const SceneSize scene{glm::dvec3(0.0), scene_radius};
    for (const LightKind kind : {LightKind::sphere, LightKind::spot, LightKind::disk})
      EXPECT_NEAR(as_kind(bulb, kind, scene).radius, 0.25, 1e-12) << static_cast<int>(kind);
    const Light rectangle = as_kind(bulb, LightKind::rectangle, scene);
    EXPECT_NEAR(glm::length(rectangle.half_u), 0.25, 1e-12);
    EXPECT_NEAR(glm::length(as_kind(bulb, LightKind::linear, scene).half_u), 0.25, 1e-12);
    EXPECT_NEAR(polygon_radius(as_kind(bulb, LightKind::polygon, scene)), 0.25, 1e-12);
    EXPECT_NEAR(as_kind(bulb, LightKind::directional, scene).angular_diameter_rad,
                2.0 * std::atan(0.05), 1e-12);
  }
}

TEST(EditedLight, APolygonTellsItsShape) {
  Light light = as_kind(small_ball(), LightKind::polygon, unit_scene);
  EXPECT_EQ(polygon_shape(light), PolygonShape::hexagon);
  for (std::size_t i = 0; i < polygon_shape_count; ++i) {
    set_polygon_shape(light, static_cast<PolygonShape>(i));
    set_polygon_radius(light, 0.3 + 0.1 * static_cast<double>(i));
    turn_light(light, {0.4 + static_cast<double>(i), -0.6, 1.1});
    move_light(light, {1, 2, 3});
    EXPECT_EQ(polygon_shape(light), static_cast<PolygonShape>(i));
  }
  light.outlines[0][1] *= 1.01;
  EXPECT_EQ(polygon_shape(light), std::nullopt);
}

TEST(EditedLight, FlatLightsKeepTheirPower) {
  for (const LightKind kind : {LightKind::rectangle, LightKind::disk, LightKind::polygon}) {
    Light light = as_kind(small_ball(), kind, unit_scene);
    const double area = area_of(light), power = area * static_cast<double>(light.intensity);
    light.radius *= 3.0;
    light.half_u *= 3.0;
    if (kind == LightKind::polygon) set_polygon_radius(light, 2.0);
    keep_power(light, area);
    EXPECT_GT(area_of(light), 2.0 * area);
    EXPECT_NEAR(area_of(light) * static_cast<double>(light.intensity), power, 1e-6 * power);
  }
  Light ball = small_ball();
  keep_power(ball, 0.0);
  EXPECT_EQ(ball.intensity, small_ball().intensity);
}

TEST(EditedLight, OutlinesHaveTheirAreas) {
  Light light = as_kind(small_ball(), LightKind::polygon, unit_scene);
  set_polygon_radius(light, 2.0);
  EXPECT_NEAR(polygon_radius(light), 2.0, 1e-12);
  const double star = 10.0 * 0.5 * 2.0 * 0.8 * std::sin(std::numbers::pi / 5.0);
  for (const auto& [shape, area] : {std::pair{PolygonShape::hexagon, 6.0 * std::sqrt(3.0)},
                                    std::pair{PolygonShape::triangle, 3.0 * std::sqrt(3.0)},
                                    std::pair{PolygonShape::star, star},
                                    std::pair{PolygonShape::frame, 2.0 * 4.0 * (1.0 - 0.36)}}) {
    set_polygon_shape(light, shape);
    EXPECT_NEAR(area_of(light), area, 1e-9);
    EXPECT_NEAR(prepare_light(light).area, area, 1e-9);
    EXPECT_EQ(gltf::validate_light(light), "");
  }
}

TEST(EditedLight, TurnsAreWhatWasAskedFor) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-3.1, 3.1), height(-1.5, 1.5);
  for (const LightKind kind : {LightKind::rectangle, LightKind::polygon, LightKind::spot}) {
    Light light = as_kind(small_ball(), kind, unit_scene);
    const double area = area_of(light);
    for (int i = 0; i < 100; ++i) {
      LightTurn turn{angle(random), height(random), angle(random)};
      if (kind == LightKind::spot) turn.roll_rad = 0.0;
      turn_light(light, turn);
      const LightTurn got = turn_of(light);
      EXPECT_NEAR(got.azimuth_rad, turn.azimuth_rad, 1e-9);
      EXPECT_NEAR(got.elevation_rad, turn.elevation_rad, 1e-9);
      EXPECT_NEAR(got.roll_rad, turn.roll_rad, 1e-9);
      ASSERT_EQ(gltf::validate_light(light), "");
    }
    EXPECT_NEAR(area_of(light), area, 1e-9 * area);
  }
}

TEST(EditedLight, ALineRunsWhereItIsTurnedTo) {
  Light light = as_kind(small_ball(), LightKind::linear, unit_scene);
  turn_light(light, {0.5 * std::numbers::pi, 0.0, 0.0});
  EXPECT_NEAR(glm::normalize(light.half_u).x, 1.0, 1e-12);
  turn_light(light, {0.0, 0.5 * std::numbers::pi, 0.0});
  EXPECT_NEAR(glm::normalize(light.half_u).y, 1.0, 1e-12);
}

TEST(EditedLight, TidyingKeepsThePower) {
  Light light = as_kind(small_ball(), LightKind::polygon, unit_scene);
  light.color = {4, 2, 1};
  const double area = area_of(light);
  light.position = light.outlines[0][1];
  const glm::vec3 power = light.color * light.intensity;
  tidy_light(light);
  EXPECT_EQ(light.color * light.intensity, power);
  EXPECT_EQ(light.color.x, 1.0f);
  EXPECT_NEAR(polygon_radius(light), 0.01, 1e-9) << "around its middle";
  EXPECT_NEAR(area_of(light), area, 1e-15);
}

TEST(NewLights, MakeAWhiteSurfaceHalfWhite) {
  const Light light = new_light({0, 6, 0}, {0, 0, 0}, 3.0);
  EXPECT_EQ(kind_of(light), LightKind::sphere);
  EXPECT_NEAR(irradiance_in_the_middle(light) / std::numbers::pi, 0.5, 0.02);
  EXPECT_NEAR(light.radius, 0.05 * 3.0, 1e-12) << "of its distance, for a penumbra";
  EXPECT_NEAR(new_light({0, 6, 0}, {0, 0, 0}, 0.1).radius, 0.05 * 3.0, 1e-12);
}

// A face of a box: two triangles of a part; its other faces are not included.
TEST(NewLights, AFaceBecomesALightOfItsOutline) {
  World world;
  std::vector<test::TinyVertex> corners;
  for (const glm::vec3 p : {glm::vec3(0, 0, 0), glm::vec3(2, 0, 0), glm::vec3(2, 3, 0),
                            glm::vec3(0, 3, 0), glm::vec3(0, 0, -1), glm::vec3(2, 0, -1)})
    corners.push_back({p, {0, 0, 1}, {0, 0}});
  test::add_part(world, corners, {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 1}}, Material{});
  world.parts[0].name = "box";
  const auto scene = test::make_render_scene(world);
  for (const double side : {5.0, -5.0}) {
    const auto light = light_on_face(*scene, 1, {0, 0, side});
    ASSERT_TRUE(light.has_value());
    EXPECT_EQ(light->name, "face of box");
    EXPECT_NEAR(area_of(*light), 6.0, 1e-6);
    EXPECT_NEAR(light->direction.z, side > 0.0 ? 1.0 : -1.0, 1e-9) << "to the viewer";
    EXPECT_GT(light->position.z * side, 0.0) << "before the surface";
    EXPECT_NEAR(light->position.z, 0.0, 0.01);
    EXPECT_EQ(gltf::validate_light(*light), "");
  }
  const auto floor = light_on_face(*scene, 2, {0, 5, 0});
  ASSERT_TRUE(floor.has_value());
  EXPECT_NEAR(area_of(*floor), 2.0, 1e-6);
}

TEST(NewLights, ATriangleWithoutAreaBecomesNone) {
  World world;
  test::add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Material{});
  test::add_triangle(world, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}, Material{});
  EXPECT_FALSE(light_on_face(*test::make_render_scene(world), 1, {0, 0, 5}).has_value());
}

}  // namespace
}  // namespace asos
