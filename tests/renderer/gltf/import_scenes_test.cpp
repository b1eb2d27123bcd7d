#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

#include <string>

// Files with several scenes: LoadOptions::scene.

namespace asos {
namespace {

using test::GltfBuilder;

/// Scenes of one, two and three squares; the second is the file's default.
GltfBuilder three_scenes() {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 5}}});
  b.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 9}}});
  b.json["scenes"] = {{{"nodes", {0}}},
                      {{"nodes", {0, 1}}, {"name", "pair"}},
                      {{"nodes", {0, 1, 2}}, {"name", "1"}}};
  b.json["scene"] = 1;
  return b;
}

Result<Scene> import_scene(const std::string& wanted, const GltfBuilder& b = three_scenes()) {
  const test::TemporaryFolder folder;
  return import_gltf(folder.write("rooms.glb", b.glb()), {.scene = wanted});
}

std::string refusal(const std::string& wanted, const GltfBuilder& b = three_scenes()) {
  const Result<Scene> scene = import_scene(wanted, b);
  return scene ? "" : scene.error().message();
}

TEST(ImportScenes, AreChosenByNumberOrName) {
  const auto squares = [](const std::string& wanted) {
    const Result<Scene> scene = import_scene(wanted);
    EXPECT_TRUE(scene) << scene.error().message();
    EXPECT_EQ(scene->contents.default_scene, 1);
    EXPECT_EQ(scene->instances.size(), static_cast<std::size_t>(scene->contents.shown_scene) + 1);
    return scene->instances.size();
  };
  EXPECT_EQ(squares(""), 2u);
  EXPECT_EQ(squares("0"), 1u);
  EXPECT_EQ(squares("pair"), 2u);
  EXPECT_EQ(squares("2"), 3u);
  EXPECT_EQ(squares("1"), 2u) << "numbers take precedence over names";
}

TEST(ImportScenes, UnknownOnesAreRefusedWithThoseThatThereAre) {
  EXPECT_NE(refusal("3").find("rooms.glb"), std::string::npos);
  for (const char* wanted : {"3", "-1", "Pair", "1.0", "99999999999999999999", " 1"})
    EXPECT_NE(refusal(wanted).find(std::string("no scene '") + wanted +
                                   "'; there are 0, 1 ('pair'), 2 ('1')"),
              std::string::npos)
        << refusal(wanted);
  GltfBuilder bare = GltfBuilder::square();
  bare.json.erase("scenes");
  bare.json.erase("scene");
  EXPECT_NE(refusal("0", bare).find("no scenes to choose from"), std::string::npos);
  EXPECT_FALSE(load_scene("builtin:office", {.scene = "0"}));
}

TEST(ImportScenes, ADefaultThatDoesNotExistIsTheFirst) {
  GltfBuilder b = three_scenes();
  b.json["scene"] = 7;
  const Result<Scene> scene = import_scene("", b);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->instances.size(), 1u);
  ASSERT_EQ(scene->notes.warnings.size(), 1u);
  EXPECT_NE(scene->notes.warnings[0].find("default scene 7 does not exist"), std::string::npos);
}

// In the file node 1 is a child of node 2, which is listed first.
TEST(ImportScenes, KeepTheTreeOfTheirNodes) {
  GltfBuilder b = three_scenes();
  b.json["scenes"] = {{{"nodes", {0, 2}}}};
  b.json["scene"] = 0;
  b.json["nodes"][2]["name"] = "desk";
  b.json["nodes"][2]["children"] = {1, 3};
  b.json["nodes"][1]["name"] = "drawer";
  b.json["nodes"].push_back({{"name", "empty"}});
  const Result<Scene> scene = import_scene("", b);
  ASSERT_TRUE(scene) << scene.error().message();
  const SceneContents& c = scene->contents;
  ASSERT_EQ(c.nodes.size(), 4u);
  ASSERT_EQ(c.object_nodes.size(), 3u);
  std::size_t below = 0;
  for (std::size_t i = 0; i < c.object_nodes.size(); ++i) {
    const int node = c.object_nodes[i];
    EXPECT_EQ(scene->instances[i].node, node);
    const SceneContents::Node& of = c.nodes.at(static_cast<std::size_t>(node));
    if (of.name != "drawer") continue;
    ++below;
    EXPECT_LT(of.parent, node);
    EXPECT_EQ(c.nodes.at(static_cast<std::size_t>(of.parent)).name, "desk");
  }
  EXPECT_EQ(below, 1u);
}

}  // namespace
}  // namespace asos
