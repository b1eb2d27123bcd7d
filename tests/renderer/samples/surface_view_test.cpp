#include "renderer/samples/surface_view.h"

#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>

// Unlit surface properties, against the values of the materials.

namespace asos::test::surface_view_test {
namespace {

constexpr int side = 16;

Material painted() {
  Material m = matte({0.2f, 0.4f, 0.6f});
  m.roughness = 0.5f;
  m.metallic = 0.25f;
  m.emissive = {0.1f, 0.3f, 0.7f};
  return m;
}

/// A square from x = -1 to 0 that faces the camera, whose view is -1 to 1.
std::shared_ptr<const RenderScene> half(const Material& material) {
  World world;
  add_quad(world, {-1, -1, 0}, {1, 0, 0}, {0, 2, 0}, material);
  return make_render_scene(std::move(world));
}

SurfacePicture picture_of(const RenderScene& scene, SurfaceProperty property,
                          SurfaceSampling sampling = {}) {
  return surface_picture(scene, View(orthographic(2.0), side, side), Culling::none, property,
                         sampling, {});
}

glm::vec3 at(const SurfacePicture& picture, int x, int y) {
  return picture.film.radiance[picture.film.index(x, y)];
}

void expect_near(glm::vec3 found, glm::vec3 wanted, float tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], wanted[i], tolerance) << i;
}

TEST(SurfacePicture, ShowsColoursAsLinearRadiance) {
  const auto scene = half(painted());
  for (const SurfaceSampling sampling : {SurfaceSampling{4, 1}, {1, 1}, {1, 3}}) {
    expect_near(at(picture_of(*scene, SurfaceProperty::base_color, sampling), 4, 9),
                {0.2f, 0.4f, 0.6f}, 1e-6f);
    expect_near(at(picture_of(*scene, SurfaceProperty::emission, sampling), 4, 9),
                {0.1f, 0.3f, 0.7f}, 1e-6f);
  }
}

TEST(SurfacePicture, ShowsOtherValuesAsDisplayBytes) {
  const auto scene = half(painted());
  const auto byte = [&](SurfaceProperty property) {
    return display_bytes(at(picture_of(*scene, property), 4, 9), 0.0f);
  };
  EXPECT_EQ(byte(SurfaceProperty::roughness), glm::u8vec3(128));
  EXPECT_EQ(byte(SurfaceProperty::metallic), glm::u8vec3(64));
  EXPECT_EQ(byte(SurfaceProperty::occlusion), glm::u8vec3(255));
  EXPECT_EQ(byte(SurfaceProperty::normal), glm::u8vec3(128, 128, 255));
}

TEST(SurfacePicture, CoversOnlyWhatSurfacesCover) {
  const auto scene = half(painted());
  const SurfacePicture picture =
      surface_picture(*scene, View(orthographic(2.0), 3, 3), Culling::none,
                      SurfaceProperty::base_color, {1, 4}, {});
  EXPECT_EQ(picture.film.coverage[0], 1.0f);
  EXPECT_EQ(picture.film.coverage[1], 0.5f);  // its left half
  expect_near(picture.film.radiance[1], {0.1f, 0.2f, 0.3f}, 1e-6f);
  EXPECT_EQ(picture.film.coverage[2], 0.0f);
  EXPECT_EQ(picture.film.radiance[2], glm::vec3(0.0f));
}

// The diagonal and the border of the square are drawn half a pixel to either side.
TEST(SurfacePicture, DrawsTheEdgesOfTriangles) {
  World world;
  add_quad(world, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, painted());
  const auto scene = make_render_scene(std::move(world));
  const SurfacePicture picture = picture_of(*scene, SurfaceProperty::base_color, {1, 4});
  const auto line = [&](int x, int y) { return picture.wireframe[picture.film.index(x, y)]; };
  EXPECT_GT(line(7, 8), 0.8f);  // from the lower left to the upper right
  EXPECT_GT(line(12, 3), 0.8f);
  EXPECT_EQ(line(3, 5), 0.0f);
  EXPECT_EQ(line(12, 10), 0.0f);
  EXPECT_EQ(line(0, 5), 0.5f);
  EXPECT_EQ(line(1, 5), 0.0f);
}

// Eight squares along each side of a texture, alternately dark and bright.
TEST(SurfacePicture, ShowsTextureCoordinatesAsACheckerboard) {
  World world;
  const Material m = painted();
  add_quad(world, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, m);
  const auto scene = make_render_scene(std::move(world));
  const SurfacePicture picture = picture_of(*scene, SurfaceProperty::texture_coordinates);
  const float bright = at(picture, 0, 15).x, dark = at(picture, 2, 15).x;
  EXPECT_GT(bright, 1.5f * dark);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x)
      EXPECT_EQ(at(picture, x, y).x, (x / 2 + (side - 1 - y) / 2) % 2 == 0 ? bright : dark);
  }
}

TEST(SurfacePicture, ShowsVertexColorsAndTheSecondTextureCoordinates) {
  World world;
  add_quad(world, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, painted());
  world.colors.assign(world.positions.size(), glm::vec4(0.25f, 0.5f, 1.0f, 1.0f));
  const auto without = make_render_scene(World(world));
  EXPECT_EQ(at(picture_of(*without, SurfaceProperty::second_texture_coordinates), 8, 8),
            glm::vec3(0.0f));
  for (const glm::vec2 uv : world.texcoords[0]) world.texcoords[1].emplace_back(uv);
  const auto scene = make_render_scene(std::move(world));
  EXPECT_EQ(at(picture_of(*scene, SurfaceProperty::vertex_color), 8, 8),
            glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_EQ(picture_of(*scene, SurfaceProperty::second_texture_coordinates).film.radiance,
            picture_of(*scene, SurfaceProperty::texture_coordinates).film.radiance);
}

TEST(SurfacePicture, EndsWhenItIsStopped) {
  const auto scene = half(painted());
  std::stop_source stop;
  stop.request_stop();
  const SurfacePicture picture =
      surface_picture(*scene, View(orthographic(2.0), side, side), Culling::none,
                      SurfaceProperty::base_color, {}, stop.get_token());
  EXPECT_EQ(at(picture, 4, 9), glm::vec3(0.0f));
}

}  // namespace
}  // namespace asos::test::surface_view_test
