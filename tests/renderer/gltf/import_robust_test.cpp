#include "renderer/world/world.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/renderer/gltf/load_timer.h"
#include "tests/support/flat_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sys/stat.h>

namespace asos {
namespace {

using test::GltfBuilder;
using test::load_in_time;
using test::TemporaryFolder;

Result<Scene> load_text(const std::string& bytes, const std::string& name = "test.gltf") {
  const TemporaryFolder folder;
  return load_in_time(folder.write(name, bytes));
}

void expect_refused(const Result<Scene>& scene, const std::string& because) {
  ASSERT_FALSE(scene) << "was to be refused because " << because;
  EXPECT_NE(scene.error().reason.find(because), std::string::npos) << scene.error().message();
  EXPECT_NE(scene.error().subject.find("test.gl"), std::string::npos) << scene.error().message();
}

void expect_warned(const Result<Scene>& scene, const std::string& of) {
  ASSERT_TRUE(scene) << scene.error().message();
  const auto& warnings = scene->notes.warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [&](const std::string& w) { return w.find(of) != std::string::npos; }))
      << "no warning of " << of << "; the first of " << warnings.size() << ": "
      << (warnings.empty() ? "" : warnings.front());
}

TEST(ImportRobust, FilesThatAreNone) {
  const TemporaryFolder folder;
  const auto reason = [](const std::string& path) {
    const Result<Scene> scene = load_in_time(path);
    return scene ? std::string("loaded") : scene.error().message();
  };
  EXPECT_NE(reason(folder.file("test.glb")).find("No such file"), std::string::npos);
  EXPECT_NE(reason(folder.file("")).find("directory"), std::string::npos);
  EXPECT_NE(reason(folder.write("empty.glb", "")).find("empty"), std::string::npos);
  ASSERT_EQ(::mkfifo(folder.file("pipe.gltf").c_str(), 0600), 0);
  EXPECT_NE(reason(folder.file("pipe.gltf")).find("not a regular file"), std::string::npos);
  EXPECT_NE(reason("/dev/zero").find("not a regular file"), std::string::npos);
  EXPECT_NE(reason(folder.write("test.gltf", "hello")).find("JSON"), std::string::npos);
}

TEST(ImportRobust, NestingBomb) {
  const std::string deep(100'000, '[');
  expect_refused(load_text(R"({"asset":{"version":"2.0"},"extras":)" + deep), "nested");
  // The limit is on depth only: brackets within strings do not count.
  const std::string text =
      R"({"asset":{"version":"2.0","generator":"\"[[[[)" + std::string(1000, '[') + R"("}})";
  EXPECT_TRUE(load_text(text));
}

TEST(ImportRobust, TruncatedGlbAtEveryLength) {
  const std::string whole = GltfBuilder::square().glb();
  ASSERT_TRUE(load_text(whole, "test.glb"));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_FALSE(load_text(whole.substr(0, length), "test.glb")) << length;
  }
}

TEST(ImportRobust, OnlyVersionTwo) {
  expect_refused(load_text("{}"), "asset version");
  expect_refused(load_text(R"({"asset":{"version":"1.0"}})"), "'1.0'");
  expect_refused(load_text(R"({"asset":{"version":"2.0","minVersion":"2.1"}})"), "minVersion");
}

TEST(ImportRobust, RequiredExtensionsAreRefusedByName) {
  GltfBuilder b = GltfBuilder::square();
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"ACME_gizmo"};
  expect_refused(load_in_time(b), "requires the extension ACME_gizmo, which is not supported");
}

