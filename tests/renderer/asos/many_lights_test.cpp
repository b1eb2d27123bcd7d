#include "tests/support/make_settings.h"
#include "tests/support/random_space.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

// A hundred lights: their contributions add up, and lights without contribution cost nothing.

namespace asos::test::many_lights_test {
namespace {

constexpr int light_count = 100;

RenderSettings exact_settings() {
  RenderSettings settings = make_settings(18, 12);
  settings.cull = false;
  settings.asos.eps = 0.0;               // so that weak lights are not skipped
  settings.asos.refine_shading = false;  // so that leaves are the same in all pictures
  return settings;
}

World furnished() {
  World world;
  const Material material = matte({0.6f, 0.6f, 0.6f});
  add_quad(world, {-5, 0, 5}, {10, 0, 0}, {0, 0, -10}, material);
  add_sphere(world, {0.5f, 0.4f, 0.3f}, 0.4f, 8, material);
  add_quad(world, {-0.8f, 0, 0.3f}, {0.6f, 0, 0.2f}, {0, 0.9f, 0}, material);
  return world;
}

Picture picture_of(const std::vector<Light>& lights, const RenderSettings& settings) {
  const Camera camera = look_at({1.5, 1.5, 2.0}, {0, 0.2, 0}, 0.9);
  return render_picture(*make_render_scene(furnished(), lights), camera, settings);
}

/// A copy of a sample light, moved and scaled.
Light placed(Light light, RandomSpace& random) {
  const glm::dvec3 step(random.between(-3, 3), random.between(-1, 1), random.between(-3, 3));
  light = scaled(std::move(light), random.between(0.2, 0.8));
  light.position += step;
  for (auto& outline : light.outlines)
    for (glm::dvec3& corner : outline) corner += step;
  // Above the floor, with similar brightness.
  const double rise = random.between(1.2, 2.5) - light.position.y;
  light.position.y += rise;
  for (auto& outline : light.outlines)
    for (glm::dvec3& corner : outline) corner.y += rise;
  light.intensity = 0.1f;
  return light;
}

std::vector<Light> hundred_of(const std::vector<Light>& types, std::uint64_t seed) {
  RandomSpace random(seed);
  std::vector<Light> lights;
  for (std::size_t i = 0; i < light_count; ++i)
    lights.push_back(placed(types[i % types.size()], random));
  return lights;
}

/// The largest difference between a picture and the sum of the single lights' pictures, relative to
/// the brightest pixel.
double off_from_sum(const std::vector<Light>& lights, const RenderSettings& settings) {
  const auto dark = picture_of({}, settings).film.radiance;
  const auto together = picture_of(lights, settings).film.radiance;
  std::vector<glm::dvec3> sum(dark.begin(), dark.end());
  for (const Light& light : lights) {
    const auto alone = picture_of({light}, settings).film.radiance;
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += glm::dvec3(alone[i]) - glm::dvec3(dark[i]);
  }
  double worst = 0.0, brightest = 0.0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(std::isfinite(together[i][c])) << i;
      worst = std::max(worst, std::abs(sum[i][c] - static_cast<double>(together[i][c])));
      brightest = std::max(brightest, sum[i][c]);
    }
  }
  return worst / brightest;
}

std::vector<Light> area_lights() {
  return {rectangle_light(), disk_light(), polygon_light(), ball_light(), linear_light()};
}

// Both the pixel and the sum have the rounding of a hundred floats.
constexpr double rounding = 1e-5;

TEST(ManyLights, WithoutShadowsAddUp) {
  RenderSettings settings = exact_settings();
  settings.shadow.cast = false;
  for (const auto& types : {all_lights(), area_lights()})
    EXPECT_LT(off_from_sum(hundred_of(types, 21), settings), rounding);
}

// The few edges of these shadows cut leaves exactly. Nothing is sampled: samples would depend on a
// light's index.
TEST(ManyLights, WithShadowsAddUp) {
  for (const auto& types : {all_lights(), area_lights()})
    EXPECT_LT(off_from_sum(hundred_of(types, 22), exact_settings()), rounding);
}

// Two useful lights, then 98 that are out of range, below the floor or turned away.
TEST(ManyLights, WithoutContributionCostNothing) {
  RandomSpace random(23);
  std::vector<Light> useful{rectangle_light(), point_light()};
  std::vector<Light> lights = useful;
  while (lights.size() < light_count) {
    Light light = placed(lights.size() % 3 == 0 ? point_light() : rectangle_light(), random);
    switch (lights.size() % 3) {
      case 0:
        light.range = 0.05;
        break;
      case 1:
        light.direction = {0, 1, 0};
        light.half_v = -light.half_v;
        light.position.y = 4.0;
        break;
      default:
        light.position.y = -1.0;
    }
    lights.push_back(light);
  }
  const Picture all = picture_of(lights, exact_settings());
  const Picture few = picture_of(useful, exact_settings());
  EXPECT_EQ(all.film.radiance, few.film.radiance);
  EXPECT_EQ(all.statistics.shadow_rays, few.statistics.shadow_rays);
  for (std::size_t i = 0; i < lights.size(); ++i)
    EXPECT_EQ(all.statistics.of_light(i), few.statistics.of_light(i)) << i;
  EXPECT_GT(few.statistics.shadow_rays, 0u);
}

