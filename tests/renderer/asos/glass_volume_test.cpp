#include "tests/renderer/asos/glass_world.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

// What is left of light within volumes of glass, closed or not (Beer's and Lambert's law), and what
// bends none.

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
  for (const float roughness : {0.0f, 0.3f, 0.8f}) {
    glass.roughness = roughness;
    World world;
    add_shape(world, sphere(1.0), glm::dmat4(1.0), glass);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const std::vector<glm::vec3> seen = picture(*scene, orthographic(2.2), method, white);
      EXPECT_LE(mean(seen).y, 1.001) << roughness << ", method " << static_cast<int>(method);
      if (roughness > 0.0f) continue;
      for (const glm::vec3 p : seen) {
        EXPECT_LE(p.y, 1.001f) << "method " << static_cast<int>(method);
        EXPECT_GE(p.y, 0.98f) << "method " << static_cast<int>(method);
      }
    }
  }
}

Material green() {
  Material m = clear(1.5f);
  m.volume.attenuation_color = {0.25f, 0.9f, 0.0f};
  m.volume.attenuation_distance = 2.0f;
  return m;
}

/// What white that fills the picture looks like.
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

TEST(GlassVolume, AttenuatesFromTheEyeWhereThatIsWithin) {
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
  // Nothing does: there is no telling how thick it is.
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
      RenderSettings settings;
      settings.width = settings.height = picture_side;
      settings.method = method;
      settings.sampling.spp = 256;
      if (!thin) settings.mirror.bounces = 0;
      const auto seen = render_picture(*scene, orthographic(1.0), settings).film.radiance;
      EXPECT_NEAR(edge_in(seen, 1.0), 0.0123, 1e-3) << thin << " " << static_cast<int>(method);
    }
  }
}

// Frosted glass shows an edge as a ramp, in the same place, alike in all methods: so far away that
// a pixel, whose width a pyramid adds to the blur's, is small beside that.
TEST(GlassVolume, RoughGlassBlursWhatLiesBehindIt) {
  World world;
  Material frosted = clear(1.5f);
  frosted.roughness = 0.3f;
  add_plate(world, 0.0, 0.1, frosted);
  add_edge(world, 0.0, -8.0);
  const auto scene = make_render_scene(std::move(world));
  const std::vector<glm::vec3> asos = picture(*scene, orthographic(1.0), Method::asos);
  const std::vector<glm::vec3> sobol = picture(*scene, orthographic(1.0), Method::sobol);
  int between = 0;
  for (int x = 0; x < picture_side; ++x) {
    const auto column = [x](const std::vector<glm::vec3>& pixels) {
      float sum = 0.0f;
      for (int y = 0; y < picture_side; ++y)
        sum += pixels[static_cast<std::size_t>(y * picture_side + x)].y;
      return sum / picture_side;
    };
    EXPECT_NEAR(column(asos), column(sobol), 0.02) << x;
    between += column(asos) > 0.1f && column(asos) < 0.9f;
  }
  EXPECT_GT(between, picture_side / 4);
  EXPECT_NEAR(edge_in(asos, 1.0), 0.0, 0.01);
  EXPECT_NEAR(edge_in(sobol, 1.0), 0.0, 0.01);
}

}  // namespace
}  // namespace asos::test::glass
