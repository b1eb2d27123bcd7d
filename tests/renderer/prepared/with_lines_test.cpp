#include "renderer/prepared/with_lines.h"

#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace asos::test::with_strokes_test {
namespace {

constexpr float red = 0.9f;

Material red_material() {
  Material material;
  material.base_color = {red, 0.0f, 0.0f, 1.0f};
  return material;
}

Mesh lines(std::vector<glm::vec3> positions) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  for (std::uint32_t i = 0; i + 1 < mesh.positions.size(); i += 2)
    mesh.segments.emplace_back(i, i + 1);
  mesh.material = 0;
  return mesh;
}

Mesh points(std::vector<glm::vec3> positions) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.points.push_back(i);
  mesh.material = 0;
  return mesh;
}

/// A plain square in the plane z = `z`, from -half to half, facing +Z.
Mesh square(float half, float z) {
  Mesh mesh;
  mesh.positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
  mesh.normals.assign(4, glm::vec3(0, 0, 1));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Scene scene_of(std::vector<Mesh> meshes) {
  Scene scene;
  scene.source = "test";
  scene.materials.push_back(red_material());
  for (Mesh& mesh : meshes) {
    scene.instances.push_back({"it", static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
    scene.meshes.push_back(std::move(mesh));
  }
  Light sun;
  sun.type = Light::Type::directional;
  sun.direction = glm::normalize(glm::dvec3(0.3, -0.2, -1.0));
  scene.lights.push_back(sun);
  return scene;
}

/// At (0, 0, 5) in the author's coordinates, looking along -Z.
Camera camera_for(const RenderScene& scene, bool perspective = true) {
  Camera camera;
  camera.type = perspective ? Camera::Type::perspective : Camera::Type::orthographic;
  camera.fov_y_rad = 0.7;
  camera.height = 4.0;
  camera.world_from_camera[3] = glm::dvec4(glm::dvec3(0, 0, 5) - scene.world().origin, 1.0);
  return camera;
}

RenderSettings settings_of(double line_width) {
  RenderSettings settings;
  settings.width = 64;
  settings.height = 48;
  settings.line_width = line_width;
  settings.asos.max_level = 5;
  return settings;
}

std::shared_ptr<const RenderScene> prepared(const Scene& scene) {
  return prepare(scene).value();
}

Film picture_of(const std::shared_ptr<const RenderScene>& scene, const Camera& camera,
                const RenderSettings& settings) {
  const auto drawn = with_lines(scene, line_picture(camera, settings)).value();
  return render_picture(*drawn, camera, settings).film;
}

/// Position in the picture, in pixels from its centre, of a point in the author's coordinates.
glm::dvec2 projected(glm::dvec3 p, const Camera& camera, int height) {
  const bool perspective = camera.type == Camera::Type::perspective;
  const double tall =
      perspective ? 2.0 * std::tan(0.5 * camera.fov_y_rad) * (5.0 - p.z) : camera.height;
  return glm::dvec2(p) * (height / tall);
}

glm::vec3 at(const Film& film, int x, int y) {
  return film.radiance[film.index(x, y)];
}

/// Number of red pixels, in front of the grey neutral sky.
double red_area(const Film& film) {
  double area = 0.0;
  const glm::vec3 sky = at(film, 0, 0);
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      // Green measures how much of the sky is hidden.
      area += 1.0 - static_cast<double>(at(film, x, y).g) / static_cast<double>(sky.g);
      EXPECT_NEAR(at(film, x, y).r - at(film, x, y).g, red * (1.0f - at(film, x, y).g / sky.g),
                  2e-5f);
    }
  }
  return area;
}

double largest_difference(const Film& a, const Film& b) {
  double largest = 0.0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const glm::vec3 d = glm::abs(at(a, x, y) - at(b, x, y));
      largest = std::max<double>(largest, std::max({d.r, d.g, d.b}));
    }
  }
  return largest;
}

TEST(WithLines, ALineCoversItsRectangle) {
  for (const bool perspective : {true, false}) {
    for (const double width : {1.0, 2.5, 6.0}) {
      for (const double angle : {0.0, 0.3, 0.7853981, 1.2, 1.5707963}) {
        SCOPED_TRACE(testing::Message() << "perspective " << perspective << ", width " << width
                                        << ", angle " << angle);
        // One end is nearer than the other.
        const glm::dvec3 a(0.9 * std::cos(angle), 0.9 * std::sin(angle), 0.8);
        const glm::dvec3 b(-1.1 * std::cos(angle), -1.1 * std::sin(angle), -0.6);
        const auto scene = prepared(scene_of({lines({glm::vec3(a), glm::vec3(b)})}));
        const Camera camera = camera_for(*scene, perspective);
        const RenderSettings settings = settings_of(width);
        const double length = glm::length(projected(a, camera, settings.height) -
                                          projected(b, camera, settings.height));
        EXPECT_NEAR(red_area(picture_of(scene, camera, settings)) / (width * length), 1.0, 1e-3);
      }
    }
  }
}

