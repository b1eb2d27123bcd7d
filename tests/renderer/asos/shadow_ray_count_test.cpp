#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Number of rays needed to prove that nothing is between a surface and a light, and cases that need
// none.

namespace asos::test::shadow_ray_count_test {
namespace {

constexpr int width = 48, height = 32;

RenderSettings settings_with(int fat) {
  RenderSettings settings = make_settings(width, height);
  settings.asos.fat = fat;
  settings.asos.eps = 0.0;  // so that weak lights are not skipped
  settings.cull = false;
  settings.asos.refine_shading = false;
  return settings;
}

/// A floor that fills the picture, and a sphere that only shades points outside the view.
World plain() {
  World world;
  add_quad(world, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, matte({0.6f, 0.6f, 0.6f}));
  add_sphere(world, {30, 2, 0}, 1.0f, 6, matte({0.6f, 0.6f, 0.6f}));
  return world;
}

/// The same with one part in two far corners, so that its bounding box is between all points.
World plain_in_a_wide_box() {
  World world = plain();
  const std::vector<TinyVertex> vertices = {
      {{-40, 0.5f, 40}, {0, 1, 0}, {}}, {{-39, 0.5f, 40}, {0, 1, 0}, {}},
      {{-40, 0.5f, 39}, {0, 1, 0}, {}}, {{40, 9, -40}, {0, 1, 0}, {}},
      {{41, 9, -40}, {0, 1, 0}, {}},    {{40, 9, -41}, {0, 1, 0}, {}}};
  add_part(world, vertices, {{0, 1, 2}, {3, 4, 5}}, matte({0.6f, 0.6f, 0.6f}));
  return world;
}

Picture picture_of(World world, const std::vector<Light>& lights, const RenderSettings& settings) {
  const Camera camera = look_at({1.5, 2.0, 3.0}, {0.2, 0, 0.3}, 0.8);
  return render_picture(*make_render_scene(std::move(world), lights), camera, settings);
}

// Edges are searched once per fat pyray and light. Without edges a single surface may still cover
// all of the light, which one ray decides.
TEST(ShadowRayCount, OnAnOpenFloorIsOneForEachFatPyrayAndLight) {
  for (const int fat : {4, 8, 16}) {
    const std::vector<Light> lights = all_lights();
    const Picture picture = picture_of(plain_in_a_wide_box(), lights, settings_with(fat));
    const auto blocks = static_cast<std::uint64_t>((width / fat) * (height / fat));
    for (std::size_t i = 0; i < lights.size(); ++i) {
      EXPECT_LE(picture.statistics.of_light(i).shadow_rays, blocks) << lights[i].name << ' ' << fat;
      EXPECT_EQ(picture.statistics.of_light(i).shadow_pyrays, 0u) << lights[i].name << ' ' << fat;
    }
    EXPECT_GT(picture.statistics.shadow_rays, 0u);
  }
}

// The bounding boxes of the parts prove that nothing is between the floor and the lights.
TEST(ShadowRayCount, IsNoneWhereNoBoxLiesBetween) {
  for (const int fat : {4, 8}) {
    const Picture picture = picture_of(plain(), all_lights(), settings_with(fat));
    EXPECT_EQ(picture.statistics.shadow_rays, 0u) << fat;
    EXPECT_EQ(picture.statistics.shadow_pyrays, 0u) << fat;
  }
}

/// Lights without contribution to the floor.
std::vector<Light> lights_of_no_use() {
  std::vector<Light> lights;
  for (Light light : all_lights()) {
    light.name = "below " + light.name;
    light.position.y = -2.0;
    for (auto& outline : light.outlines)
      for (glm::dvec3& corner : outline) corner.y = -2.0;
    light.direction = {0, 1, 0};
    light.half_v = -light.half_v;
    for (auto& outline : light.outlines) outline = {outline.rbegin(), outline.rend()};
    lights.push_back(light);
  }
  for (Light light : {rectangle_light(), disk_light(), polygon_light()}) {
    light.name = "turned away " + light.name;
    light.direction = {0, 1, 0};
    light.half_v = -light.half_v;
    for (auto& outline : light.outlines) outline = {outline.rbegin(), outline.rend()};
    lights.push_back(light);
  }
  for (Light light : {point_light(), spot_light(), ball_light()}) {
    light.name = "out of range " + light.name;
    light.range = 1.5;
    lights.push_back(light);
  }
  Light spot = spot_light();
  spot.name = "aside spot";
  spot.direction = {0, 1, 0};
  lights.push_back(spot);
  Light black = rectangle_light();
  black.name = "black";
  black.intensity = 0.0f;
  lights.push_back(black);
  return lights;
}

TEST(ShadowRayCount, IsNoneForLightsThatGiveNothing) {
  const RenderSettings settings = settings_with(8);
  const Picture dark = picture_of(plain(), {}, settings);
  std::vector<Light> lights = lights_of_no_use();
  for (const Light& light : lights) {
    const Picture picture = picture_of(plain(), {light}, settings);
    EXPECT_EQ(picture.statistics.shadow_rays, 0u) << light.name;
    EXPECT_EQ(picture.statistics.shadow_pyrays, 0u) << light.name;
    EXPECT_EQ(picture.film.radiance, dark.film.radiance) << light.name;
  }
  // The same with another light that contributes, and refined shading.
  const std::size_t useful = lights.size();
  lights.push_back(rectangle_light());
  RenderSettings refined = settings;
  refined.asos.refine_shading = true;
  refined.asos.eps = 1.0 / 256.0;
  const Picture together = picture_of(plain(), lights, refined);
  for (std::size_t i = 0; i < useful; ++i)
    EXPECT_EQ(together.statistics.of_light(i), LightStatistics{}) << lights[i].name;
  EXPECT_NE(together.film.radiance, dark.film.radiance);
}

// The tolerance of each light is EPS divided by the number of lights. The shading by such a weak
// light is not refined, but a ray decides whether it is visible.
TEST(ShadowRayCount, IsOneAPixelForLightsTooWeakToMatter) {
  RenderSettings settings = settings_with(8);
  settings.asos.eps = 1.0 / 64.0;
  for (Light light : all_lights()) {
    light.intensity = 1e-3f;
    World world = plain();
    add_quad(world, {-0.5f, 1.0f, 0.5f}, {1, 0, 0}, {0, 0, -1}, matte({0.6f, 0.6f, 0.6f}));
    const Picture with = picture_of(world, {light}, settings);
    EXPECT_GT(with.statistics.shadow_rays, 0u) << light.name;
    EXPECT_LE(with.statistics.shadow_rays, with.film.radiance.size()) << light.name;
    RenderSettings exact = settings;
    exact.asos.eps = 1e-6;
    const Picture truth = picture_of(world, {light}, exact);
    double bias = 0.0, given = 0.0;
    for (std::size_t i = 0; i < with.film.radiance.size(); ++i) {
      const float off = with.film.radiance[i].x - truth.film.radiance[i].x;
      EXPECT_LE(std::abs(off), settings.asos.eps);
      bias += static_cast<double>(off);
      given += static_cast<double>(truth.film.radiance[i].x);
    }
    EXPECT_LT(std::abs(bias), 0.03 * given) << light.name;
  }
}

}  // namespace
}  // namespace asos::test::shadow_ray_count_test