TEST(ImportRobust, HugeCountsAreRefusedBeforeAllocation) {
  GltfBuilder b;
  b.primitive({{"POSITION", b.accessor(-1, 5126, "VEC3", 4'000'000'000u)}});
  expect_refused(load_in_time(b), "4000000000");

  GltfBuilder beyond = GltfBuilder::square();
  beyond.json["accessors"][0]["count"] = 4'000'000'000u;
  expect_refused(load_in_time(beyond), "reaches outside");

  // The product of stride and count, or an offset plus a length, wraps around 64 bits.
  GltfBuilder wrap = GltfBuilder::square();
  wrap.json["accessors"][0]["count"] = 0x1555555555555556u;
  expect_refused(load_in_time(wrap), "reaches outside");
  wrap.json["accessors"][0]["count"] = 4;
  wrap.json["bufferViews"][0]["byteOffset"] = 0xfffffffffffffff0u;
  expect_refused(load_in_time(wrap), "reach outside");

  GltfBuilder many = GltfBuilder::square();
  const TemporaryFolder folder;
  const Result<Scene> scene =
      load_in_time(folder.write("test.glb", many.glb()), {.max_triangles = 1});
  expect_refused(scene, "more than 1 triangles");
}

TEST(ImportRobust, IndicesOutOfRange) {
  GltfBuilder b = GltfBuilder::square();
  b.json["meshes"][0]["primitives"][0]["indices"] = b.indices({0, 1, 2, 0, 2, 4});
  const Result<Scene> some = load_in_time(b);
  expect_warned(some, "1 of 2 triangles use vertices that do not exist");
  EXPECT_EQ(some->instanced_triangles(), 1u);
  b.json["meshes"][0]["primitives"][0]["indices"] = b.indices({9, 9, 9});
  expect_refused(load_in_time(b), "vertices that do not exist");
}

TEST(ImportRobust, CyclesAndSecondParents) {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"] = {{{"mesh", 0}, {"children", {1}}}, {{"children", {2}}}, {{"children", {0}}}};
  expect_warned(load_in_time(b), "among its own descendants");
  b.json["nodes"] = {{{"mesh", 0}, {"children", {0}}}};
  expect_warned(load_in_time(b), "among its own descendants");
  b.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
  b.json["scenes"][0]["nodes"] = {0, 1};
  const Result<Scene> twice = load_in_time(b);
  expect_warned(twice, "second is ignored");
  EXPECT_EQ(twice->instances.size(), 1u);
}

TEST(ImportRobust, ADeepHierarchyDoesNotOverflowTheStack) {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"] = nlohmann::json::array();
  constexpr int depth = 100'000;
  for (int i = 0; i < depth; ++i) b.json["nodes"].push_back({{"children", {i + 1}}});
  b.json["nodes"].push_back({{"mesh", 0}});
  const Result<Scene> scene = load_in_time(b);
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->instances.size(), 1u);
}

TEST(ImportRobust, FilesOutsideTheAssetRootAreNotRead) {
  const TemporaryFolder folder;
  const GltfBuilder b = GltfBuilder::square();
  std::filesystem::create_directory(folder.file("inner"));
  folder.write("outside.bin", b.bin);
  folder.write("inner/in side.bin", b.bin);
  folder.write("inner/in%20side.bin", "not the one that the uri stands for");
  folder.write("inner/as%20written.bin", b.bin);
  std::filesystem::create_symlink(folder.file("outside.bin"), folder.file("inner/link.bin"));
  const auto with = [&](const std::string& uri) {
    return load_in_time(folder.write("inner/test.gltf", b.gltf(uri)),
                        {.asset_root = folder.file("inner")});
  };
  EXPECT_TRUE(with("in side.bin"));
  EXPECT_TRUE(with("in%20side.bin"));
  EXPECT_TRUE(with("as%20written.bin")) << "only the literal URI names a file";
  expect_refused(with("../outside.bin"), "leads out of");
  expect_refused(with("%2e%2e/outside.bin"), "leads out of");
  expect_refused(with("link.bin"), "symbolic link");
  expect_refused(with(folder.file("outside.bin")), "absolute");
  expect_refused(with("file:///etc/passwd"), "not a local file");
  expect_refused(with("gone.bin"), "No such file");
  expect_refused(with("data:application/octet-stream;base64,A*=="), "base64");
}

TEST(ImportRobust, NamesWithSpacesAndOtherAlphabets) {
  const TemporaryFolder folder;
  GltfBuilder b = GltfBuilder::square();
  b.node()["name"] = "Stuhl – いす ❤";
  const Result<Scene> scene = load_in_time(folder.write("tä st ❤.glb", b.glb()));
  ASSERT_TRUE(scene) << scene.error().message();
  EXPECT_EQ(scene->instances[0].name, "Stuhl – いす ❤");
}

TEST(ImportRobust, PositionsThatAreNotFinite) {
  GltfBuilder b;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int p = b.vec3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}});
  b.primitive({{"POSITION", p}})["indices"] = b.indices({0, 1, 2, 1, 2, 3});
  const Result<Scene> scene = load_in_time(b);
  expect_warned(scene, "not finite");
  EXPECT_EQ(scene->instanced_triangles(), 1u);
  for (const glm::vec3 q : scene->meshes[0].positions) EXPECT_TRUE(std::isfinite(q.x));
}

TEST(ImportRobust, NormalsThatAreNotFiniteAreMadeAnew) {
  GltfBuilder b;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int p = b.vec3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const int n = b.vec3({{nan, 0, 0}, {0, 0, 0}, {0, 0, 3}});
  b.primitive({{"POSITION", p}, {"NORMAL", n}});
  const Result<Scene> scene = load_in_time(b);
  expect_warned(scene, "2 normals are zero or not finite");
  expect_warned(scene, "1 normals were not normalised");
  for (const glm::vec3 q : scene->meshes[0].normals) EXPECT_EQ(q, glm::vec3(0, 0, 1));
}