TEST(WithLines, APointCoversItsDisk) {
  for (const double width : {1.0, 2.0, 5.0, 16.0}) {
    SCOPED_TRACE(testing::Message() << "width " << width);
    const auto scene = prepared(scene_of({points({{0.31f, 0.17f, 0.5f}, {-1.2f, -0.4f, -0.7f}})}));
    const Camera camera = camera_for(*scene);
    RenderSettings settings = settings_of(width);
    settings.asos.max_level = 7;
    const double disk = 0.25 * std::numbers::pi * width * width;
    EXPECT_NEAR(red_area(picture_of(scene, camera, settings)) / (2.0 * disk), 1.0, 1e-3);
  }
}

TEST(WithLines, OtherMethodsSeeTheSame) {
  const auto scene = prepared(scene_of({lines({{-0.7f, -0.6f, 0.0f}, {0.9f, 0.8f, 0.4f}})}));
  const Camera camera = camera_for(*scene);
  RenderSettings settings = settings_of(3.0);
  const double exact = red_area(picture_of(scene, camera, settings));
  settings.method = Method::sobol;
  settings.sampling.spp = 64;
  EXPECT_NEAR(red_area(picture_of(scene, camera, settings)) / exact, 1.0, 0.01);
}

TEST(WithLines, SurfacesHideLinesAndLinesHideSurfaces) {
  const Mesh wall = square(1.0f, 0.0f);
  const std::vector<glm::vec3> behind{{-0.8f, -0.7f, -0.5f}, {0.6f, 0.7f, -0.5f}};
  const std::vector<glm::vec3> before{{-0.8f, -0.7f, 0.5f}, {0.6f, 0.7f, 0.5f}};
  const auto hidden = prepared(scene_of({wall, lines(behind)}));
  const auto seen = prepared(scene_of({wall, lines(before)}));
  const Camera camera = camera_for(*hidden);
  const Film bare = picture_of(hidden, camera, settings_of(0.0));
  EXPECT_LT(largest_difference(picture_of(hidden, camera, settings_of(3.0)), bare), 1e-5);
  EXPECT_GT(largest_difference(picture_of(seen, camera, settings_of(3.0)), bare), 0.1);
}

TEST(WithLines, ALineUponASurfaceIsNotBuriedInIt) {
  // A line along the wall's diagonal: the whole ribbon is visible.
  const auto scene =
      prepared(scene_of({square(1.0f, 0.0f), lines({{-0.8f, -0.8f, 0.0f}, {0.8f, 0.8f, 0.0f}})}));
  const Camera camera = camera_for(*scene);
  const RenderSettings settings = settings_of(2.0);
  const Film film = picture_of(scene, camera, settings);
  double blackened = 0.0;
  const Film bare = picture_of(scene, camera, settings_of(0.0));
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x < film.width; ++x)
      if (at(bare, x, y).b > 0.0f) blackened += 1.0 - at(film, x, y).b / at(bare, x, y).b;
  const double length = 2.0 * glm::length(projected({0.8, 0.8, 0.0}, camera, settings.height));
  EXPECT_NEAR(blackened / (2.0 * length), 1.0, 0.01);
}

TEST(WithLines, ALineIsCutWhereItEntersASurface) {
  const auto scene =
      prepared(scene_of({square(1.0f, 0.0f), lines({{-0.8f, -0.3f, -0.9f}, {0.7f, 0.4f, 0.8f}})}));
  const Camera camera = camera_for(*scene);
  RenderSettings settings = settings_of(6.0);
  const auto drawn = with_lines(scene, line_picture(camera, settings)).value();
  EXPECT_GT(drawn->features().counts().intersection, 0u);
  const Picture exact = render_picture(*drawn, camera, settings);
  EXPECT_EQ(exact.statistics.missed_splits, 0u);
  settings.method = Method::sobol;
  settings.sampling.spp = 4096;
  EXPECT_LT(largest_difference(exact.film, render_picture(*drawn, camera, settings).film), 4e-3);
}

TEST(WithLines, LinesAndPointsCastNoShadows) {
  // Between the wall and sun and sky, but outside the picture.
  std::vector<glm::vec3> near;
  for (int i = 0; i < 40; ++i) {
    const float x = -0.9f + 0.045f * static_cast<float>(i);
    near.insert(near.end(), {{x, -0.9f, 0.05f}, {x, 0.9f, 0.05f}});
  }
  Scene scene = scene_of({square(1.0f, 0.0f), lines(near), points(near)});
  for (Method method : {Method::asos, Method::sobol}) {
    for (const bool area_light : {false, true}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(method) << ", area " << area_light);
      if (area_light) {
        Light& lamp = scene.lights[0];
        lamp.type = Light::Type::rectangle;
        lamp.position = {0.2, 0.3, 3.0};
        lamp.direction = {0, 0, -1};
        lamp.half_u = {0.5, 0, 0};
        lamp.half_v = {0, 0.5, 0};
        lamp.intensity = 10.0f;
      }
      const auto ready = prepared(scene);
      // From behind the lines only the wall is visible.
      Camera camera = camera_for(*ready);
      camera.world_from_camera[3].z -= 4.98;
      camera.fov_y_rad = 2.5;
      RenderSettings settings = settings_of(2.0);
      settings.method = method;
      settings.asos.max_level = 3;
      settings.shadow.sky = true;
      const auto drawn = with_lines(ready, line_picture(camera, settings)).value();
      ASSERT_GT(drawn->world().lines_and_points.triangle_count, 0u);
      const Film bare = render_picture(*ready, camera, settings).film;
      EXPECT_LT(largest_difference(render_picture(*drawn, camera, settings).film, bare), 2e-5);
      EXPECT_GT(at(bare, 32, 24).g, 0.01f);
    }
  }
}

