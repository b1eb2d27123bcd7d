#include "renderer/asos/pixel_trace.h"
#include "tests/support/flat_mesh.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>

// Light on a sphere made of triangles with smooth normals.

namespace asos::test::bent_mesh_test {
namespace {

constexpr int side = 40;

Mesh ball(std::uint32_t rings) {
  Mesh mesh;
  const std::uint32_t around = 2 * rings;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const float down =
        std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(rings);
    for (std::uint32_t k = 0; k <= around; ++k) {
      const float turn =
          std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(rings);
      mesh.positions.emplace_back(std::sin(down) * std::cos(turn), std::cos(down),
                                  std::sin(down) * std::sin(turn));
    }
  }
  mesh.normals = mesh.positions;
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = i * (around + 1) + k, b = a + around + 1;
      if (i > 0) mesh.triangles.emplace_back(a, a + 1, b);
      if (i + 1 < rings) mesh.triangles.emplace_back(a + 1, b + 1, b);
    }
  }
  mesh.material = 0;
  return mesh;
}

Light panel_above() {
  Light light = rectangle_light();
  light.position = {0.0, 2.5, 0.0};
  light.direction = {0.0, -1.0, 0.0};
  light.half_u = {0.6, 0.0, 0.0};
  light.half_v = {0.0, 0.0, 0.3};
  light.intensity = 200.0f;
  light.color = glm::vec3(1.0f);
  return light;
}

std::shared_ptr<const RenderScene> lit_ball(float metallic) {
  Scene scene;
  scene.meshes.push_back(ball(32));
  Material material{
      .base_color = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f), .metallic = metallic, .roughness = 1.0f};
  scene.materials.push_back(material);
  Instance instance{.mesh = 0};
  scene.instances.push_back(instance);
  scene.lights.push_back(panel_above());
  return prepare(scene).value();
}

Camera before(const RenderScene& scene) {
  const glm::dvec3 origin = scene.world().origin;
  return look_at(glm::dvec3(0.0, 0.5, 4.0) - origin, -origin, 0.6);
}

RenderSettings settings_of(Method method) {
  RenderSettings settings = make_settings(side, side, method, 4096);
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return settings;
}

double mean_of(const RenderScene& scene, Method method) {
  const Film film = render_picture(scene, before(scene), settings_of(method)).film;
  double sum = 0.0;
  for (const glm::vec3& radiance : film.radiance) sum += static_cast<double>(radiance.x);
  return sum / static_cast<double>(film.radiance.size());
}

// A sphere whose triangles are smaller than pixels, with texture coordinates that differ between
// corners.
std::shared_ptr<const RenderScene> patched_ball(bool behind_glass) {
  Scene scene;
  Mesh patched = ball(128);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(0.0f, 1.0f);
  for (std::size_t i = 0; i < patched.positions.size(); ++i)
    patched.texcoords[0].emplace_back(place(random), place(random));
  scene.images.push_back(make_image(16, 16, [](int x, int y) {
    const auto c = static_cast<std::uint8_t>((x + y) % 2 == 0 ? 255 : 0);
    return Texel{c, c, c, 255};
  }));
  scene.textures.push_back({});
  scene.textures.front().image = 0;
  Material material{.base_color_texture = {.texture = 0}, .metallic = 0.0f};
  test::place(scene, patched, material);
  if (behind_glass) {
    Material clear{.base_color = glm::vec4(1.0f, 1.0f, 1.0f, 1.0f / 1024.0f),
                   .alpha_mode = AlphaMode::blend,
                   .double_sided = true};
    test::place(scene, slanted_strip(-9.0, 9.0, 0.0, 9.0, 1.5), clear);
  }
  scene.lights.push_back(panel_above());
  return prepare(scene).value();
}

// Surfaces behind clear glass are refined like unobstructed ones.
TEST(BentMesh, LooksTheSameThroughClearGlass) {
  const auto bare = patched_ball(false), behind = patched_ball(true);
  const RenderSettings settings = settings_of(Method::asos);
  const Film expected = render_picture(*bare, before(*bare), settings).film;
  const Film found = render_picture(*behind, before(*behind), settings).film;
  double worst = 0.0, brightest = 0.0;
  for (std::size_t i = 0; i < found.radiance.size(); ++i) {
    worst = std::max(worst,
                     static_cast<double>(std::abs(found.radiance[i].x - expected.radiance[i].x)));
    brightest = std::max(brightest, static_cast<double>(expected.radiance[i].x));
  }
  EXPECT_GT(brightest, 0.1);
  EXPECT_LT(worst, 0.01 * brightest);
}

// Near the silhouette, triangles face away from the light although their normals face it.
TEST(BentMesh, MatchesSampledLight) {
  for (const float metallic : {0.0f, 1.0f}) {
    const auto scene = lit_ball(metallic);
    const double expected = mean_of(*scene, Method::sobol);
    ASSERT_GT(expected, 0.01);
    EXPECT_NEAR(mean_of(*scene, Method::asos), expected, 3e-4 * expected) << metallic;
  }
}

TEST(BentMesh, TraceReportsSampling) {
  const auto scene = lit_ball(0.0f);
  const RenderSettings settings = settings_of(Method::asos);
  const View view(before(*scene), side, side);
  const PixelTrace trace = trace_pixel(*scene, view, settings, side / 2, side / 2);
  ASSERT_EQ(trace.cells.size(), 1u);
  EXPECT_EQ(trace.cells.front().fate, CellFate::sampled);
  EXPECT_FALSE(trace.missed);
  EXPECT_EQ(trace.unresolved_area, 0.0);
}

}  // namespace
}  // namespace asos::test::bent_mesh_test
