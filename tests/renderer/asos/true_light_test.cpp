#include "tests/support/true_light.h"

#include "renderer/prepared/own_lights.h"
#include "tests/support/random_space.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Pictures of direct light against the rendering equation, pixel by pixel.

namespace asos::test::true_light_test {
namespace {

using namespace true_light;

constexpr std::array roughnesses{0.1, 0.2, 0.3, 0.45, 0.6, 1.0};
/// Largest allowed error of ASOS per roughness: RMSE over the mean, in display intensity.
using Bounds = std::array<double, roughnesses.size()>;

// Points along each side of a pixel for the reference: a narrow highlight on a sphere is small
// within its pixel.
int points_along(Subject subject, double roughness) {
  if (roughness > 0.25) return 4;
  if (subject != Subject::sphere) return 6;
  return roughness > 0.15 ? 12 : 16;
}

// Highlights of all area lights, at MAX 3 and the default EPS, with reflections: mirrors show
// lights through their lobe.
void expect_true(Subject subject, double metallic, const Bounds& bounds) {
  for (std::size_t i = 0; i < roughnesses.size(); ++i) {
    double worst = 0.0, worst_bias = 0.0;
    for (const char* kind : kinds) {
      const Light light = light_of(kind);
      const Reflector reflector{{0.9, 0.6, 0.3}, metallic, roughnesses[i]};
      const auto exact =
          truth(subject, reflector, prepare_light(light), points_along(subject, roughnesses[i]));
      const auto scene = make_render_scene(world_of(subject, reflector), {light});
      RenderSettings settings = settings_for(Method::asos);
      const Picture picture = render_picture(*scene, camera_for(subject), settings);
      const Errors e = errors_of(picture.film, exact);
      EXPECT_GT(e.mean, 1e-4);
      EXPECT_LT(e.rmse, bounds[i])
          << kind << ' ' << roughnesses[i] << ", bias " << e.bias << ", mean " << e.mean;
      worst = std::max(worst, e.rmse);
      worst_bias = std::max(worst_bias, std::abs(e.bias));
    }
    testing::Test::RecordProperty(
        "roughness_" + std::to_string(i),
        testing::PrintToString(worst) + " bias " + testing::PrintToString(worst_bias));
  }
}

TEST(TrueLight, OnAMetalSphere) {
  expect_true(Subject::sphere, 1.0, {0.0005, 0.0005, 0.0016, 0.0011, 0.0018, 0.0019});
}

TEST(TrueLight, OnASphere) {
  expect_true(Subject::sphere, 0.0, {0.0005, 0.0008, 0.0016, 0.0010, 0.0012, 0.0016});
}

TEST(TrueLight, OnAMetalPlane) {
  expect_true(Subject::plane, 1.0, {0.0017, 0.0011, 0.0004, 0.0002, 0.00015, 0.0002});
}

TEST(TrueLight, OnAPlane) {
  expect_true(Subject::plane, 0.0, {0.0003, 0.0003, 0.0003, 0.0003, 0.0003, 0.0003});
}

TEST(TrueLight, OnAMetalBox) {
  expect_true(Subject::box, 1.0, {0.0019, 0.0017, 0.0012, 0.0005, 0.0004, 0.0015});
}

TEST(TrueLight, OnABox) {
  expect_true(Subject::box, 0.0, {0.0006, 0.0006, 0.0005, 0.0005, 0.0005, 0.0004});
}

// A glossy floor under an emissive panel made of triangles. The floor's lobe shows the panel and
// its reflection leaves it out, so the light counts once. Textured emission is left to the
// reflection.
TEST(TrueLight, CountsAnEmissivePanelOnce) {
  const Reflector reflector{{0.9, 0.6, 0.3}, 1.0, 0.3};
  const Light panel = light_of("rectangle");
  const auto exact = truth(Subject::plane, reflector, prepare_light(panel), 2);
  World world = world_of(Subject::plane, reflector);
  Material shining = matte(glm::vec3(0.0f));
  shining.emissive = glm::vec3(1.0f);
  shining.emissive_strength = panel.intensity;
  const glm::vec3 u(panel.half_u), v(panel.half_v);
  // The panel faces the direction of u x v.
  ASSERT_GT(glm::dot(glm::cross(u, v), glm::vec3(panel.direction)), 0.0f);
  add_quad(world, glm::vec3(panel.position) - u - v, 2.0f * u, 2.0f * v, shining);
  std::vector<Light> lights = lights_of_meshes(world);
  ASSERT_EQ(lights.size(), 1u);
  const auto scene = make_render_scene(std::move(world), std::move(lights));
  for (const Method method : {Method::asos, Method::sobol}) {
    RenderSettings settings = settings_for(method);
    settings.sampling.spp = 256;
    const Picture picture = render_picture(*scene, camera_for(Subject::plane), settings);
    const Errors e = errors_of(picture.film, exact);
    EXPECT_LT(e.rmse, method == Method::asos ? 0.003 : 0.05) << "bias " << e.bias;
  }
}

// A flat emissive surface does not light itself: it has its own radiance, for any orientation and
// rounding.
TEST(TrueLight, EmittersDoNotLightThemselves) {
  RandomSpace space(11);
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 normal(space.direction());
    const glm::vec3 u(space.perpendicular(glm::dvec3(normal)));
    const glm::vec3 v = glm::cross(normal, u);
    const glm::vec3 middle = 3.0f * glm::vec3(space.direction());
    World world;
    Material shining = matte(glm::vec3(0.9f));
    shining.emissive = glm::vec3(0.25f);
    shining.double_sided = true;
    // Two triangles form a rectangle, four a polygon.
    std::vector<TinyVertex> corners;
    const int count = i % 2 == 0 ? 4 : 6;
    for (int k = 0; k < count; ++k) {
      const auto angle = static_cast<float>(2.0 * std::numbers::pi * k / count);
      corners.push_back({middle + 2.0f * (std::cos(angle) * u + std::sin(angle) * v), normal, {}});
    }
    std::vector<glm::uvec3> triangles;
    for (int k = 2; k < count; ++k)
      triangles.emplace_back(0, static_cast<std::uint32_t>(k - 1), static_cast<std::uint32_t>(k));
    add_part(world, corners, triangles, shining);
    std::vector<Light> lights = lights_of_meshes(world);
    ASSERT_EQ(lights.size(), 1u);
    const auto scene = make_render_scene(std::move(world), std::move(lights));
    const Camera camera =
        look_at(glm::dvec3(middle + 4.0f * normal + 0.5f * u), glm::dvec3(middle), 0.3);
    for (const Method method : {Method::asos, Method::sobol}) {
      RenderSettings settings = settings_for(method);
      settings.sampling.spp = 16;
      const Film film = render_picture(*scene, camera, settings).film;
      for (const glm::vec3& radiance : film.radiance) ASSERT_NEAR(radiance.x, 0.25, 1e-5) << i;
    }
  }
}

// Where a light is partly below the horizon, its part above the horizon is visible. Testing the
// other part finds no occluder.
TEST(TrueLight, StaysWhereALightSets) {
  World world;
  add_sphere(world, glm::vec3(0.0f), 0.45f, 64, matte(glm::vec3(0.9f)));
  Light light = placed(rectangle_light());
  light.position = {0.0, 0.55, 0.2};
  light.direction = {0, -1, 0};
  light.half_u = {0.3, 0, 0};
  light.half_v = {0, 0, -0.6};
  const auto scene = make_render_scene(std::move(world), {light});
  const Camera camera = look_at({0.0, 0.4, 2.4}, {0, 0, 0}, 0.6);
  const Film found = render_picture(*scene, camera, settings_for(Method::asos)).film;
  RenderSettings sampled = settings_for(Method::sobol);
  sampled.sampling.spp = 64;
  const Film expected = render_picture(*scene, camera, sampled).film;
  int lit = 0, dark = 0;
  for (std::size_t i = 0; i < found.radiance.size(); ++i) {
    if (!(expected.radiance[i].x > 1.0f / 256.0f)) continue;
    ++lit;
    dark += found.radiance[i].x == 0.0f;
  }
  EXPECT_GT(lit, 500);
  EXPECT_EQ(dark, 0);
}

// A finer quadrature gives the same result.
TEST(TrueLight, QuadratureHasConverged) {
  const SeenPoint at{{0.1, 0.0, 0.2}, {0, 1, 0}, glm::normalize(glm::dvec3(0.3, 0.5, 1.0))};
  for (const char* kind : kinds) {
    const PreparedLight light = prepare_light(light_of(kind));
    for (const double roughness : {0.1, 0.3, 1.0}) {
      for (const double metallic : {0.0, 1.0}) {
        const Reflector reflector{{0.9, 0.6, 0.3}, metallic, roughness};
        const double coarse = reflected_radiance(light, reflector, at).x;
        const double fine = reflected_radiance(light, reflector, at, 3.0).x;
        EXPECT_NEAR(coarse, fine, 1e-5 * fine) << kind << ' ' << roughness;
        EXPECT_GT(fine, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace asos::test::true_light_test