TEST(WithLines, NoneAreDrawnWithoutWidth) {
  const Mesh wall = square(1.0f, 0.0f);
  const auto with = prepared(scene_of({wall, lines({{-9, 0, 0}, {9, 3, 7}}), points({{5, 5, 5}})}));
  const auto without = prepared(scene_of({wall}));
  const Camera camera = camera_for(*without);
  const RenderSettings settings = settings_of(0.0);
  EXPECT_EQ(with_lines(with, line_picture(camera, settings)).value(), with);
  EXPECT_EQ(with_lines(without, line_picture(camera, settings_of(1.0))).value(), without);
  EXPECT_EQ(
      largest_difference(picture_of(with, camera, settings), picture_of(without, camera, settings)),
      0.0);
  // The same after they were drawn.
  const auto drawn = with_lines(with, line_picture(camera, settings_of(1.0))).value();
  EXPECT_EQ(largest_difference(picture_of(drawn, camera, settings),
                               picture_of(without, camera, settings)),
            0.0);
}

TEST(WithLines, AnotherPictureReplacesTheFirstOnes) {
  const auto scene = prepared(
      scene_of({square(1.0f, 0.0f), lines({{-1, 0, 0}, {1, 1, 0.5f}}), points({{0, 1, 1}})}));
  const Camera first = camera_for(*scene);
  Camera second = first;
  second.world_from_camera[3] += glm::dvec4(0.3, 0.2, -1.0, 0.0);
  const auto picture = [](const Camera& camera, double width) {
    return line_picture(camera, settings_of(width));
  };
  const auto once = with_lines(scene, picture(first, 1.0)).value();
  const auto other = with_lines(once, picture(second, 4.0)).value();
  const auto again = with_lines(other, picture(first, 1.0)).value();
  EXPECT_NE(other->world().positions, once->world().positions);
  EXPECT_EQ(again->world().positions, once->world().positions);
  EXPECT_EQ(again->world().triangles, once->world().triangles);
  EXPECT_EQ(again->world().triangle_part, once->world().triangle_part);
  EXPECT_EQ(again->world().colors, once->world().colors);
  const auto none = with_lines(again, picture(first, 0.0)).value();
  EXPECT_EQ(none->world().positions, scene->world().positions);
  EXPECT_EQ(none->world().bounds.lo, scene->world().bounds.lo);
  EXPECT_EQ(none->world().bounds.hi, scene->world().bounds.hi);
}

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
  Texture texture;
  texture.image = 0;
  texture.filter = Filter::nearest;
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

TEST(WithLines, LinesThroughTheCameraAndWithoutLengthAreHarmless) {
  const auto scene = prepared(scene_of({square(1.0f, 0.0f),
                                        lines({{0, 0, 20},
                                               {0, 0, -20},  // along the view
                                               {0.1f, 0, 20},
                                               {0, 0.1f, -20},  // past the eye
                                               {0, 0, 5},
                                               {0, 1, 5},  // at the eye
                                               {0.5f, 0.5f, 1},
                                               {0.5f, 0.5f, 1}}),
                                        points({{0, 0, 5}, {0, 0, 9}})}));
  const Camera camera = camera_for(*scene);
  const auto drawn = with_lines(scene, line_picture(camera, settings_of(2.0))).value();
  for (const glm::vec3 p : drawn->world().positions)
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  const Film film = render_picture(*drawn, camera, settings_of(2.0)).film;
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x < film.width; ++x) EXPECT_TRUE(std::isfinite(at(film, x, y).r));
}

TEST(WithLines, WhatIsNotFiniteIsRefused) {
  Scene scene = scene_of({lines({{0, 0, 0}, {1, 0, 0}})});
  scene.instances[0].world_from_mesh[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(prepare(scene));
  scene.instances[0].world_from_mesh[3].x = 1e300;
  scene.meshes.push_back(square(1.0f, 0.0f));
  scene.instances.push_back({"wall", 1, glm::dmat4(1.0)});
  EXPECT_FALSE(prepare(scene));
}

TEST(WithLines, ASceneOfLinesAloneIsFramed) {
  const auto scene = prepared(scene_of({lines({{100, 7, 3}, {104, 9, 3}})}));
  const Camera camera = first_camera(scene->world(), 4.0 / 3.0);
  EXPECT_GT(red_area(picture_of(scene, camera, settings_of(2.0))), 2.0 * 40.0);
}

}  // namespace
}  // namespace asos::test::with_strokes_test
