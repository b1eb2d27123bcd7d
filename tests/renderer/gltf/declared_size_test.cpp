#include "renderer/gltf/declared_size.h"

#include "renderer/load_progress.h"
#include "tests/renderer/gltf/moving_file.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

// The bounding box that is shown while a file is decoded.

namespace asos::test::declared_size_test {
namespace {

using nlohmann::json;

/// The preview of a file; stops the test if it cannot be read.
std::optional<ScenePreview> preview_of(const GltfBuilder& b) {
  const TemporaryFolder folder;
  gltf::Document doc = gltf::read_document(folder.write("test.glb", b.glb())).value();
  gltf::Accessors accessors(doc);
  return gltf::declared_size(doc, accessors, gltf::poses_at_rest(doc), 0);
}

/// A square whose positions declare their bounds.
GltfBuilder bounded_square() {
  GltfBuilder b = GltfBuilder::square();
  b.json["accessors"][0]["min"] = {0, 0, 0};
  b.json["accessors"][0]["max"] = {1, 1, 0};
  return b;
}

TEST(DeclaredSize, IsOfTheNodesInTheWorld) {
  GltfBuilder b = bounded_square();
  b.json["nodes"] = {{{"mesh", 0}, {"translation", {10, 0, 0}}, {"scale", {2, 3, 1}}},
                     {{"mesh", 0}, {"translation", {0, 0, -5}}}};
  b.json["scenes"][0]["nodes"] = {0, 1};
  const auto preview = preview_of(b);
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->lo, glm::dvec3(0, 0, -5));
  EXPECT_EQ(preview->hi, glm::dvec3(12, 3, 0));
  EXPECT_FALSE(preview->camera);
}

TEST(DeclaredSize, HasTheFirstCamera) {
  GltfBuilder b = bounded_square();
  b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
  b.json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 7}}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  const auto preview = preview_of(b);
  ASSERT_TRUE(preview && preview->camera);
  EXPECT_EQ(preview->camera->world_from_camera[3], glm::dvec4(0, 0, 7, 1));
  EXPECT_EQ(preview->camera->fov_y_rad, 0.5);
}

TEST(DeclaredSize, LeavesOutUnusableBounds) {
  EXPECT_FALSE(preview_of(GltfBuilder::square())) << "none are declared";
  // The square lies in z = 0, so each axis needs a case of its own.
  for (const json& most : {json{-1, 1, 0}, json{1, -1, 0}, json{1, 1, -1}, json{1, 1},
                           json{1e300, 1, 0}, json{0, 0, 0}}) {
    GltfBuilder b = bounded_square();
    b.json["accessors"][0]["max"] = most;
    EXPECT_FALSE(preview_of(b)) << most.dump();
  }
  GltfBuilder b = bounded_square();
  b.json["accessors"][0]["max"] = {9, -1, 0};
  const int p = b.vec3({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  b.json["accessors"][static_cast<std::size_t>(p)]["min"] = {0, 0, 0};
  b.json["accessors"][static_cast<std::size_t>(p)]["max"] = {4, 4, 0};
  b.primitive({{"POSITION", p}});
  const auto preview = preview_of(b);
  ASSERT_TRUE(preview) << "another primitive has bounds";
  EXPECT_EQ(preview->hi, glm::dvec3(4, 4, 0));
}

TEST(DeclaredSize, DividesNormalizedBounds) {
  GltfBuilder b = bounded_square();
  b.json["accessors"][0]["componentType"] = 5123;
  b.json["accessors"][0]["normalized"] = true;
  b.json["accessors"][0]["max"] = {65535, 0, 0};
  const auto preview = preview_of(b);
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->hi, glm::dvec3(1, 0, 0));
}

TEST(DeclaredSize, CountsInstancesAndInvisibleNodes) {
  GltfBuilder b = bounded_square();
  b.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing", "KHR_node_visibility"};
  const int at = b.vec3({{0, 0, 0}, {8, 0, 0}});
  b.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = at;
  b.json["nodes"].push_back({{"mesh", 0},
                             {"translation", {0, 50, 0}},
                             {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  const auto preview = preview_of(b);
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->hi, glm::dvec3(9, 1, 0));
}

TEST(DeclaredSize, FollowsTheFirstJointOfASkin) {
  GltfBuilder b = bounded_square();
  const int joints = b.accessor(b.view(std::vector<std::uint8_t>(16, 0)), 5121, "VEC4", 4);
  const int weights = b.vec4(std::vector<glm::vec4>(4, glm::vec4(1, 0, 0, 0)));
  b.json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = joints;
  b.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = weights;
  b.node()["skin"] = 0;
  b.node()["translation"] = {100, 0, 0};  // has no effect, since the mesh is skinned
  b.json["nodes"].push_back({{"translation", {0, 0, 3}}});
  b.json["skins"] = {{{"joints", {1}}}};
  b.json["scenes"][0]["nodes"] = {0, 1};
  const auto preview = preview_of(b);
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->hi, glm::dvec3(1, 1, 3));
}

// A progress receives the box before any geometry is decoded, and no warning comes twice.
TEST(DeclaredSize, IsPublishedBeforeDecoding) {
  GltfBuilder b = bounded_square();
  // Not of unit length, which gives a warning wherever it is read.
  const int rotations = b.vec4({{0, 0, 0, 2}});
  b.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  b.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["ROTATION"] = rotations;
  const TemporaryFolder folder;
  const std::string path = folder.write("test.glb", b.glb());
  const std::vector<std::string> usual = import_gltf(path).value().notes.warnings;
  ASSERT_EQ(usual.size(), 1u);

  std::optional<LoadStage> published;
  LoadProgress* watched = nullptr;
  LoadProgress progress([&] {
    if (!published && watched->preview()) published = watched->stage();
  });
  watched = &progress;
  const LoadProgress::Scope scope(&progress);
  const Result<Scene> scene = import_gltf(path);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->notes.warnings, usual);
  ASSERT_TRUE(published);
  EXPECT_EQ(*published, LoadStage::reading);
  EXPECT_EQ(progress.preview()->hi, glm::dvec3(1, 1, 0));
}

}  // namespace
}  // namespace asos::test::declared_size_test
