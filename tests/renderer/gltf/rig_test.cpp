#include "renderer/scene/posable_scene.h"
#include "renderer/scene/scene_warnings.h"
#include "tests/renderer/gltf/moving_file.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace asos::test::rig_test {
namespace {

void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance = 1e-6) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Position of the square's first corner, which is at the origin at rest, under a translation with
/// these keys.
glm::dvec3 moved(const std::string& interpolation, const std::vector<float>& times,
                 const std::vector<glm::vec3>& values, double seconds) {
  GltfBuilder b = GltfBuilder::square();
  add_channel(b, 0, "translation", b.scalars(times), b.vec3(values), interpolation);
  return world_vertex(posed(with_rig(b), seconds), 0);
}

TEST(PosableScene, InterpolatesBetweenKeysAsTheySay) {
  const std::vector<float> times{1, 3};
  const std::vector<glm::vec3> values{{0, 0, 0}, {4, 8, -2}};
  expect_near(moved("LINEAR", times, values, 1.5), {1, 2, -0.5});
  expect_near(moved("STEP", times, values, 2.999), {0, 0, 0});
  expect_near(moved("STEP", times, values, 3.0), {4, 8, -2});
  for (const char* interpolation : {"LINEAR", "STEP"}) {
    expect_near(moved(interpolation, times, values, 0.0), {0, 0, 0});
    expect_near(moved(interpolation, times, values, 99.0), {4, 8, -2});
  }
}

// Hermite's polynomial through p and q with slopes m and n over a span d: p + m x + (3 (q - p) / d
// - 2 m - n) x^2 / d + (2 (p - q) / d + m + n) x^3 / d^2.
TEST(PosableScene, SplinesAreHermites) {
  const double p = 1, m = -3, q = 5, n = 7, d = 2;
  const std::vector<glm::vec3> values{{99, 0, 0}, {p, 0, 0}, {m, 0, 0},
                                      {n, 0, 0},  {q, 0, 0}, {99, 0, 0}};
  for (const double x : {0.0, 0.3, 1.0, 1.9, 2.0}) {
    const double c = (3 * (q - p) / d - 2 * m - n) / d;
    const double e = (2 * (p - q) / d + m + n) / (d * d);
    EXPECT_NEAR(moved("CUBICSPLINE", {4, 6}, values, 4 + x).x,
                p + m * x + c * x * x + e * x * x * x, 1e-6)
        << x;
  }
}

TEST(PosableScene, TurnsAlongTheShorterArcAtAnEvenSpeed) {
  for (const bool opposite : {false, true}) {
    GltfBuilder b = GltfBuilder::square();
    // A quaternion and its negative are the same rotation.
    const glm::vec4 end = opposite ? -about_z(90) : about_z(90);
    add_channel(b, 0, "rotation", b.scalars({0, 3}), b.vec4({about_z(0), end}));
    const Scene scene = with_rig(b);
    for (const double seconds : {0.5, 1.0, 1.5, 3.0}) {
      const double angle = seconds * std::numbers::pi / 6.0;
      expect_near(world_vertex(posed(scene, seconds), 1), {std::cos(angle), std::sin(angle), 0});
    }
  }
}

TEST(PosableScene, SplinesOfRotationsComeOutAsUnits) {
  GltfBuilder b = GltfBuilder::square();
  const glm::vec4 none(0);
  add_channel(b, 0, "rotation", b.scalars({0, 1}),
              b.vec4({none, about_z(0), none, none, about_z(120), none}), "CUBICSPLINE");
  const double h = std::numbers::pi / 6.0;  // halfway: the bisector
  expect_near(world_vertex(posed(with_rig(b), 0.5), 1), {std::cos(2 * h), std::sin(2 * h), 0});
}

TEST(PosableScene, ReadsNormalisedIntegers) {
  GltfBuilder b = GltfBuilder::square();
  const float s = std::sqrt(0.5f) * 32767.0f;
  const auto half = static_cast<std::int16_t>(std::lround(s));
  const std::vector<glm::i16vec4> turned{{0, 0, 0, 32767}, {0, 0, half, half}};
  add_channel(b, 0, "rotation", b.scalars({0, 1}),
              b.accessor(b.view(turned), 5122, "VEC4", 2, true));
  expect_near(world_vertex(posed(with_rig(b), 1), 1), {0, 1, 0}, 1e-4);

  GltfBuilder m = GltfBuilder::square();
  m.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", m.vec3(std::vector<glm::vec3>(4, {0, 0, 2}))}}};
  const std::vector<std::uint8_t> weights{0, 51};
  add_channel(m, 0, "weights", m.scalars({0, 1}),
              m.accessor(m.view(weights), 5121, "SCALAR", 2, true));
  EXPECT_NEAR(world_vertex(posed(with_rig(m), 1), 0).z, 0.4, 1e-6);
}

