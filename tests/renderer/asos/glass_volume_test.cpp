#include "renderer/shading/environment.h"
#include "tests/renderer/asos/glass_world.h"
#include "tests/support/facets.h"
#include "tests/support/make_settings.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

// Attenuation in volumes of glass, closed or not (Beer's and Lambert's laws), and cases without
// refraction.

namespace asos::test::glass {
namespace {

TEST(GlassVolume, AttenuatesByTheWayThroughIt) {
  constexpr double n = 1.5, thickness = 0.4;
  Material green = clear(static_cast<float>(n));
  green.volume.attenuation_color = {0.25f, 0.9f, 0.0f};
  green.volume.attenuation_distance = 0.5f;
  for (const double i : {0.0, 0.8}) {
    const double way = thickness / std::cos(std::asin(std::sin(i) / n));
    World world;
    add_plate(world, i, thickness, green);
    add_quad(world, {-50, -50, -20}, {100, 0, 0}, {0, 100, 0}, wall(glm::vec3(1.0f)));
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const glm::dvec3 seen = mean(picture(*scene, orthographic(0.5), method));
      EXPECT_NEAR(seen.x, std::pow(0.25, way / 0.5), 1e-3);
      EXPECT_NEAR(seen.y, std::pow(0.9, way / 0.5), 1e-3);
      EXPECT_NEAR(seen.z, 0.0, 1e-3);
    }
  }
}

TEST(GlassVolume, AddsNoLight) {
  Material glass = clear(1.5f);
  glass.specular = 1.0f;
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  // Faint rays end at random, with noise within EPS, which has to be below the tolerance of the
  // test.
  constexpr double eps = 1.0 / 2048.0;
  for (const float roughness : {0.0f, 0.3f, 0.8f}) {
    glass.roughness = roughness;
    World world;
    add_shape(world, sphere(1.0), glm::dmat4(1.0), glass);
    const auto scene = make_render_scene(std::move(world));
    const int spp = roughness > 0.0f ? 256 : 1024;  // without roughness, single pixels are tested
    for (const Method method : methods) {
      const std::vector<glm::vec3> seen =
          picture(*scene, orthographic(2.2), method, white, eps, spp);
      EXPECT_LE(mean(seen).y, 1.001) << roughness << ", method " << static_cast<int>(method);
      if (roughness > 0.0f) continue;
      for (const glm::vec3 p : seen) {
        EXPECT_LE(p.y, 1.001f) << "method " << static_cast<int>(method);
        EXPECT_GE(p.y, 0.98f) << "method " << static_cast<int>(method);
      }
    }
  }
}

// A frosted pane reflects the light that it does not transmit, and no more.
TEST(GlassVolume, FrostedWallsAddNoLight) {
  Material glass = clear(1.5f);
  glass.volume.thickness = 0.0f;
  glass.specular = 1.0f;
  glass.double_sided = true;
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  for (const float roughness : {0.1f, 0.3f, 0.8f}) {
    glass.roughness = roughness;
    World world;
    add_quad(world, {-5, -5, 0}, {10, 0, 0}, {0, 10, 2}, glass);
    add_quad(world, {-5, -5, -1}, {10, 0, 1}, {0, 10, 0}, glass);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const double seen = mean(picture(*scene, orthographic(2.0), method, white)).y;
      EXPECT_LE(seen, 1.001) << roughness << ", method " << static_cast<int>(method);
      // The lobes lose light that would be reflected twice.
      EXPECT_GE(seen, 0.97) << roughness << ", method " << static_cast<int>(method);
    }
  }
}

Material green() {
  Material m = clear(1.5f);
  m.volume.attenuation_color = {0.25f, 0.9f, 0.0f};
  m.volume.attenuation_distance = 2.0f;
  return m;
}

