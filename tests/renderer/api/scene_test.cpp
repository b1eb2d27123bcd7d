#include "tests/renderer/api/api_scenes.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <vector>

namespace asos::api {
namespace {

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

template <typename T>
void expect_invalid(const Result<T>& result, const std::string& words) {
  ASSERT_FALSE(result.has_value()) << words;
  EXPECT_EQ(result.error().code, ErrorCode::invalid_argument) << result.error().message();
  EXPECT_NE(result.error().message().find(words), std::string::npos) << result.error().message();
}

/// A builder with material 0, and a mesh that is valid.
struct Meshes : ::testing::Test {
  Meshes() {
    EXPECT_EQ(builder.add_material({}).value(), 0);
    mesh.name = "patch";
    mesh.positions = positions;
    mesh.triangles = triangles;
  }
  SceneBuilder builder;
  std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::vector<std::uint32_t> triangles{0, 1, 2};
  MeshData mesh;
};
using ApiSceneBuilder = Meshes;

TEST_F(ApiSceneBuilder, NumbersMeshesInOrder) {
  EXPECT_EQ(builder.add_mesh(mesh, 0).value(), 0);
  EXPECT_EQ(builder.add_mesh(mesh, 0).value(), 1);
  ASSERT_TRUE(builder.place_mesh(1));
  ASSERT_TRUE(builder.place_mesh(1, translation({0, 0, 2})));
  EXPECT_EQ(builder.build()->triangles(), 2u);
}

TEST_F(ApiSceneBuilder, RefusesBrokenArrays) {
  const auto refused = [&](const std::string& words) {
    expect_invalid(builder.add_mesh(mesh, 0), words);
  };
  mesh.positions = std::span(positions).first(8);
  refused("positions");
  mesh.positions = {};
  refused("triangle 0");
  positions[4] = nan_value;
  mesh.positions = positions;
  refused("positions");
  positions[4] = 1e30f;
  refused("farther");
  positions[4] = 0.0f;
  triangles[2] = 3;
  refused("triangle 0");
  triangles[2] = 2;
  mesh.triangles = std::span(triangles).first(2);
  refused("triangles");
  mesh.triangles = triangles;
  std::vector<float> normals{0, 0, 1, 0, 0, 1, 0, 0, 0};
  mesh.normals = std::span(normals).first(6);
  refused("normals");
  mesh.normals = normals;
  refused("length 0");
  normals[8] = 1;
  const std::vector<float> colors(8, 1.0f);
  mesh.colors = colors;
  refused("colors");
  for (const float value : {-1.0f, 1.5f, 1e30f}) {
    std::vector<float> odd(12, 1.0f);
    odd[7] = value;
    mesh.colors = odd;
    refused("not from 0 to 1");
  }
  mesh.colors = {};
  mesh.texcoords = colors;
  refused("texcoords");
  mesh.texcoords = {};
  expect_invalid(builder.add_mesh(mesh, 1), "material 1");
  EXPECT_EQ(builder.add_mesh(mesh, 0).value(), 0) << "nothing was added before";
}

TEST_F(ApiSceneBuilder, RefusesWhatDoesNotExist) {
  expect_invalid(builder.place_mesh(0), "mesh 0");
  expect_invalid(builder.place_shape({}, 7), "material 7");
  Material textured;
  textured.base_color_image = 0;
  expect_invalid(builder.add_material(textured), "image 0");
  const std::vector<std::uint8_t> bytes(16, 255);
  expect_invalid(builder.add_image(2, 3, bytes), "2x3");
  expect_invalid(builder.add_image(0, 3, bytes), "0x3");
  EXPECT_EQ(builder.add_image(2, 2, bytes).value(), 0);
  EXPECT_EQ(builder.add_material(textured).value(), 1);
}

TEST_F(ApiSceneBuilder, RefusesValuesOutOfRange) {
  Material material{.name = "paint", .roughness = 1.5f};
  expect_invalid(builder.add_material(material), "'paint': roughness 1.5 is not from 0 to 1");
  material = {};
  material.emissive[1] = nan_value;
  expect_invalid(builder.add_material(material), "emissive");
  Shape shape{.radius = 0.0};
  expect_invalid(builder.place_shape(shape, 0), "shape");
  Matrix4 matrix = identity;
  matrix[12] = std::numeric_limits<double>::infinity();
  expect_invalid(builder.place_shape({}, 0, matrix, "ball"), "'ball': its matrix is not affine");
  Light light{.name = "lamp", .intensity = -1.0f};
  expect_invalid(builder.add_light(light), "light 'lamp'");
  light.intensity = 1.0f;
  light.type = LightType::spot;
  light.direction = {0, 0, 0};
  expect_invalid(builder.add_light(light), "direction");
  light.type = static_cast<LightType>(17);
  light.direction = {0, 0, 5};
  expect_invalid(builder.add_light(light), "unknown type");
  Camera camera{.fov_y_rad = 4.0};
  expect_invalid(builder.add_camera(camera), "camera");
}

void expect_finite(const Scene& scene) {
  for (const Settings& settings : {test::small_settings(8, 8), Settings{.width = 8, .height = 8}}) {
    const Result<Picture> picture = render(scene, scene.default_camera(1.0), settings);
    ASSERT_TRUE(picture) << picture.error().message();
    const Result<Layer> beauty = picture->layer("beauty");
    ASSERT_TRUE(beauty) << beauty.error().message();
    ASSERT_FALSE(beauty->values.empty());
    for (const float value : beauty->values) ASSERT_TRUE(std::isfinite(value));
  }
}

TEST_F(ApiSceneBuilder, RendersSceneWithoutSurfaces) {
  const Result<Scene> empty = SceneBuilder().build();
  ASSERT_TRUE(empty) << empty.error().message();
  EXPECT_EQ(empty->triangles(), 0u);
  expect_finite(*empty);
}

TEST_F(ApiSceneBuilder, RendersDegenerateGeometry) {
  triangles = {0, 1, 1, 2, 2, 2, 0, 1, 2};
  mesh.triangles = triangles;
  const Matrix4 flat{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  Matrix4 nothing{};
  nothing[15] = 1;
  ASSERT_EQ(builder.add_mesh(mesh, 0).value(), 0);
  for (const Matrix4& matrix : {identity, flat, nothing}) {
    ASSERT_TRUE(builder.place_mesh(0, matrix));
    ASSERT_TRUE(builder.place_shape({}, 0, matrix));
  }
  const Result<Scene> scene = builder.build();
  ASSERT_TRUE(scene) << scene.error().message();
  expect_finite(*scene);
}

TEST(ApiScene, LoadsBuiltInScenes) {
  const Result<Scene> boxes = Scene::load("builtin:boxes");
  ASSERT_TRUE(boxes) << boxes.error().message();
  EXPECT_GT(boxes->triangles(), 0u);
  EXPECT_FALSE(boxes->name().empty());
}

TEST(ApiScene, NamesFileThatCannotBeOpened) {
  const asos::test::TemporaryFolder folder;
  const std::string path = folder.file("broken.glb");
  for (const bool exists : {false, true}) {
    if (exists) std::ofstream(path) << "no glTF";
    const Result<Scene> scene = Scene::load(path);
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::cannot_open);
    EXPECT_EQ(scene.error().subject, path);
    EXPECT_FALSE(scene.error().reason.empty());
  }
}

TEST(ApiScene, KeepsCamerasInAuthorsCoordinates) {
  const Result<Scene> ball = test::lit_ball();
  ASSERT_TRUE(ball) << ball.error().message();
  ASSERT_EQ(ball->cameras().size(), 1u);
  const Camera camera = ball->default_camera(1.0);
  EXPECT_NEAR(camera.world_from_camera[12], 1002.0, 1e-9);
  EXPECT_NEAR(camera.world_from_camera[13], 2.0, 1e-9);
  EXPECT_NEAR(camera.world_from_camera[14], 4.0, 1e-9);
}

TEST(ApiScene, FramesSceneWithoutCamera) {
  const Result<Scene> square = test::white_square(100, 0, 1);
  ASSERT_TRUE(square) << square.error().message();
  for (const double aspect : {1.5, 0.0, -1.0, std::nan("")})
    EXPECT_NEAR(square->default_camera(aspect).world_from_camera[12], 100.0, 3.0);
}

TEST(ApiError, EscapesControlCharacters) {
  EXPECT_EQ((Error{ErrorCode::internal, "a\nb", "c"}.message().find('\n')), std::string::npos);
}

TEST(ApiVersion, HasThreeNumbers) {
  int numbers[3] = {-1, -1, -1};
  EXPECT_EQ(std::sscanf(version(), "%d.%d.%d", numbers, numbers + 1, numbers + 2), 3);
}

TEST(ApiScene, LoadsAMomentOfAnAnimation) {
  const asos::test::TemporaryFolder folder;
  const std::string path = folder.write("slide.gltf", test::moving_triangle());
  const Result<Scene> at_rest = Scene::load(path);
  ASSERT_TRUE(at_rest) << at_rest.error().message();
  ASSERT_EQ(at_rest->animations().size(), 1u);
  EXPECT_EQ(at_rest->animations()[0].name, "slide");
  EXPECT_EQ(at_rest->animations()[0].seconds, 2.0);
  // The default camera frames the triangle where it is.
  const double x = at_rest->default_camera(1.0).world_from_camera[12];
  LoadOptions options;
  options.seconds = 1.5;
  for (const char* animation : {"", "slide", "0"}) {
    options.animation = animation;
    const Result<Scene> moved = Scene::load(path, options);
    ASSERT_TRUE(moved) << moved.error().message();
    EXPECT_NEAR(moved->default_camera(1.0).world_from_camera[12], x + 3.0, 1e-5);
  }
}

TEST(ApiScene, RefusesTimesThatThereAreNot) {
  const asos::test::TemporaryFolder folder;
  const std::string path = folder.write("slide.gltf", test::moving_triangle());
  LoadOptions options;
  options.seconds = -1.0;
  expect_invalid(Scene::load(path, options), "seconds");
  options.seconds = std::numeric_limits<double>::quiet_NaN();
  expect_invalid(Scene::load(path, options), "seconds");
  options.seconds = 1.0;
  options.animation = "jump";
  expect_invalid(Scene::load(path, options), "jump");
  options.animation.clear();
  expect_invalid(Scene::load("builtin:boxes", options), "no animations");
}

}  // namespace
}  // namespace asos::api