// A morph target may be quantised or sparse, and may change normals.
TEST(PosableScene, MorphsPositionsAndNormals) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const int bytes =
      b.accessor(b.view(std::vector<glm::i8vec4>(4, {0, 0, 127, 0})), 5120, "VEC3", 4, true);
  b.json["bufferViews"].back()["byteStride"] = 4;
  const int sparse = b.accessor(-1, 5126, "VEC3", 4);
  b.json["accessors"][sparse]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", b.view(std::vector<std::uint16_t>{2})}, {"componentType", 5123}}},
      {"values", {{"bufferView", b.view(std::vector<glm::vec3>{{4, 0, 0}})}}}};
  const int normals = b.vec3(std::vector<glm::vec3>(4, {1, 0, -1}));
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", bytes}},
                                                     {{"POSITION", sparse}, {"NORMAL", normals}}};
  add_channel(b, 0, "weights", b.scalars({0, 1}), b.scalars({0, 0, 1, 1}));
  const Scene scene = with_rig(b);
  const Scene half = posed(scene, 0.5);
  expect_near(world_vertex(half, 0), {0, 0, 0.5});
  expect_near(world_vertex(half, 2), {3, 1, 0.5});
  expect_near(half.meshes[0].normals[0], glm::normalize(glm::dvec3(0.5, 0, 0.5)));
  expect_near(world_vertex(posed(scene, 1), 2), {5, 1, 1});
  expect_near(world_vertex(scene, 2), {1, 1, 0});
}

/// An arm of two joints along x, from 0 over the elbow at 1 to the hand at 2. The elbow bends by 90
/// degrees in one second. Vertices: shoulder, elbow (both joints), hand.
GltfBuilder arm(float elbow_weights = 0.5f) {
  GltfBuilder b;
  const int positions = b.vec3({{0, 0, 0}, {1, 0.5, 0}, {2, 0, 0}});
  const int normals = b.vec3(std::vector<glm::vec3>(3, {0, 1, 0}));
  auto& primitive = b.primitive({{"POSITION", positions}, {"NORMAL", normals}});
  primitive["attributes"]["JOINTS_0"] = b.accessor(
      b.view(std::vector<glm::u8vec4>{{0, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}}), 5121, "VEC4", 3);
  const float w = elbow_weights;
  primitive["attributes"]["WEIGHTS_0"] = b.vec4({{1, 0, 0, 0}, {w, w, 0, 0}, {1, 0, 0, 0}});
  b.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {50, 0, 0}}},
                     {{"children", {2}}, {"name", "upper"}},
                     {{"translation", {1, 0, 0}}, {"name", "lower"}}};
  b.json["scenes"][0]["nodes"] = {0, 1};
  glm::mat4 from_elbow(1.0f);
  from_elbow[3] = {-1, 0, 0, 1};
  b.json["skins"] = {{{"joints", {1, 2}},
                      {"name", "arm"},
                      {"inverseBindMatrices", b.mat4({glm::mat4(1.0f), from_elbow})}}};
  add_channel(b, 2, "rotation", b.scalars({0, 1}), b.vec4({about_z(0), about_z(90)}));
  return b;
}

TEST(PosableScene, BendsAnArmAtItsElbow) {
  for (const float weights : {0.5f, 1.0f}) {  // weights are normalised to a sum of 1
    const Scene bent = posed(with_rig(arm(weights)), 1.0);
    expect_near(world_vertex(bent, 0), {0, 0, 0});
    // Half of (1, 0.5) and half of (0.5, 0), the elbow's result.
    expect_near(world_vertex(bent, 1), {0.75, 0.25, 0});
    expect_near(world_vertex(bent, 2), {1, 1, 0});
    expect_near(bent.meshes[0].normals[2], {-1, 0, 0});
  }
  const Scene half = posed(with_rig(arm()), 0.5);
  expect_near(world_vertex(half, 2), {1 + std::sqrt(0.5), std::sqrt(0.5), 0});
}

// The second node comes later, and has the mesh without the skin.
TEST(PosableScene, ASkinDoesNotPoseAnotherNodeOfItsMesh) {
  GltfBuilder b = arm();
  for (int k = 0; k < 4; ++k) b.json["nodes"][2]["rotation"][k] = about_z(-90)[k];
  b.json["nodes"].push_back({{"mesh", 0}});
  b.json["scenes"][0]["nodes"].push_back(3);
  const Scene scene = with_rig(b);
  ASSERT_EQ(scene.instances.size(), 2u);
  expect_near(world_vertex(scene, 2, 0), {1, -1, 0});
  expect_near(world_vertex(scene, 2, 1), {2, 0, 0});
}

