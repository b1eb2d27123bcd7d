#include "renderer/comparison/method.h"
#include "renderer/gltf/load.h"
#include "renderer/pyray/error_budget.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/shared_dir.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asos::curved_mirror_test {
namespace {

using test::add_quad;
using test::add_sphere;
using test::look_at;
using test::make_render_scene;
using test::shared_dir;
using test::unlit;

constexpr int width = 40;
constexpr int height = 30;

Material mirror(float roughness) {
  return {
      .base_color = glm::vec4(0.95f, 0.95f, 0.95f, 1.0f), .metallic = 1.0f, .roughness = roughness};
}

Material shown(glm::vec3 colour) {
  Material m = unlit(colour);
  m.double_sided = true;
  return m;
}

/// A reflecting sphere with a floor, a wall and a post.
std::shared_ptr<const RenderScene> ball(const Material& material) {
  World world;
  add_quad(world, {-6, 0, 6}, {12, 0, 0}, {0, 0, -12}, shown({0.3f, 0.35f, 0.3f}));
  add_quad(world, {-2, 0, 3}, {0.5f, 0, 0}, {0, 2, 0}, shown({0.9f, 0.2f, 0.1f}));
  add_quad(world, {1.2f, 0, 2.5f}, {0.05f, 0, 0}, {0, 2.5f, 0}, shown({0.1f, 0.2f, 0.9f}));
  add_sphere(world, {0, 0.9f, 0.8f}, 0.8f, 48, material);
  return make_render_scene(std::move(world));
}

std::vector<glm::vec3> picture(const RenderScene& scene, RenderSettings settings) {
  settings.width = width;
  settings.height = height;
  const Camera camera = look_at({0, 1.5, 4}, {0, 0.8, 0}, 0.6);
  return test::render_picture(scene, camera, settings).film.radiance;
}

double rmse(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::dvec3 d = glm::dvec3(a[i]) - glm::dvec3(b[i]);
    sum += glm::dot(d, d) / 3.0;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

RenderSettings sobol(int spp, int seed = 0) {
  return {.method = Method::sobol, .sampling = {.spp = spp}, .seed = seed};
}

class EveryCurvedMirror : public testing::TestWithParam<CurvedMirror> {};

TEST_P(EveryCurvedMirror, ConvergesToTheReference) {
  const auto scene = ball(mirror(0.0f));
  const auto reference = picture(*scene, sobol(4096));
  RenderSettings settings{.asos = {.eps = 0.0},
                          .mirror = {.curved = GetParam(), .widest_angle_deg = 4.0}};
  // The reference's noise, estimated from the difference to a reference with another seed.
  const double noise = rmse(picture(*scene, sobol(4096, 1)), reference);
  std::vector<double> errors;
  for (const int level : {1, 2, 4}) {
    settings.asos.max_level = level;
    errors.push_back(rmse(picture(*scene, settings), reference));
  }
  // Tangent planes leave gaps between pyrays, which more levels do not close.
  if (GetParam() == CurvedMirror::tangent) {
    settings.mirror.curved = CurvedMirror::approximate;
    EXPECT_LT(rmse(picture(*scene, settings), reference), errors[2]);
  } else {
    EXPECT_LT(errors[1], errors[0]);
    // Leaves with different results are sampled, so MAX 1 may already be best; errors below the
    // visible threshold are not refined.
    EXPECT_LT(errors[2], std::max(0.5 * errors[0], 0.5 * ErrorBudget::invisible))
        << errors[0] << ' ' << errors[1];
    EXPECT_LT(noise, 2e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryCurvedMirror,
                         testing::Values(CurvedMirror::approximate, CurvedMirror::tangent,
                                         CurvedMirror::supersample, CurvedMirror::adaptive));

TEST(CurvedMirror, ConvergesWhenItIsRough) {
  const auto scene = ball(mirror(0.2f));
  const auto reference = picture(*scene, sobol(2048));
  RenderSettings settings{.asos = {.max_level = 1, .eps = 0.0}};
  const double first = rmse(picture(*scene, settings), reference);
  settings.asos.max_level = 4;
  const double last = rmse(picture(*scene, settings), reference);
  const double noise = rmse(picture(*scene, sobol(2048, 1)), reference);
  EXPECT_LT(last, first);
  EXPECT_LT(last, std::max(0.5 * first, noise));
  EXPECT_LT(noise, 1e-3);
}

// A real car model: its windscreen has a frame thinner than a pixel.
TEST(CurvedMirror, MeshIsNotExtrapolatedFromOneTriangle) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << "no models: set ASOS_SHARED to a folder with scenes/";
  const auto loaded = load_scene((*shared / "scenes/ToyCar/ToyCar.gltf").string());
  ASSERT_TRUE(loaded) << loaded.error().message();
  const auto car = prepare(*loaded);
  ASSERT_TRUE(car) << car.error().message();
  const Camera camera = test::first_camera((*car)->world(), 240.0 / 135.0);
  const auto windscreen = [&](RenderSettings settings) {
    settings.width = 240, settings.height = 135;
    settings.crop = {152, 80, 8, 8};
    return test::render_picture(**car, camera, settings).film.radiance;
  };
  // RMSE over the whole picture, which is black around the crop. It was 9.3e-4 when a pyray could
  // diverge by ten degrees.
  EXPECT_LT(rmse(windscreen({}), windscreen(sobol(1024))), 3e-4);
}

// The normals of neighbouring mesh corners lean in alternating directions, four corners per pixel.
// Each triangle suggests a much larger curvature than the mirror has.
TEST(CurvedMirror, SamplesMeshesFinerThanPixels) {
  constexpr int side = 160;
  constexpr float leans = 0.005f;
  std::vector<test::TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (int z = 0; z <= side; ++z) {
    for (int x = 0; x <= side; ++x) {
      const glm::vec2 at = glm::vec2(x, z) / static_cast<float>(side);
      vertices.push_back({{4.0f * at.x - 2.0f, 0.0f, 4.0f * at.y - 2.0f},
                          glm::normalize(glm::vec3(x % 2 == 0 ? leans : -leans, 1.0f, 0.0f)),
                          at});
    }
  }
  for (int z = 0; z < side; ++z) {
    for (int x = 0; x < side; ++x) {
      const auto a = static_cast<std::uint32_t>(z * (side + 1) + x);
      const std::uint32_t c = a + side + 1;
      triangles.emplace_back(a, c, a + 1);
      triangles.emplace_back(a + 1, c, c + 1);
    }
  }
  World world;
  test::add_part(world, vertices, triangles, mirror(0.0f));
  for (int i = 0; i < 8; ++i) {
    const float x = 0.5f * static_cast<float>(i) - 2.0f;
    add_quad(world, {x, 0.3f, -2.5f}, {0.1f, 0, 0}, {0, 2.5f, 0}, shown(glm::vec3(0.9f)));
  }
  const auto scene = make_render_scene(std::move(world));
  const auto reference = picture(*scene, sobol(1024));
  RenderSettings settings;
  EXPECT_LT(rmse(picture(*scene, settings), reference), 2.0 / 256.0) << "two tolerances";
}

// Two mirrors facing each other, up to the maximum depth: radiance neither grows nor vanishes.
TEST(FacingMirrors, AreFollowedToTheLastBounce) {
  World world;
  Material m = mirror(0.0f);
  m.base_color = glm::vec4(1.0f);
  m.double_sided = true;
  add_quad(world, {-3, -3, -1}, {6, 0, 0}, {0, 6, 0}, m);
  add_quad(world, {-3, -3, 1}, {6, 0, 0}, {0, 6, 0}, m);
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = test::make_settings(8, 8);
  settings.mirror.bounces = MirrorSettings::max_bounces;
  const Camera camera = look_at({0, 0, 0.5}, {0.02, 0.01, -1}, 0.3);
  for (const Method method : {Method::asos, Method::stochastic}) {
    settings.method = method;
    settings.sampling.spp = 4;
    for (const glm::vec3& c : test::render_picture(*scene, camera, settings).film.radiance) {
      // Rays end at the sky beside the mirrors, or with its mean after the last bounce.
      EXPECT_GT(c.x, 0.2f);
      EXPECT_LT(c.x, 0.36f);
    }
  }
}

}  // namespace
}  // namespace asos::curved_mirror_test