/// Root mean square difference and mean difference, over pixels and channels.
struct Difference {
  double rms = 0.0;
  double mean = 0.0;
};
Difference difference(const Film& a, const Film& b) {
  Difference found;
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    const glm::dvec3 d = glm::dvec3(a.radiance[i]) - glm::dvec3(b.radiance[i]);
    found.rms += glm::dot(d, d);
    found.mean += d.x + d.y + d.z;
  }
  const double n = 3.0 * static_cast<double>(a.radiance.size());
  return {std::sqrt(found.rms / n), found.mean / n};
}

double brightest_of(const Film& film) {
  double most = 0.0;
  for (const glm::vec3& pixel : film.radiance)
    most = std::max<double>(most, std::max({pixel.x, pixel.y, pixel.z}));
  return most;
}

/// The sum of all lights keeps the picture below white.
std::vector<Light> hundred_dim_lights() {
  std::vector<Light> lights = hundred_of(area_lights(), 24);
  const double brightest = brightest_of(picture_of(lights, exact_settings()).film);
  for (Light& light : lights) light.intensity *= static_cast<float>(0.9 / brightest);
  return lights;
}

// Lights too dim for individual shadow tests are sampled together, to within EPS.
TEST(ManyLights, SampledTogetherAreWithinEps) {
  const std::vector<Light> lights = hundred_dim_lights();
  const Picture exact = picture_of(lights, exact_settings());
  RenderSettings settings = exact_settings();
  settings.asos.eps = 1.0 / 256.0;
  settings.asos.refine_shading = true;
  const Picture sampled = picture_of(lights, settings);
  const Difference off = difference(sampled.film, exact.film);
  EXPECT_LT(off.rms, settings.asos.eps);
  EXPECT_LT(std::abs(off.mean), settings.asos.eps / 16.0);
  EXPECT_NE(sampled.film.radiance, exact.film.radiance);
  EXPECT_LT(sampled.statistics.shadow_pyrays, exact.statistics.shadow_pyrays / 4);
}

// Usually no two rays go to the same light, but a dominant light gets all the rays.
TEST(ManyLights, ADominantLightGetsAllRays) {
  Light panel = rectangle_light();
  panel.position = {0.3, 2.0, 0.2};
  panel.direction = {0, -1, 0};
  panel.half_u = {1.5, 0, 0};
  panel.half_v = {0, 0, 1.5};
  const double brightest = brightest_of(picture_of({panel}, exact_settings()).film);
  panel.intensity *= static_cast<float>(0.04 / brightest);
  std::vector<Light> lights = hundred_dim_lights();
  for (Light& light : lights) light.intensity *= 1e-6f;
  lights.push_back(panel);
  const Picture exact = picture_of(lights, exact_settings());
  RenderSettings settings = exact_settings();
  settings.asos.eps = 1.0 / 256.0;
  settings.asos.refine_shading = true;
  const Picture sampled = picture_of(lights, settings);
  EXPECT_EQ(sampled.statistics.shadow_pyrays, 0u) << "it is too dim for its own shadow test";
  EXPECT_LT(difference(sampled.film, exact.film).rms, 0.25 * settings.asos.eps);
}

// Error, against exact visibility, for lights in a ring that are half below the floor.
double error_of_sunk_lights(const Light& shape) {
  World world;
  add_quad(world, {-5, 0, 5}, {10, 0, 0}, {0, 0, -10}, matte(glm::vec3(0.6f)));
  std::vector<Light> lights;
  for (int i = 0; i < light_count; ++i) {
    Light light = shape;
    const double angle = 6.28318 * i / light_count;
    light.position = {1.5 * std::cos(angle), -0.05, 1.5 * std::sin(angle)};
    light.direction = glm::dvec3(-std::cos(angle), 0, -std::sin(angle));
    light.half_u = glm::dvec3(-0.04 * std::sin(angle), 0, 0.04 * std::cos(angle));
    light.half_v = glm::dvec3(0, 0.4, 0);
    light.intensity = shape.intensity;
    light.color = glm::vec3(1.0f);
    lights.push_back(light);
  }
  const auto scene = make_render_scene(std::move(world), lights);
  const Camera camera = look_at({0, 2.5, 0.1}, {0, 0, 0}, 0.6);
  RenderSettings settings = exact_settings();
  const Picture exact = render_picture(*scene, camera, settings);
  settings.asos.eps = 1.0 / 256.0;
  settings.asos.refine_shading = true;
  const Picture sampled = render_picture(*scene, camera, settings);
  return difference(sampled.film, exact.film).rms;
}