TEST(PosableScene, AtRestTheFilesNodesPoseASkin) {
  GltfBuilder b = arm();
  for (int k = 0; k < 4; ++k) b.json["nodes"][2]["rotation"][k] = about_z(-90)[k];
  const Scene scene = with_rig(b);
  EXPECT_FALSE(scene.time.has_value());
  expect_near(world_vertex(scene, 2), {1, -1, 0});
  // The pose at rest is the same after a pose at another time.
  (void)posed(scene, 1.0);
  expect_near(world_vertex(scene.rig->pose(std::nullopt).value(), 2), {1, -1, 0});
}

// A joint stretched by (2, 1, 1) maps the plane x = y to x = 2y: its normal is (1, -2)/sqrt(5).
TEST(PosableScene, NormalsOfSkinsStaySquareToTheirSurface) {
  GltfBuilder b = arm();
  const float s = std::sqrt(0.5f);
  b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      b.vec3(std::vector<glm::vec3>(3, {s, -s, 0}));
  add_channel(b, 1, "scale", b.scalars({0, 1}), b.vec3({{1, 1, 1}, {2, 1, 1}}));
  const Scene stretched = posed(with_rig(b), 1.0);
  expect_near(stretched.meshes[0].normals[0], glm::normalize(glm::dvec3(1, -2, 0)));
}

bool same(const Scene& a, const Scene& b) {
  const auto same_mesh = [](const Mesh& m, const Mesh& n) {
    return m.positions == n.positions && m.normals == n.normals && m.triangles == n.triangles;
  };
  const auto same_instance = [](const Instance& m, const Instance& n) {
    return m.mesh == n.mesh && m.world_from_mesh == n.world_from_mesh;
  };
  return std::ranges::equal(a.meshes, b.meshes, same_mesh) &&
         std::ranges::equal(a.instances, b.instances, same_instance) && a.time == b.time;
}

TEST(PosableScene, APoseIsTheSameWhateverWasAskedForBefore) {
  GltfBuilder b = arm();
  b.json["meshes"].push_back(GltfBuilder::square().json["meshes"][0]);
  b.json["meshes"][1]["primitives"][0] = {
      {"attributes", {{"POSITION", b.vec3({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}})}}}};
  b.json["nodes"].push_back({{"mesh", 1}, {"name", "still"}});
  b.json["scenes"][0]["nodes"] = {3, 0, 1};
  const Scene scene = with_rig(b);
  const Scene at_once = posed(scene, 0.7);
  for (const double seconds : {0.1, 1.0, 0.0}) EXPECT_FALSE(same(posed(scene, seconds), at_once));
  EXPECT_TRUE(same(posed(scene, 0.7), at_once));
  EXPECT_TRUE(same(posed(with_rig(b), 0.7), at_once));
  EXPECT_EQ(at_once.instances.size(), 2u);
  EXPECT_EQ(at_once.meshes[0].positions.size(), 3u);
}

TEST(PosableScene, CamerasAndLightsMoveWithTheirNodes) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_lights_punctual"};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
  b.json["nodes"].push_back(
      {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  add_channel(b, 1, "translation", b.scalars({0, 2}), b.vec3({{0, 0, 0}, {6, 0, 2}}));
  const Scene scene = posed(with_rig(b), 1.0);
  expect_near(scene.cameras.at(0).world_from_camera[3], {3, 0, 1});
  expect_near(scene.lights.at(0).position, {3, 0, 1});
}

TEST(PosableScene, PointersMoveNodes) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = {"KHR_animation_pointer"};
  add_channel(b, 0, "pointer", b.scalars({0, 1}), b.vec3({{0, 0, 0}, {2, 0, 0}}));
  add_channel(b, 0, "pointer", b.scalars({0, 1}), b.scalars({0, 1}));
  const char* pointers[] = {"/nodes/0/translation", "/materials/0/alphaCutoff"};
  for (int i = 0; i < 2; ++i)
    b.json["animations"][0]["channels"][i]["target"] = {
        {"path", "pointer"},
        {"extensions", {{"KHR_animation_pointer", {{"pointer", pointers[i]}}}}}};
  const Scene scene = with_rig(b);
  expect_near(world_vertex(posed(scene, 0.5), 0), {1, 0, 0});
  EXPECT_EQ(scene.contents.animations.at(0).channels, 2u);
  EXPECT_EQ(scene.contents.animations.at(0).moving, 1u);
  const std::string wanted =
      "animation 0, channel 1: it moves /materials/0/alphaCutoff, which "
      "the file does not have; that stays as the file has it";
  EXPECT_EQ(std::ranges::count(scene_warnings(scene.notes), wanted), 1);
}

