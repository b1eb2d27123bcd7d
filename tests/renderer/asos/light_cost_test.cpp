#include "tests/support/make_settings.h"
#include "tests/support/random_space.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Cost of shadow tests where there is no shadow, and the sum over many lights.

namespace asos::test::light_cost_test {
namespace {

RenderSettings settings_of(int width, int height) {
  RenderSettings settings = make_settings(width, height);
  settings.cull = false;
  settings.asos.refine_shading = false;
  return settings;
}

/// A floor with a block on it, for all kinds of lights.
World block_on_floor() {
  World world;
  const Material material = matte({0.6f, 0.6f, 0.6f});
  add_quad(world, {-5, 0, 5}, {10, 0, 0}, {0, 0, -10}, material);
  add_quad(world, {-0.3f, 0, 0.3f}, {0.6f, 0, 0}, {0, 0.6f, 0}, material);
  add_quad(world, {0.3f, 0, 0.3f}, {0, 0, -0.6f}, {0, 0.6f, 0}, material);
  add_quad(world, {-0.3f, 0.6f, 0.3f}, {0.6f, 0, 0}, {0, 0, -0.6f}, material);
  return world;
}

double rays_a_pixel(const Picture& picture, std::size_t lights) {
  return static_cast<double>(picture.statistics.shadow_rays) /
         static_cast<double>(picture.film.radiance.size() * lights);
}

TEST(LightCost, FarFromTheShadowHardlyAnyRaysAreCast) {
  const Camera camera = look_at({2.6, 1.5, 1.5}, {2.6, 0, 0.2}, 0.5);
  for (const Light& light : all_lights()) {
    const Picture picture =
        render_picture(*make_render_scene(block_on_floor(), {light}), camera, settings_of(64, 48));
    EXPECT_LT(rays_a_pixel(picture, 1), 0.1) << light.name;
  }
}

// A roof over everything: at most one ray per pixel and light proves the umbra.
TEST(LightCost, InTheUmbraOneRayAPixelIsEnough) {
  World world = block_on_floor();
  add_quad(world, {-5, 1, 5}, {10, 0, 0}, {0, 0, -10}, matte({0.6f, 0.6f, 0.6f}));
  const Camera camera = look_at({0.9, 0.7, 0.9}, {0.9, 0, 0.2}, 0.4);
  const Picture picture = render_picture(*make_render_scene(std::move(world), all_lights()), camera,
                                         settings_of(64, 48));
  EXPECT_LE(rays_a_pixel(picture, all_lights().size()), 1.0);
  EXPECT_GT(picture.statistics.shadow_rays, 0u);
}

// The pixels of a sphere do not lie in a common plane.
TEST(LightCost, OnARoundSurfaceOneRayAPixelIsEnough) {
  for (const Light& light : all_lights()) {
    World world;
    add_sphere(world, {0, 0, 0}, 0.5f, 40, matte({0.6f, 0.6f, 0.6f}));
    const Camera camera = look_at({0.9, 3, 0.5}, {0.14, 0.475, 0.07}, 0.02);
    const Picture picture =
        render_picture(*make_render_scene(std::move(world), {light}), camera, settings_of(32, 24));
    // A silhouette of sides takes two: at the centre of the window and within the outline.
    const double most = light.name == "capsule" ? 2.0 : 1.0;
    EXPECT_LE(rays_a_pixel(picture, 1), most) << light.name;
  }
}

TEST(LightCost, AHundredLightsAreTheSumOfTheirPictures) {
  RandomSpace random(9);
  const World world = block_on_floor();
  std::vector<Light> lights;
  for (int i = 0; i < 100; ++i) {
    Light light = i % 2 ? point_light() : rectangle_light();
    light.position = {random.between(-3, 3), random.between(1, 3), random.between(-3, 3)};
    light.half_u *= random.between(0.1, 1.0);
    light.intensity = 0.1f;
    lights.push_back(light);
  }
  RenderSettings settings = settings_of(24, 16);
  settings.asos.eps = 0.0;
  const Camera camera = look_at({1.5, 1.5, 2.0}, {0, 0.2, 0}, 0.9);
  const auto picture_of = [&](const std::vector<Light>& some) {
    return render_picture(*make_render_scene(world, some), camera, settings).film.radiance;
  };
  const auto dark = picture_of({}), together = picture_of(lights);
  std::vector<glm::dvec3> sum(dark.begin(), dark.end());
  for (const Light& light : lights) {
    const auto alone = picture_of({light});
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += glm::dvec3(alone[i] - dark[i]);
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const glm::dvec3 off = glm::abs(sum[i] - glm::dvec3(together[i]));
    ASSERT_TRUE(std::isfinite(off.x + off.y + off.z));
    worst = std::max({worst, off.x, off.y, off.z});
  }
  RecordProperty("worst_error", testing::PrintToString(worst));
  EXPECT_LT(worst, 1e-3);
}

}  // namespace
}  // namespace asos::test::light_cost_test