/// Expects that a white background is attenuated over a path of length `way`.
void expect_attenuated(World world, const Camera& camera, double way) {
  const auto scene = make_render_scene(std::move(world));
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  for (const Method method : methods) {
    const glm::dvec3 seen = mean(picture(*scene, camera, method, white));
    EXPECT_NEAR(seen.x, std::pow(0.25, way / 2.0), 1e-3) << static_cast<int>(method);
    EXPECT_NEAR(seen.y, std::pow(0.9, way / 2.0), 1e-3) << static_cast<int>(method);
    EXPECT_NEAR(seen.z, way > 0.0 ? 0.0 : 1.0, 1e-3) << static_cast<int>(method);
  }
}

TEST(GlassVolume, AttenuatesFromAnEyeInsideTheGlass) {
  World world;
  add_plate(world, 0.0, 1.0, green());
  Camera camera = orthographic(0.5);
  camera.world_from_camera[3] = glm::dvec4(0, 0, 0.2, 1);
  expect_attenuated(std::move(world), camera, 0.7);
}

TEST(GlassVolume, AttenuatesWithinAnOpenSurfaceUpToWhatLiesBehind) {
  World world;
  add_quad(world, {-5, -5, 1}, {10, 0, 0}, {0, 10, 0}, green());
  add_quad(world, {-50, -50, -2}, {100, 0, 0}, {0, 100, 0}, wall(glm::vec3(1.0f)));
  expect_attenuated(std::move(world), orthographic(0.5), 3.0);
  // Without a surface behind it the thickness is unknown, so nothing is attenuated.
  World open;
  add_quad(open, {-5, -5, 1}, {10, 0, 0}, {0, 10, 0}, green());
  expect_attenuated(std::move(open), orthographic(0.5), 0.0);
}

TEST(GlassVolume, OfAnInfiniteIndexReflectsAll) {
  Material mirror = clear(0.0f);
  mirror.specular = 1.0f;
  World world;
  add_plate(world, 0.3, 1.0, mirror);
  add_quad(world, {-50, -50, -2}, {100, 0, 0}, {0, 100, 0}, wall(glm::vec3(0.0f)));
  const auto scene = make_render_scene(std::move(world));
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  for (const Method method : methods)
    EXPECT_NEAR(mean(picture(*scene, orthographic(0.5), method, white)).y, 1.0, 1e-3);
}

TEST(GlassVolume, ThinWallsAndUnfollowedOnesBendNothing) {
  for (const bool thin : {true, false}) {
    Material m = clear(1.5f);
    if (thin) m.volume.thickness = 0.0f;
    World world;
    add_plate(world, 1.0, 0.4, m);
    add_edge(world, 0.0123, -6.0);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      RenderSettings settings = make_settings(picture_side, picture_side, method, 256);
      if (!thin) settings.mirror.bounces = 0;
      const auto seen = render_picture(*scene, orthographic(1.0), settings).film.radiance;
      EXPECT_NEAR(edge_in(seen, 1.0), 0.0123, 1e-3) << thin << " " << static_cast<int>(method);
    }
  }
}

/// White fraction of each column for an edge seen through glass that deviates rays.
struct Columns {
  double edge = 0.0, width = 2.0;
  std::array<double, picture_side> white{};

  /// Adds a fraction `share` of the rays, shifted by `aside`.
  void add(double share, double aside) {
    const double pixel = width / picture_side;
    for (int x = 0; x < picture_side; ++x) {
      const double middle = (x + 0.5 - 0.5 * picture_side) * pixel + aside;
      white[static_cast<std::size_t>(x)] +=
          share * std::clamp((edge - middle) / pixel + 0.5, 0.0, 1.0);
    }
  }
};

/// Compares a picture's columns: within two EPS for ASOS, otherwise within three standard
/// deviations of independent samples.
void expect_columns(const std::vector<glm::vec3>& seen, const Columns& expected, Method method,
                    double roughness) {
  const double allowed =
      method == Method::asos ? 2.0 * AsosSettings{}.eps : 3.0 * 0.5 / std::sqrt(12.0 * 256.0);
  for (int x = 0; x < picture_side; ++x) {
    double column = 0.0;
    for (int y = 0; y < picture_side; ++y)
      column += static_cast<double>(seen[static_cast<std::size_t>(y * picture_side + x)].y);
    EXPECT_NEAR(column / picture_side, expected.white[static_cast<std::size_t>(x)], allowed)
        << "roughness " << roughness << ", column " << x << ", method " << static_cast<int>(method);
  }
}

