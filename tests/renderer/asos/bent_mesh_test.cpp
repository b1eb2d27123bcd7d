#include "renderer/asos/pixel_trace.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

// The light on a ball of triangles with smooth normals.

namespace asos::test::bent_mesh_test {
namespace {

constexpr int side = 40;
constexpr std::uint32_t rings = 32;

Mesh ball() {
  Mesh mesh;
  constexpr std::uint32_t around = 2 * rings;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const float down = std::numbers::pi_v<float> * static_cast<float>(i) / rings;
    for (std::uint32_t k = 0; k <= around; ++k) {
      const float turn = std::numbers::pi_v<float> * static_cast<float>(k) / rings;
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
  scene.meshes.push_back(ball());
  Material material;
  material.base_color = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f);
  material.metallic = metallic;
  material.roughness = 1.0f;
  scene.materials.push_back(material);
  Instance instance;
  instance.mesh = 0;
  scene.instances.push_back(instance);
  scene.lights.push_back(panel_above());
  return prepare(scene).value();
}

Camera before(const RenderScene& scene) {
  const glm::dvec3 origin = scene.world().origin;
  return look_at(glm::dvec3(0.0, 0.5, 4.0) - origin, -origin, 0.6);
}

RenderSettings settings_of(Method method) {
  RenderSettings settings;
  settings.width = settings.height = side;
  settings.method = method;
  settings.sampling.spp = 4096;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return settings;
}

double mean_of(const RenderScene& scene, Method method) {
  const Film film = render_picture(scene, before(scene), settings_of(method)).film;
  double sum = 0.0;
  for (const glm::vec3& radiance : film.radiance) sum += static_cast<double>(radiance.x);
  return sum / static_cast<double>(film.radiance.size());
}

// Near their horizon triangles turn away from the light that their normals see.
TEST(BentMesh, HasTheLightThatSamplesFind) {
  for (const float metallic : {0.0f, 1.0f}) {
    const auto scene = lit_ball(metallic);
    const double expected = mean_of(*scene, Method::sobol);
    ASSERT_GT(expected, 0.01);
    EXPECT_NEAR(mean_of(*scene, Method::asos), expected, 3e-4 * expected) << metallic;
  }
}

TEST(BentMesh, TheTraceOfAPixelSaysThatItIsSampled) {
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