TEST(PosableScene, TellsWhatMovesAndWhatThereIsAChoiceOf) {
  GltfBuilder b = arm();
  b.json["animations"][0]["name"] = "Wave\n";
  b.json["scenes"].push_back({{"nodes", {0}}, {"name", "other"}});
  b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
  b.json["extensionsUsed"] = {"KHR_materials_variants"};
  b.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "red"}}};
  const Scene scene = with_rig(b);
  const SceneContents& c = scene.contents;
  ASSERT_EQ(c.animations.size(), 1u);
  EXPECT_EQ(c.animations[0].seconds, 1.0);
  ASSERT_EQ(c.skins.size(), 1u);
  EXPECT_EQ(c.skins[0].name, "arm");
  EXPECT_EQ(c.skins[0].joints, 2u);
  EXPECT_EQ(c.scenes.size(), 2u);
  EXPECT_EQ(c.shown_scene, 0);
  EXPECT_EQ(c.variants, std::vector<std::string>{"red"});
  EXPECT_EQ(c.cameras_not_placed, 1u);

  const std::vector<std::string> said = scene_warnings(scene.notes);
  for (const char* line :
       {"1 animation is not played: 'Wave\\n'; everything stands where the file's nodes place it",
        "1 other scene of the file is not shown: 'other'; the picture is of scene 0 (--scene "
        "shows another)",
        "1 camera is in no node that is shown and cannot be looked through",
        "1 variant is not shown: 'red'; materials are as without (--variant shows one)"})
    EXPECT_EQ(std::ranges::count(said, line), 1) << line;
  // With a time given, the animation is played.
  for (const std::string& line : scene_warnings(posed(scene, 0.5).notes))
    EXPECT_EQ(line.find("not played"), std::string::npos) << line;
}

TEST(PosableScene, RefusesTimesThatThereAreNot) {
  const Scene scene = with_rig(arm());
  const double endless = std::numeric_limits<double>::infinity();
  for (const ClipTime time :
       {ClipTime{1, 0.0}, ClipTime{-1, 0.0}, ClipTime{0, -0.1}, ClipTime{0, endless},
        ClipTime{0, std::numeric_limits<double>::quiet_NaN()}}) {
    const Result<Scene> pose = scene.rig->pose(time);
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error().subject, scene.source);
    EXPECT_FALSE(pose.error().reason.empty());
  }
}

TEST(PosableScene, IsKeptOnlyWhereItIsAskedForAndSomethingMoves) {
  EXPECT_EQ(with_rig(GltfBuilder::square()).rig, nullptr);
  const TemporaryFolder folder;
  EXPECT_EQ(import_gltf(folder.write("a.glb", arm().glb()))->rig, nullptr);
  EXPECT_NE(with_rig(arm()).rig, nullptr);
}

// Playing requests any number of poses.
TEST(PosableScene, DataThatTheFileDoesNotHaveDoesNotRunOut) {
  GltfBuilder b = GltfBuilder::square();
  // So many zeros that they may be read once, but not twice.
  const int zeros = b.accessor(-1, 5126, "VEC3", 30000);
  b.json["meshes"].push_back(
      {{"primitives",
        {{{"attributes", {{"POSITION", zeros}}}, {"targets", {{{"POSITION", zeros}}}}}}}});
  b.json["nodes"].push_back({{"mesh", 1}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  add_channel(b, 1, "weights", b.scalars({0, 1}), b.scalars({0.5f, 1}));
  const Scene scene = with_rig(b);
  for (int i = 0; i < 4; ++i) {
    const Scene moved = posed(scene, 0.25 * i);
    EXPECT_EQ(moved.notes.warnings, scene.notes.warnings);
    EXPECT_EQ(moved.instances.size(), 2u);
  }
}

TEST(PosableScene, PosesFilesThatOthersMade) {
  const auto dir = shared_dir();
  if (!dir) GTEST_SKIP() << "there is no folder with models to test on";
  const auto path = *dir / "scenes" / "Fox";
  const auto file = [&] {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path))
      if (const auto e = entry.path().extension(); e == ".gltf" || e == ".glb") return entry.path();
    return path;
  }();
  const Result<Scene> fox = import_gltf(file.string(), {.keep_posable = true});
  ASSERT_TRUE(fox) << fox.error().message();
  ASSERT_EQ(fox->contents.animations.size(), 3u);
  EXPECT_EQ(fox->contents.animations[1].name, "Walk");
  for (int animation = 0; animation < 3; ++animation) {
    const Scene moved = posed(*fox, 0.5, animation);
    EXPECT_EQ(moved.instanced_triangles(), fox->instanced_triangles());
    EXPECT_FALSE(same(moved, *fox));
    for (const glm::vec3 n : moved.meshes[0].normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
  }
}

}  // namespace
}  // namespace asos::test::rig_test