Facets facets_of(double roughness) {
  Facets facets;
  facets.alpha = glm::dvec2(roughness * roughness);
  return facets;
}

// Both sides of a rough plate refract at visible facets.
TEST(GlassVolume, RoughGlassBlursWhatLiesBehindIt) {
  constexpr double n = 1.5, thickness = 0.4, behind = 3.8;
  constexpr int rings = 40;
  for (const double roughness : {0.1, 0.2, 0.3, 0.5}) {
    Columns expected{0.0123};
    const Facets facets = facets_of(roughness);
    const glm::dvec3 eye(0, 0, 1);
    facets.each_visible(rings, eye, [&](glm::dvec3 first, double share) {
      const glm::dvec3 within = glm::refract(-eye, first, 1.0 / n);
      const double inside = thickness * within.x / -within.z;
      facets.each_visible(rings, -within, [&](glm::dvec3 second, double part) {
        glm::dvec3 beyond = glm::refract(within, second, n);
        // Total reflection at a facet: the light leaves through the mean surface instead.
        if (!(beyond.z < 0.0)) beyond = glm::refract(within, {0, 0, 1}, n);
        if (!(beyond.z < 0.0)) beyond = {within.x, within.y, -1e-6};
        expected.add(share * part, inside + behind * beyond.x / -beyond.z);
      });
    });
    World world;
    Material frosted = clear(static_cast<float>(n));
    frosted.roughness = static_cast<float>(roughness);
    add_plate(world, 0.0, thickness, frosted);
    add_edge(world, expected.edge, -behind - 0.5 * thickness, 1000.0);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods)
      expect_columns(picture(*scene, orthographic(expected.width), method), expected, method,
                     roughness);
  }
}

// A rough thin wall shows the scene behind it like an equally rough mirror shows the scene in
// front, but from the other side (KHR_materials_transmission), without loss.
TEST(GlassVolume, RoughThinWallsBlurAsMirrorsDo) {
  constexpr double behind = 4.0;
  for (const double angle : {0.0, 0.8}) {
    for (const double roughness : {0.05, 0.2, 0.4}) {
      // The wall is seen frontally, or tilted about the x axis: its lower end leans towards the
      // viewer.
      Columns expected{0.0123};
      const Facets facets = facets_of(roughness);
      const glm::dvec3 eye(0, std::sin(angle), std::cos(angle));
      for (int y = 0; y < picture_side; ++y) {
        const double up = (0.5 * picture_side - y - 0.5) * expected.width / picture_side;
        facets.each_visible(100, eye, [&](glm::dvec3 facet, double share) {
          glm::dvec3 l = 2.0 * glm::dot(eye, facet) * facet - eye;
          l.z = -std::abs(l.z);
          const double away = -glm::dot(l, eye);
          const double way = behind - up * std::tan(angle);
          if (away > 0.0) {
            expected.add(share / picture_side, way * l.x / away);
          } else {
            for (double& white : expected.white)
              white += share / picture_side * static_cast<double>(sky_radiance);
          }
        });
      }
      World world;
      Material frosted = clear(1.5f);
      frosted.volume.thickness = 0.0f;
      frosted.double_sided = true;
      frosted.roughness = static_cast<float>(roughness);
      const auto up = static_cast<float>(std::cos(angle)),
                 back = static_cast<float>(std::sin(angle));
      add_quad(world, {-5, -5 * up, 5 * back}, {10, 0, 0}, {0, 10 * up, -10 * back}, frosted);
      add_edge(world, expected.edge, -behind, 1000.0);
      const auto scene = make_render_scene(std::move(world));
      for (const Method method : methods)
        expect_columns(picture(*scene, orthographic(expected.width), method), expected, method,
                       roughness);
    }
  }
}

}  // namespace
}  // namespace asos::test::glass
