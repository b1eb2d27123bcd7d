#include "tests/renderer/prepared/line_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numbers>

// The colours, textures and light of lines and points.

namespace asos::test::line_scenes {
namespace {

TEST(WithLines, VerticesColoursRunAlongALine) {
  Mesh line = lines({{-1, 0, 0}, {1, 0, 0}});
  line.material = -1;
  line.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}};
  const auto scene = prepared(scene_of({square(0.1f, -50.0f), line}));
  const Camera camera = camera_for(*scene, false);
  const Film film = picture_of(scene, camera, settings_of(6.0));
  // A unit is 12 pixels; the centre of pixel column 37 is at 5.5 / 12.
  const glm::vec3 there = at(film, 37, 24);
  EXPECT_NEAR(there.r, 0.5 * (1.0 - 5.5 / 12.0), 1e-3);
  EXPECT_NEAR(there.g, 0.5 * (1.0 + 5.5 / 12.0), 1e-3);
  EXPECT_NEAR(there.b, 0.0, 1e-6);
}

/// A wide line across the picture's centre, without light and with a black sky.
Film picture_of_line(Scene scene, Method method = Method::asos) {
  scene.lights.clear();
  const auto ready = prepared(scene);
  RenderSettings settings = settings_of(8.0);
  settings.method = method;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return picture_of(ready, camera_for(*ready, false), settings);
}

constexpr Method both_methods[] = {Method::asos, Method::sobol};

void expect_near(glm::vec3 seen, glm::vec3 right, float error) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], right[c], error) << c;
}

// glTF 2.0, section 3.9.7: base colour and emission.
TEST(WithLines, WithoutNormalsEmissionIsAdded) {
  Scene scene = scene_of({lines({{-1.5f, 0, 0}, {1.5f, 0, 0}})});
  scene.materials[0].base_color = {0.5f, 0.25f, 0.125f, 1.0f};
  scene.materials[0].emissive = {0.2f, 0.1f, 0.0f};
  scene.materials[0].emissive_strength = 2.0f;
  for (const Method method : both_methods)
    expect_near(at(picture_of_line(scene, method), 32, 24), {0.9f, 0.45f, 0.125f}, 1e-6f);
  scene.materials[0].unlit = true;  // KHR_materials_unlit: the base colour alone
  for (const Method method : both_methods)
    expect_near(at(picture_of_line(scene, method), 32, 24), {0.5f, 0.25f, 0.125f}, 1e-6f);
}

TEST(WithLines, TexturesRunAlongALine) {
  Scene scene = scene_of({lines({{-1.5f, 0, 0}, {1.5f, 0, 0}})});
  scene.images.push_back({"two", 2, 1, {}});
  scene.images[0].rgba = SharedBytes(SharedBytes::Bytes{255, 0, 0, 255, 0, 255, 0, 255});
  Texture texture{.image = 0, .filter = Filter::nearest};
  texture.wrap_u = texture.wrap_v = Wrap::clamp_to_edge;
  scene.textures.push_back(texture);
  Material& material = scene.materials[0];
  material.base_color = {0.5f, 0.5f, 0.5f, 1.0f};
  material.base_color_texture.texture = 0;
  material.emissive = glm::vec3(0.25f);
  material.emissive_texture.texture = 0;
  material.emissive_texture.texcoord = 1;
  // Base colour from red to green, and emission from green to red.
  scene.meshes[0].texcoords[0] = {{0, 0.5f}, {1, 0.5f}};
  scene.meshes[0].texcoords[1] = {{1, 0.5f}, {0, 0.5f}};
  for (const Method method : both_methods) {
    const Film film = picture_of_line(scene, method);
    expect_near(at(film, 20, 24), {0.5f, 0.25f, 0.0f}, 1e-5f);
    expect_near(at(film, 44, 24), {0.25f, 0.5f, 0.0f}, 1e-5f);
  }
  // Without its own coordinates the line has the colour of the texture's corner.
  scene.meshes[0].texcoords[0].clear();
  scene.meshes[0].texcoords[1].clear();
  expect_near(at(picture_of_line(scene), 44, 24), {0.75f, 0.0f, 0.0f}, 1e-5f);
}

// A matte line under a sun has E cos / pi times its colour, whatever way its ribbon faces.
TEST(WithLines, NormalsLightLinesAndPoints) {
  const glm::vec3 normal(0.0f, 0.8f, 0.6f);
  for (const glm::dvec3 to_light : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0.6, 0.8),
                                    glm::dvec3(0, 0.96, -0.28), glm::dvec3(0, -1, 0)}) {
    for (const bool of_points : {false, true}) {
      Mesh mesh = of_points ? points({{0, 0, 0}}) : lines({{-1.5f, 0, 0}, {1.5f, 0, 0}});
      mesh.normals.assign(mesh.positions.size(), normal);
      Scene scene = scene_of({mesh});
      Material& material = scene.materials[0];
      material.base_color = {0.9f, 0.5f, 0.1f, 1.0f};
      material.metallic = 0.0f;
      material.specular = 0.0f;
      material.emissive = {0.0f, 0.0f, 0.25f};
      scene.lights[0].direction = -to_light;
      scene.lights[0].intensity = 3.0f;
      const auto ready = prepared(scene);
      for (const Method method : both_methods) {
        RenderSettings settings = settings_of(8.0);
        settings.method = method;
        settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
        const Film film = picture_of(ready, camera_for(*ready, false), settings);
        const double cosine = std::max(0.0, glm::dot(glm::dvec3(normal), to_light));
        const auto irradiance = static_cast<float>(3.0 * cosine / std::numbers::pi);
        expect_near(at(film, 32, 24),
                    irradiance * glm::vec3(0.9f, 0.5f, 0.1f) + glm::vec3(0, 0, 0.25f), 2e-4f);
      }
    }
  }
}

TEST(WithLines, ANormalOfNoLengthFacesTheEye) {
  Mesh mesh = lines({{-1.5f, 0, 0}, {1.5f, 0, 0}});
  mesh.normals.assign(2, glm::vec3(0.0f));
  Scene scene = scene_of({mesh});
  scene.materials[0].metallic = 0.0f;
  scene.materials[0].specular = 0.0f;
  scene.lights[0].direction = {0, 0, -1};
  const auto ready = prepared(scene);
  RenderSettings settings = settings_of(8.0);
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  const Film film = picture_of(ready, camera_for(*ready, false), settings);
  EXPECT_NEAR(at(film, 32, 24).r, red / std::numbers::pi, 1e-4);
}

}  // namespace
}  // namespace asos::test::line_scenes