// A light's centre may be below the floor although the light illuminates it.
TEST(ManyLights, PartlyBelowTheFloorAreWithinEps) {
  Light rectangle = rectangle_light();
  rectangle.intensity = 4.0f;
  EXPECT_LT(error_of_sunk_lights(rectangle), 1.0 / 256.0);
  Light disk = disk_light();
  disk.radius = 0.3;
  disk.intensity = 0.5f;
  EXPECT_LT(error_of_sunk_lights(disk), 1.0 / 256.0) << "some of its samples are below the floor";
}

// Selection weights are computed on each surface, even if no pixel's centre shows it: here the
// centres show only black surfaces.
TEST(ManyLights, SampledTogetherAreWithinEpsOnSubpixelSurfaces) {
  constexpr float pixel = 0.1f;
  World world;
  add_quad(world, {-5, 0, 5}, {10, 0, 0}, {0, 0, -10}, matte(glm::vec3(0.0f)));
  add_quad(world, {-5, 0, -0.4f}, {10, 0, 0}, {0, 1.5f, 0}, matte(glm::vec3(0.0f)));
  for (int i = -9; i < 9; ++i) {
    const float x = (static_cast<float>(i) + 0.1f) * pixel;
    add_quad(world, {x, 0.01f, 1}, {0.3f * pixel, 0, 0}, {0, 0, -1.3f}, matte(glm::vec3(0.9f)));
  }
  // Two rows of lights; the wall hides more of one row.
  std::vector<Light> lights;
  for (int i = 0; i < light_count; ++i) {
    Light light = rectangle_light();
    light.position = {-1.0 + 0.02 * i, 1.7, i % 2 == 0 ? -1.6 : 1.2};
    light.direction = {0, -1, 0};
    light.half_u = {0.05, 0, 0};
    light.half_v = {0, 0, 0.05};
    light.color = glm::vec3(1.0f);
    light.intensity = 1.0f;
    lights.push_back(light);
  }
  Camera camera = look_at({0, 4, 0.3}, {0, 0, 0.3}, 0.0);
  camera.fov_y_rad = 2.0 * std::atan(0.5 * 12 * double{pixel} / 4.0);
  camera.world_from_camera = glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0),
                                        glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 4, 0.3, 1));
  RenderSettings settings = exact_settings();
  const auto brightness = [&] {
    return brightest_of(render_picture(*make_render_scene(world, lights), camera, settings).film);
  };
  const auto dim = static_cast<float>(0.6 / brightness());
  for (Light& light : lights) light.intensity *= dim;
  const auto scene = make_render_scene(world, lights);
  const Picture exact = render_picture(*scene, camera, settings);
  settings.asos.eps = 1.0 / 256.0;
  settings.asos.refine_shading = true;
  const Picture sampled = render_picture(*scene, camera, settings);
  const Difference off = difference(sampled.film, exact.film);
  EXPECT_LT(off.rms, settings.asos.eps);
}

TEST(ManyLights, SampledTogetherAreWithinEpsInMirrors) {
  World world = furnished();
  Material mirror = matte(glm::vec3(0.9f));
  mirror.metallic = 1.0f;
  mirror.roughness = 0.0f;
  add_quad(world, {-2, 0, -1.5f}, {4, 0, 0}, {0, 2.5f, 0}, mirror);
  const auto scene = make_render_scene(world, hundred_dim_lights());
  // The view shows the floor, but no lights.
  const Camera camera = look_at({0.4, 1.4, 0.8}, {0, 0.3, -1.5}, 0.25);
  RenderSettings settings = exact_settings();
  const Picture exact = render_picture(*scene, camera, settings);
  settings.asos.eps = 1.0 / 256.0;
  settings.asos.refine_shading = true;
  const Picture sampled = render_picture(*scene, camera, settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 1024;
  const Picture truth = render_picture(*scene, camera, settings);
  ASSERT_GT(exact.statistics.reflection_rays, 100u);
  const Difference off = difference(sampled.film, truth.film);
  EXPECT_LT(off.rms, settings.asos.eps);
  EXPECT_LT(std::abs(off.mean), 3.0 * settings.asos.eps / std::sqrt(double{18 * 12}));
  EXPECT_LT(sampled.statistics.shadow_pyrays, exact.statistics.shadow_pyrays / 4);
}

// A sample sends few rays to many lights, with the correct expectation.
TEST(ManyLights, AreSampledWithFewRays) {
  const std::vector<Light> lights = hundred_dim_lights();
  const Picture exact = picture_of(lights, exact_settings());
  RenderSettings settings = exact_settings();
  settings.method = Method::sobol;
  settings.sampling.spp = 256;
  const Picture sampled = picture_of(lights, settings);
  const Difference off = difference(sampled.film, exact.film);
  EXPECT_LT(off.rms, 1.0 / 128.0);
  EXPECT_LT(std::abs(off.mean), 1.0 / 2048.0);
  EXPECT_LE(static_cast<double>(sampled.statistics.shadow_rays),
            9.0 * static_cast<double>(sampled.statistics.eye_rays));
}

}  // namespace
}  // namespace asos::test::many_lights_test
