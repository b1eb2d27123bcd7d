#include "renderer/shading/sky.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/shape_world.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <vector>

// Where a smooth mesh turns away from a light, it is shaded like the smooth surface that it
// approximates: its triangles neither shadow each other nor end the light at their planes.

namespace asos::test::shadow_terminator_test {
namespace {

constexpr int side = 48;

struct Lamp {
  const char* name;
  Light light;

  friend std::ostream& operator<<(std::ostream& out, const Lamp& lamp) { return out << lamp.name; }
};

/// Lights from the upper right that make a white surface almost white.
std::vector<Lamp> lamps() {
  const glm::dvec3 from = glm::normalize(glm::dvec3(1.0, 0.7, 0.3));
  const Light sun = make_sun(-from, 3.0f);
  Light wide_sun = sun;
  wide_sun.angular_diameter_rad = 0.1;
  const Light point = make_bulb(6.0 * from, 75.0f);
  Light ball = point;
  ball.radius = 0.5;
  Light rectangle;
  rectangle.type = Light::Type::rectangle;
  rectangle.position = 6.0 * from;
  rectangle.direction = -from;
  rectangle.half_u = 0.5 * glm::normalize(glm::cross(from, glm::dvec3(0, 1, 0)));
  rectangle.half_v = 0.5 * glm::normalize(glm::cross(rectangle.half_u, from));
  rectangle.intensity = 75.0f;
  Light line;
  line.type = Light::Type::linear;
  line.position = 6.0 * from;
  line.half_u = {0, 0, 0.5};
  line.intensity = 75.0f;
  return {{"distant", sun}, {"sun", wide_sun},        {"point", point},
          {"ball", ball},   {"rectangle", rectangle}, {"line", line}};
}

/// A sphere, as triangles or as an analytic shape.
std::shared_ptr<const RenderScene> sphere_under(const Light& light, bool true_one) {
  World world;
  if (true_one) {
    add_shape(world, sphere(1.0), glm::dmat4(1.0), matte(glm::vec3(1.0f)));
  } else {
    add_sphere(world, {0, 0, 0}, 1.0f, 12, matte(glm::vec3(1.0f)));
  }
  return make_render_scene(std::move(world), {light});
}

RenderSettings settings_of(Method method) {
  RenderSettings settings = make_settings(side, side, method, 256);
  settings.asos.eps = 1.0 / 1024.0;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return settings;
}

/// Whether a pixel and its neighbours are fully covered by the mesh.
bool inside(const RenderScene& scene, const View& view, int x, int y) {
  for (int j = -1; j <= 2; ++j)
    for (int i = -1; i <= 2; ++i)
      if (!scene.rays().closest(view.ray(x + i, y + j)).valid()) return false;
  return true;
}

/// The largest difference between the pictures of the mesh and of the true sphere by the same
/// method.
double worst(const Light& light, Method method) {
  const Camera camera = look_at({0.5, 1.0, 4.0}, {0, 0, 0}, 0.55);
  const auto mesh = sphere_under(light, false);
  const Film found = render_picture(*mesh, camera, settings_of(method)).film;
  const Film truth = render_picture(*sphere_under(light, true), camera, settings_of(method)).film;
  const View view(camera, side, side);
  double most = 0.0;
  int pixels = 0;
  for (int y = 1; y < side - 1; ++y) {
    for (int x = 1; x < side - 1; ++x) {
      if (!inside(*mesh, view, x, y)) continue;
      ++pixels;
      const std::size_t i = found.index(x, y);
      most =
          std::max(most, static_cast<double>(std::abs(found.radiance[i].x - truth.radiance[i].x)));
    }
  }
  EXPECT_GT(pixels, side * side / 3);
  return most;
}

class EveryLight : public testing::TestWithParam<Lamp> {};

TEST_P(EveryLight, MeshIsLitAsTheTrueSphere) {
  for (const Method method : {Method::asos, Method::sobol, Method::uniform, Method::asos_published})
    EXPECT_LT(worst(GetParam().light, method), 0.02) << GetParam().name << static_cast<int>(method);
}

INSTANTIATE_TEST_SUITE_P(ShadowTerminator, EveryLight, testing::ValuesIn(lamps()));

/// Seen from inside, a sphere is hollow, and its triangles do shadow each other.
TEST(ShadowTerminator, AHollowMeshShadowsItself) {
  World world;
  add_sphere(world, {0, 0, 0}, 1.0f, 8, matte(glm::vec3(1.0f)));
  const RenderFeatures render_features = find_render_features(world);
  const RayScene rays = RayScene::build(world, alpha_at).value();
  int seen = 0;
  for (int i = 0; i < 200; ++i) {
    Ray ray;
    const double a = i;
    ray.direction = glm::vec3(
        glm::normalize(glm::dvec3(std::sin(a), std::cos(1.7 * a), std::sin(2.3 * a + 1.0))));
    const Hit hit = rays.closest(ray);
    if (!hit.valid()) continue;
    ++seen;
    const SurfacePoint inner = surface_point(world, render_features, hit, -ray.direction);
    EXPECT_EQ(inner.lift, glm::vec3(0.0f));
    EXPECT_EQ(inner.horizon(), inner.geometric_normal);
    const SurfacePoint outer = surface_point(world, render_features, hit, ray.direction);
    if (outer.lift != glm::vec3(0.0f)) {
      EXPECT_NEAR(glm::length(outer.lit_position()), 1.0f, 0.035f);
    }
  }
  EXPECT_GT(seen, 150);
}

/// A box with normals averaged over its edges must not look like a sphere.
TEST(ShadowTerminator, ABoxWithAveragedNormalsStaysABox) {
  World world;
  std::vector<TinyVertex> vertices;
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 p(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    vertices.push_back({p, glm::normalize(p), {0, 0}});
  }
  add_part(world, vertices, {{4, 5, 7}, {4, 7, 6}}, matte(glm::vec3(1.0f)));
  const Hit hit{0, 1.0f, 0.3f, 0.3f};
  const SurfacePoint point = surface_point(world, find_render_features(world), hit, {0, 0, 1});
  EXPECT_EQ(point.lit_position(), point.position);
  EXPECT_EQ(point.horizon(), glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace asos::test::shadow_terminator_test
