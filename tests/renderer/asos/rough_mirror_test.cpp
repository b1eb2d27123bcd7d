#include "renderer/comparison/method.h"
#include "renderer/geometry/view.h"
#include "renderer/shading/environment.h"
#include "tests/support/facets.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <vector>

// Surfaces in a rough mirror look as glTF's lobe requires: against the integral over its facets
// (tests/support/facets.h).

namespace asos::rough_mirror_test {
namespace {

using test::add_quad;
using test::Facets;
using test::look_at;
using test::make_render_scene;
using test::unlit;

constexpr int side = 24;
constexpr int rows = 8;
constexpr double height = 6.0;  // of the mirrored object
constexpr double half = 9.0;    // half its width
constexpr double fov = 0.3;
constexpr double eps = 1.0 / 1024.0;

struct Case {
  double roughness = 0.2;
  double angle = 0.0;       // between the normal and the view direction
  double f0 = 1.0;          // below 1: a dielectric
  double anisotropy = 0.0;  // across the edge

  friend std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << "roughness " << c.roughness << " angle " << c.angle << " f0 " << c.f0
               << " anisotropy " << c.anisotropy;
  }
};

/// Looks down at a mirror in y = 0; the edge above it, along z, runs upwards in the picture.
Camera camera_of(const Case& c) {
  return look_at({0, 4.0 * std::cos(c.angle), 4.0 * std::sin(c.angle) + 1e-9}, {0, 0, 0}, fov);
}

Material mirror_of(const Case& c) {
  return {.base_color = glm::vec4(glm::vec3(c.f0 < 1.0 ? 0.0f : 1.0f), 1.0f),
          .metallic = c.f0 < 1.0 ? 0.0f : 1.0f,
          .roughness = static_cast<float>(c.roughness),
          .double_sided = true,
          .anisotropy = {.strength = static_cast<float>(c.anisotropy)}};
}

/// A mirror below the dark half-plane x < 0.
World half_plane(const Case& c) {
  World world;
  add_quad(world, {-9, 0, 9}, {18, 0, 0}, {0, 0, -18}, mirror_of(c));
  Material dark = unlit({0.0f, 0.0f, 0.0f});
  dark.double_sided = true;
  add_quad(world, {-half, height, half}, {half, 0, 0}, {0, 0, -2 * half}, dark);
  return world;
}

RenderSettings settings_of(Method method) {
  RenderSettings settings = test::make_settings(side, side, method, 1024);
  settings.crop = {0, (side - rows) / 2, side, rows};
  settings.asos.eps = eps;
  return settings;
}

/// Means of columns over the rendered rows.
std::vector<double> columns(const RenderScene& scene, const Case& c, Method method) {
  const RenderSettings settings = settings_of(method);
  const Film film = test::render_picture(scene, camera_of(c), settings).film;
  std::vector<double> means(side, 0.0);
  for (int y = settings.crop.y; y < settings.crop.y + rows; ++y)
    for (int x = 0; x < side; ++x)
      means[static_cast<std::size_t>(x)] +=
          static_cast<double>(film.radiance[film.index(x, y)].x) / rows;
  return means;
}

/// Radiance that the facets reflect along a ray to the mirror.
double seen_along(const Ray& ray, const Facets& facets) {
  constexpr int rings = 120;
  const glm::dvec3 from(ray.origin), towards = glm::normalize(glm::dvec3(ray.direction));
  const glm::dvec3 at = from - (from.y / towards.y) * towards;
  // x stays x; the world's y is the facets' z.
  const glm::dvec3 v(-towards.x, towards.z, -towards.y);
  return facets.mirrored(rings, v, [&](glm::dvec3 l) {
    const double way = height / l.z;
    const glm::dvec2 met(at.x + way * l.x, at.z - way * l.y);
    const bool dark = met.x < 0.0 && met.x > -half && std::abs(met.y) < half;
    return dark ? 0.0 : static_cast<double>(sky_radiance);
  });
}

/// Mean reflected radiance of each column.
std::vector<double> expected(const Case& c) {
  constexpr int parts = 4;  // of a pixel's width
  const RenderSettings settings = settings_of(Method::asos);
  const View view(camera_of(c), side, side);
  Facets facets;
  const double alpha = c.roughness * c.roughness;
  facets.alpha = {glm::mix(alpha, 1.0, c.anisotropy * c.anisotropy), alpha};
  facets.f0 = c.f0;
  std::vector<double> means(side, 0.0);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < side * parts; ++x)
      means[static_cast<std::size_t>(x / parts)] +=
          seen_along(view.ray((x + 0.5) / parts, settings.crop.y + y + 0.5), facets) /
          (rows * parts);
  return means;
}

class EveryRoughness : public testing::TestWithParam<Case> {};

TEST_P(EveryRoughness, ShowsAnEdgeAsItsFacetsDo) {
  const Case& c = GetParam();
  const auto scene = make_render_scene(half_plane(c));
  const std::vector<double> truth = expected(c);
  const double sky = static_cast<double>(sky_radiance);
  // Standard error of a column with independent samples: 0.5 / sqrt(1024 * rows) of the reflected
  // radiance.
  const double noise = 3.0 * 0.5 / std::sqrt(1024.0 * rows) * c.f0 * sky;
  for (const Method method : {Method::sobol, Method::asos}) {
    const double allowed = noise + (method == Method::asos ? eps : 0.0);
    const std::vector<double> seen = columns(*scene, c, method);
    double bias = 0.0;
    for (std::size_t x = 0; x < side; ++x) {
      EXPECT_NEAR(seen[x], truth[x], allowed)
          << x << " method " << static_cast<int>(method) << ", " << c;
      bias += (seen[x] - truth[x]) / side;
    }
    EXPECT_NEAR(bias, 0.0, 0.2 * allowed) << static_cast<int>(method) << ", " << c;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, EveryRoughness,
                         testing::Values(Case{0.05}, Case{0.2}, Case{0.35}, Case{0.2, 0.9},
                                         Case{0.35, 1.2}, Case{0.3, 0.6, 0.04},
                                         Case{0.15, 0.5, 1.0, 0.3}));

}  // namespace
}  // namespace asos::rough_mirror_test
