#include "tests/support/true_light.h"

#include <gtest/gtest.h>

// Pictures of surfaces with clear coat and sheen against the rendering equation, pixel by pixel, by
// ASOS and by samples.

namespace asos::test::layered_light_test {
namespace {

using namespace true_light;

Reflector coated(double metallic, double coat_roughness) {
  return {{0.9, 0.6, 0.3}, metallic, 0.7, 1.0, coat_roughness};
}
Reflector sheeny(double roughness) {
  return {{0.4, 0.1, 0.05}, 0.0, 0.8, 0.0, 0.0, {0.9, 0.3, 0.6}, roughness};
}

/// Limits of the RMSE, in display intensity, for ASOS and for Sobol sampling.
void expect_true(Subject subject, const Reflector& reflector, double asos, double sobol) {
  for (const char* kind : {"rectangle", "ball", "line", "capsule", "sun"}) {
    const Light light = light_of(kind);
    const auto exact = truth(subject, reflector, prepare_light(light), 2);
    const auto scene = make_render_scene(world_of(subject, reflector), {light});
    for (const Method method : {Method::asos, Method::sobol}) {
      RenderSettings settings = true_light::settings_for(method);
      settings.asos.max_level = 4;
      settings.sampling.spp = 64;
      const Picture picture = render_picture(*scene, camera_for(subject), settings);
      const Errors e = errors_of(picture.film, exact);
      EXPECT_GT(e.mean, 1e-3);
      EXPECT_LT(e.rmse * e.mean, method == Method::asos ? asos : sobol)
          << kind << (method == Method::asos ? " asos" : " sobol") << ", bias " << e.bias
          << ", mean " << e.mean;
    }
  }
}

TEST(LayeredLight, OnACoatedSphere) {
  expect_true(Subject::sphere, coated(0.0, 0.3), 2e-3, 0.01);
}

TEST(LayeredLight, OnACoatedMetalPlane) {
  expect_true(Subject::plane, coated(1.0, 0.45), 2e-3, 0.01);
}

TEST(LayeredLight, OnASheenySphere) {
  expect_true(Subject::sphere, sheeny(0.5), 2e-3, 0.01);
}

TEST(LayeredLight, OnASheenyPlane) {
  expect_true(Subject::plane, sheeny(0.3), 2e-3, 0.01);
}

Reflector brushed(double metallic, double strength, double turn) {
  Reflector reflector{{0.9, 0.6, 0.3}, metallic, 0.4};
  reflector.anisotropy = strength;
  reflector.tangent = {std::cos(turn), 0.0, std::sin(turn)};
  return reflector;
}

TEST(LayeredLight, OnABrushedMetalPlane) {
  expect_true(Subject::plane, brushed(1.0, 0.7, 0.4), 2e-3, 0.02);
}

TEST(LayeredLight, OnABrushedDielectricPlane) {
  expect_true(Subject::plane, brushed(0.0, 0.5, 1.5), 2e-3, 0.02);
}

// A smooth coat over a matte floor reflects an emissive wall: factor * F(n.v) times its radiance.
// The floor itself is dark.
TEST(LayeredLight, SmoothCoatsMirror) {
  Material floor = matte(glm::vec3(0.0f));
  floor.ior = 1.0f;
  floor.specular = 0.0f;
  floor.coat.factor = 0.75f;
  Material wall = unlit(glm::vec3(1.0f));
  wall.base_color = {0.5f, 1.0f, 0.25f, 1.0f};
  World world;
  add_quad(world, {-20, 0, 0}, {0, 0, 20}, {40, 0, 0}, floor);
  add_quad(world, {-20, 0, 0}, {40, 0, 0}, {0, 40, 0}, wall);
  const auto scene = make_render_scene(std::move(world));
  const Camera camera = look_at({0, 1.5, 6}, {0, 0.2, 2.5}, 0.3);
  const View view(camera, width, height);
  for (const Method method : {Method::asos, Method::sobol}) {
    const Picture picture = render_picture(*scene, camera, true_light::settings_for(method));
    int seen = 0;
    for (int y = 4; y < height; y += 8) {
      for (int x = 4; x < width; x += 8) {
        const glm::dvec3 down = glm::normalize(glm::dvec3(view.ray(x + 0.5, y + 0.5).direction));
        const auto met = meet(Subject::plane, glm::dvec3(view.ray(x + 0.5, y + 0.5).origin), down);
        if (!met || met->point.position.z < 0.1 || met->point.position.z > 19.0) continue;
        const double fresnel = 0.04 + 0.96 * std::pow(1.0 + down.y, 5.0);
        const glm::vec3 found = picture.film.radiance[static_cast<std::size_t>(y * width + x)];
        EXPECT_NEAR(found.y, 0.75 * fresnel, 2e-3) << x << ' ' << y;
        EXPECT_NEAR(found.x, 0.5f * found.y, 1e-5f);
        ++seen;
      }
    }
    EXPECT_GT(seen, 30);
  }
}

}  // namespace
}  // namespace asos::test::layered_light_test