TEST(ImportRobust, InfiniteAndSingularPlacements) {
  GltfBuilder b = GltfBuilder::square();
  b.json["nodes"] = {{{"scale", {1e200, 1, 1}}, {"children", {1}}},
                     {{"scale", {1e200, 1, 1}}, {"mesh", 0}}};
  expect_refused(load_in_time(b), "placed at infinity");
  b.json["nodes"] = {{{"scale", {1, 0, 1}}, {"mesh", 0}}};
  const Result<Scene> flat = load_in_time(b);
  ASSERT_TRUE(flat);
  const Result<World> world = test::flat_world(*flat);
  ASSERT_TRUE(world);
  for (const glm::vec3 n : world->normals) EXPECT_NEAR(glm::length(n), 1.0f, 1e-6f);
  b.json["nodes"] = {{{"scale", {1e25, 1, 1}}, {"mesh", 0}}};
  const Result<Scene> large = load_in_time(b);
  ASSERT_TRUE(large);
  EXPECT_FALSE(flatten(*large));
}

TEST(ImportRobust, BrokenPicturesCostOnlyThemselves) {
  const auto with_image = [](const nlohmann::json& image) {
    GltfBuilder b = GltfBuilder::square();
    b.json["images"] = {image};
    b.json["textures"] = {{{"source", 0}}};
    b.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    b.json["meshes"][0]["primitives"][0]["material"] = 0;
    return b;
  };
  expect_warned(load_in_time(with_image({{"uri", "gone.png"}})), "No such file");
  expect_warned(load_in_time(with_image({{"uri", "../../../../../../x.png"}})), "leads out");
  expect_warned(load_in_time(with_image({{"uri", "data:image/png;base64,AAAA"}})), "no usable PNG");
  GltfBuilder outside = with_image({{"bufferView", 0}, {"mimeType", "image/png"}});
  outside.json["images"][0]["bufferView"] = 3;
  outside.json["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", 4'000'000'000u}, {"byteLength", 100}});
  expect_warned(load_in_time(outside), "reach outside buffer 0");
  // Headers of 20000 x 16 and of 12336 x 12336 pixels without data.
  std::string head = "\x89PNG\r\n\x1a\n";
  head += std::string("\0\0\0\rIHDR\0\0\x4e\x20\0\0\0\x10\x08\x02\0\0\0", 21);
  head += std::string(64, '\0');
  expect_warned(
      load_in_time(with_image({{"uri", "data:image/png;base64," + GltfBuilder::base64(head)}})),
      "the limit is 16384");
  std::string smaller = "\x89PNG\r\n\x1a\n";
  smaller += std::string("\0\0\0\rIHDR\0\0\x30\x30\0\0\x30\x30\x08\x02\0\0\0", 21);
  smaller += std::string(64, '\0');
  expect_warned(
      load_in_time(with_image({{"uri", "data:image/png;base64," + GltfBuilder::base64(smaller)}})),
      "cannot hold");
}

TEST(ImportRobust, ReferencesOutOfRange) {
  GltfBuilder b = GltfBuilder::square();
  b.json["meshes"][0]["primitives"][0]["material"] = 7;
  expect_warned(load_in_time(b), "material 7");
  b.json["nodes"][0]["skin"] = 3;
  expect_warned(load_in_time(b), "skin 3 does not exist");
  b.json["nodes"][0]["camera"] = 3;
  expect_warned(load_in_time(b), "camera 3 does not exist");
  b.json["nodes"][0]["mesh"] = -1;
  expect_warned(load_in_time(b), "/nodes/0/mesh is not an index");
  b.json["nodes"][0]["mesh"] = 4294967296u;
  expect_warned(load_in_time(b), "/nodes/0/mesh is not an index");
  b.json["nodes"][0]["mesh"] = 8;
  expect_refused(load_in_time(b), "mesh 8");
  b.json["nodes"][0]["mesh"] = 0;
  b.json["bufferViews"][0]["byteOffset"] = -4;
  expect_refused(load_in_time(b), "byteOffset that is not a whole number");
}

TEST(ImportRobust, ASceneWithoutTrianglesSaysSo) {
  expect_warned(load_text(R"({"asset":{"version":"2.0"}})"), "nothing to draw");
}

TEST(ImportRobust, UnknownBuiltinScenesAreNamed) {
  const Result<Scene> scene = load_scene("builtin:nowhere");
  ASSERT_FALSE(scene);
  EXPECT_NE(scene.error().message().find("nowhere"), std::string::npos);
}

}  // namespace
}  // namespace asos
