#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/picture_difference.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

// Partially occluded lights whose occlusion is not visible as an edge between the patch and the
// light.

namespace asos::test::partly_seen_light_test {
namespace {

constexpr int side = 48;

RenderSettings settings_of(int max_level) {
  RenderSettings settings = make_settings(side, side);
  settings.asos.max_level = max_level;
  return settings;
}

Picture picture_of(const RenderScene& scene, const Camera& camera, int max_level) {
  return render_picture(scene, camera, settings_of(max_level));
}

Picture sampled(const RenderScene& scene, const Camera& camera, int samples) {
  RenderSettings settings = settings_of(3);
  settings.method = Method::sobol;
  settings.sampling.spp = samples;
  return render_picture(scene, camera, settings);
}

Light panel(glm::dvec3 middle, double half_u, double half_v, float intensity = 4.0f) {
  return make_panel(middle, {0, -1, 0}, {half_u, 0, 0}, {0, 0, half_v}, intensity);
}

void add_floor(World& world, const Material& material) {
  add_quad(world, glm::vec3(-40, 0, 40), glm::vec3(80, 0, 0), glm::vec3(0, 0, -80), material);
}

// The camera looks through the back of a single-sided wall that stands in a floor. Within one block
// of pixels the wall occludes the light on one side of its foot, without an edge nearby.
TEST(PartlySeenLight, EndsAtTheFootOfASingleSidedWall) {
  for (const float slope : {0.0f, 0.3f}) {
    World world;
    add_floor(world, matte(glm::vec3(0.8f)));
    add_quad(world, glm::vec3(slope * 200.0f, -50.0f, 200.0f), glm::vec3(0, 500, 0),
             glm::vec3(-400.0f * slope, 0, -400.0f), matte(glm::vec3(0.5f)));
    const auto scene = make_render_scene(std::move(world), {panel({-6, 6, 0}, 0.5, 0.5, 200.0f)});
    const Camera camera = look_at({4, 6, 1}, {0, 0, 0}, 0.4);
    const Picture truth = sampled(*scene, camera, 256);
    for (const int max_level : {1, 3}) {
      const Difference off = difference(picture_of(*scene, camera, max_level), truth);
      EXPECT_GT(off.mean, 0.05);
      EXPECT_LT(off.largest, 0.02) << slope << ' ' << max_level;
    }
  }
}

// An object inside a sphere light occludes none of it, although pyrays towards the light's rim may
// meet the object.
TEST(PartlySeenLight, IsUnoccludedByObjectsInsideASphereLight) {
  const Light ball = make_bulb({0, 3, 0}, 20.0f, 1.0);
  const Camera camera = look_at({0, 4, 9}, {0, 0, 0}, 0.4);
  const auto with = [&](bool plate) {
    World world;
    add_floor(world, matte(glm::vec3(0.8f)));
    // At this height the sphere's section has a half-width of 0.8.
    if (plate)
      add_quad(world, glm::vec3(-0.5f, 2.4f, 0.5f), glm::vec3(1, 0, 0), glm::vec3(0, 0, -1),
               matte(glm::vec3(0.5f)));
    const auto scene = make_render_scene(std::move(world), {ball});
    return picture_of(*scene, camera, 3);
  };
  const Difference off = difference(with(true), with(false));
  EXPECT_GT(off.mean, 0.1);
  EXPECT_LT(off.largest, 1e-3 * off.mean);
}

// Inside a sphere light, light comes from everywhere, and a wall occludes some of it.
TEST(PartlySeenLight, IsOccludedByAWallInsideASphereLight) {
  Light ball{.type = Light::Type::point, .intensity = 20.0f, .radius = 3.0};
  World world;
  add_quad(world, glm::vec3(-1, 0, 1), glm::vec3(2, 0, 0), glm::vec3(0, 0, -2),
           matte(glm::vec3(0.8f)));
  add_quad(world, glm::vec3(1.2f, 0, 2), glm::vec3(0, 2, 0), glm::vec3(0, 0, -4),
           matte(glm::vec3(0.0f)));
  const auto scene = make_render_scene(std::move(world), {ball});
  const Camera camera = look_at({0.0, 2.0, 0.01}, {0, 0, 0}, 0.5);
  const Difference off = difference(picture_of(*scene, camera, 4), sampled(*scene, camera, 1024));
  EXPECT_GT(off.mean, 0.1);
  EXPECT_LT(std::abs(off.bias), 1e-3);
  EXPECT_LT(off.largest, 0.02);
}

// Rough metal reflects one end of a large light more strongly than the other. A panel with one half
// covered must look like the other half alone.
TEST(PartlySeenLight, OnRoughMetalMatchesTheVisibleHalf) {
  Material metal = matte(glm::vec3(0.9f));
  metal.metallic = 1.0f;
  const Camera camera = look_at({-6, 1.5, 0}, {0, 0, 0}, 0.5);
  const auto picture = [&](bool covered, int max_level) {
    World world;
    add_floor(world, metal);
    if (covered)
      add_quad(world, glm::vec3(-8.0f, 2.9995f, 8.0f), glm::vec3(8, 0, 0), glm::vec3(0, 0, -16),
               matte(glm::vec3(0.0f)));
    const Light light = covered ? panel({0, 3, 0}, 3, 3) : panel({1.5, 3, 0}, 1.5, 3);
    const auto scene = make_render_scene(std::move(world), {light});
    return picture_of(*scene, camera, max_level);
  };
  for (const int max_level : {3, 4}) {
    const Difference off = difference(picture(true, max_level), picture(false, max_level));
    EXPECT_GT(off.mean, 0.1);
    EXPECT_LT(std::abs(off.bias), 0.004 * off.mean) << max_level;
    EXPECT_LT(off.largest, 0.02) << max_level;
  }
}

}  // namespace
}  // namespace asos::test::partly_seen_light_test
