#include "renderer/gltf/copy.h"

#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/moving_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

// Copies of glTF files with edits.

namespace asos::test::copy_test {
namespace {

using nlohmann::json;

constexpr const char* lights_extension = "KHR_lights_punctual";

/// A square that moves and that a lamp and a camera follow, textured by a file, with variants.
GltfBuilder rich_file() {
  GltfBuilder b = GltfBuilder::square();
  const int times = b.scalars({0.0f, 1.0f}), ways = b.vec3({{0, 0, 0}, {2, 0, 0}});
  add_channel(b, 0, "translation", times, ways);
  b.json["materials"] = {{{"name", "red"}, {"extras", {{"note", "stays"}}}},
                         {{"name", "green"}, {"extras", {{"asos_dfr", {{"max", 0.5}}}}}}};
  b.json["images"] = {{{"uri", "pictures/dots.png"}}};
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_0"] = b.vec2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  primitive["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 1}, {"variants", {0}}}};
  b.json["extensionsUsed"] = {"KHR_materials_variants", lights_extension};
  b.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "Dusk"}}};
  b.json["extensions"][lights_extension]["lights"] = {{{"type", "point"}, {"intensity", 9.0}}};
  b.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
  b.json["nodes"].push_back(
      {{"name", "lamp"}, {"camera", 0}, {"extensions", {{lights_extension, {{"light", 0}}}}}});
  b.node()["children"] = {1};
  return b;
}

class CopyGltf : public testing::Test {
 protected:
  CopyGltf() {
    const GltfBuilder b = rich_file();
    std::filesystem::create_directories(folder.file("source/pictures"));
    std::filesystem::create_directories(folder.file("copies"));
    folder.write("source/data.bin", b.bin);
    folder.write("source/pictures/dots.png", png_bytes());
    source = folder.write("source/file.gltf", b.gltf("data.bin"));
  }
  /// The bytes of small_png.
  static std::string png_bytes() {
    const std::string text = std::string(small_png).substr(22);
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
      if (c == '=') break;
      bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
      if ((count += 6) < 8) continue;
      count -= 8;
      bytes.push_back(static_cast<char>(bits >> count & 0xffu));
    }
    return bytes;
  }
  /// The copy, after the source is gone.
  Scene copy(const GltfEdits& edits, const char* name = "copies/copy.glb") {
    const Result<void> done = copy_gltf(source, folder.file(name), edits);
    if (!done) throw std::runtime_error(done.error().message());
    std::filesystem::rename(folder.file("source"), folder.file("elsewhere"));
    Result<Scene> scene = import_gltf(folder.file(name), {.keep_posable = true});
    std::filesystem::rename(folder.file("elsewhere"), folder.file("source"));
    if (!scene) throw std::runtime_error(scene.error().message());
    return std::move(*scene);
  }

  TemporaryFolder folder;
  std::string source;
};

TEST_F(CopyGltf, KeepsEverythingElse) {
  const Scene before = *import_gltf(source, {.keep_posable = true});
  ASSERT_TRUE(before.notes.warnings.empty()) << before.notes.warnings[0];
  for (const char* name : {"copies/copy.glb", "copies/copy.gltf"}) {
    const Scene after = copy({}, name);
    EXPECT_TRUE(after.notes.warnings.empty());
    EXPECT_EQ(after.meshes[0].positions, before.meshes[0].positions);
    ASSERT_EQ(after.images.size(), 1u);
    EXPECT_TRUE(std::equal(after.images[0].rgba.data(), after.images[0].rgba.data() + 16,
                           before.images[0].rgba.data()));
    EXPECT_EQ(after.lights, before.lights);
    EXPECT_EQ(after.materials[1].dfr, before.materials[1].dfr);
    ASSERT_EQ(after.cameras.size(), 1u);
    EXPECT_EQ(after.contents.animations.size(), 1u);
    const Scene then = posed(after, 0.5);
    EXPECT_EQ(world_vertex(then, 0), glm::dvec3(1, 0, 0));
    EXPECT_EQ(then.lights[0].position, glm::dvec3(1, 0, 0));
    EXPECT_EQ(then.cameras[0].world_from_camera[3], glm::dvec4(1, 0, 0, 1));
  }
}

TEST_F(CopyGltf, WritesEditedLightsInPlaceOfTheFiles) {
  Light lamp{.name = "new", .position = {0, 3, 0}};
  Light off = lamp;
  off.color = {5.0f, 2.5f, 0.0f};
  off.intensity = 0.0f;
  Light panel = lamp;
  panel.type = Light::Type::disk;
  panel.radius = 0.5;
  Light panel_off = panel;
  panel_off.color = {7.0f, 7.0f, 7.0f};
  panel_off.intensity = 0.0f;
  GltfEdits edits{.lights = std::vector<Light>{lamp, off, panel, panel_off}};
  const Scene after = copy(edits);
  ASSERT_EQ(after.lights.size(), 4u);
  std::map<std::string, int> count;
  for (const Light& light : after.lights) {
    const bool disk = light.type == Light::Type::disk;
    EXPECT_EQ(light.position, glm::dvec3(0, 3, 0));
    const glm::vec3 off_colour = disk ? panel_off.color : off.color;
    EXPECT_EQ(light.color, light.intensity == 0.0f ? off_colour : glm::vec3(1.0f));
    count["off"] += light.intensity == 0.0f ? 1 : 0;
    ++count[disk ? "disk" : "point"];
  }
  EXPECT_EQ(count["disk"], 2);
  EXPECT_EQ(count["off"], 2);
  EXPECT_EQ(after.contents.animations.size(), 1u);
  EXPECT_TRUE(after.notes.warnings.empty());
}

TEST_F(CopyGltf, WritesDfrsIntoTheExtras) {
  GltfEdits edits;
  Dfr dfr;
  dfr.rgb[0].max = dfr.rgb[1].max = dfr.rgb[2].max = 0.25;
  edits.dfrs = {dfr, std::nullopt};
  const Scene after = copy(edits, "copies/copy.gltf");
  EXPECT_EQ(after.materials[0].dfr, dfr);
  EXPECT_EQ(after.materials[1].dfr, std::nullopt);
  const json written = json::parse(content_of(folder.file("copies/copy.gltf")));
  EXPECT_EQ(written["materials"][0]["extras"]["note"], "stays");
  EXPECT_FALSE(written["materials"][1].contains("extras"));
}

TEST_F(CopyGltf, TheShownVariantBecomesTheDefault) {
  GltfEdits edits{.variant = "Dusk"};
  const Scene after = copy(edits);
  EXPECT_EQ(after.meshes[0].material, 1);
  EXPECT_EQ(after.contents.variants, std::vector<std::string>{"Dusk"});
}

TEST_F(CopyGltf, EmissiveNodesAreMarked) {
  GltfEdits edits;
  edits.lights.emplace();
  edits.light_nodes = {0};
  const Scene after = copy(edits);
  EXPECT_TRUE(after.instances.at(0).shows_light);
  EXPECT_TRUE(after.lights.empty());
}

TEST_F(CopyGltf, TheMarkOfEditedLightsIsRead) {
  GltfEdits edits;
  edits.lights.emplace();
  for (const auto lighting :
       {AddedLighting::none, AddedLighting::environment, AddedLighting::automatic}) {
    edits.added_lighting = lighting;
    EXPECT_EQ(copy(edits).added_lighting, lighting);
  }
  // Without scenes, the file itself has the mark.
  GltfBuilder b = rich_file();
  b.json.erase("scenes");
  b.json.erase("scene");
  source = folder.write("source/file.gltf", b.gltf("data.bin"));
  const Scene before = *import_gltf(source, {});
  edits.added_lighting = AddedLighting::none;
  const Scene after = copy(edits);
  EXPECT_EQ(after.added_lighting, AddedLighting::none);
  EXPECT_EQ(after.notes.warnings, before.notes.warnings);
}

TEST_F(CopyGltf, AnUnknownMarkIsIgnored) {
  GltfBuilder b = rich_file();
  b.json["scenes"][0]["extras"]["asos_default_lighting"] = "bright";
  source = folder.write("source/file.gltf", b.gltf("data.bin"));
  const Scene scene = *import_gltf(source, {});
  EXPECT_EQ(scene.added_lighting, AddedLighting::automatic);
  ASSERT_EQ(scene.notes.warnings.size(), 1u);
  EXPECT_EQ(scene.notes.warnings[0],
            "the scene's asos_default_lighting is neither 'none' nor 'environment'; ignored");
}

/// Three nodes with the same mesh of two primitives. The second is a child of the first, whose
/// weights are animated.
GltfBuilder shared_mesh() {
  GltfBuilder b = rich_file();
  json& mesh = b.json["meshes"][0];
  const int way = b.vec3({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  mesh["primitives"][0]["targets"] = {{{"POSITION", way}}};
  mesh["primitives"].push_back(mesh["primitives"][0]);
  mesh["primitives"][1]["material"] = 1;
  mesh["weights"] = {0.0};
  b.node()["weights"] = {0.5};
  b.json["nodes"][1] = {{"mesh", 0}};
  b.json["nodes"].push_back({{"mesh", 0}});
  b.json.erase("cameras");
  b.json["scenes"][0]["nodes"] = {0, 2};
  add_channel(b, 0, "weights", b.scalars({0.0f, 1.0f}), b.scalars({0.0f, 1.0f}));
  return b;
}

TEST_F(CopyGltf, RemovesPartsOfNodes) {
  const GltfBuilder b = shared_mesh();
  folder.write("source/data.bin", b.bin);
  source = folder.write("source/file.gltf", b.gltf("data.bin"));
  const Scene before = *import_gltf(source, {});
  ASSERT_EQ(before.contents.object_primitives, (std::vector<int>{0, 1, 0, 1, 0, 1}));
  GltfEdits edits;
  edits.removed = {{0, 0}, {0, 1}, {1, 1}};  // all of the first, half of its child
  const Scene after = copy(edits);
  EXPECT_TRUE(after.notes.warnings.empty()) << after.notes.warnings[0];
  EXPECT_EQ(after.contents.nodes.size(), 3u);
  EXPECT_EQ(after.contents.object_nodes, (std::vector<int>{1, 2, 2}));
  EXPECT_EQ(after.meshes[static_cast<std::size_t>(after.instances[0].mesh)].material, 0);
  ASSERT_EQ(after.contents.animations.size(), 1u);
  EXPECT_EQ(after.contents.animations[0].channels, 1u) << "its weights move nothing";
  EXPECT_EQ(posed(after, 0.5).instances[0].world_from_mesh[3], glm::dvec4(1, 0, 0, 1));
}

TEST_F(CopyGltf, RemovesShapesWithTheirMesh) {
  GltfBuilder b = rich_file();
  b.node()["extras"]["asos_shape"] = {{"type", "sphere"}, {"radius", 1.0}};
  b.json["nodes"][1] = {{"mesh", 0}};
  source = folder.write("source/file.gltf", b.gltf("data.bin"));
  ASSERT_EQ(import_gltf(source, {})->contents.object_primitives, (std::vector<int>{-1, 0}));
  GltfEdits edits{.removed = {{0, -1}}};
  const Scene after = copy(edits);
  ASSERT_EQ(after.instances.size(), 1u);
  EXPECT_EQ(after.instances[0].shape, -1);
  EXPECT_EQ(after.contents.object_nodes, std::vector<int>{1});
}

// A view past the end of its buffer does not read the data that follows in the copy.
TEST_F(CopyGltf, BrokenViewsStayBroken) {
  GltfBuilder b = rich_file();
  b.json["bufferViews"][0]["byteLength"] = b.bin.size() + 8;
  source = folder.write("source/file.gltf", b.gltf("data.bin"));
  EXPECT_FALSE(import_gltf(source, {}));
  ASSERT_TRUE(copy_gltf(source, folder.file("copies/broken.glb"), {}));
  EXPECT_FALSE(import_gltf(folder.file("copies/broken.glb"), {}));
}

TEST_F(CopyGltf, FaultsNameTheFile) {
  const auto error = [&](const std::string& from, const std::string& to) {
    const Result<void> done = copy_gltf(from, to, {});
    return done ? std::string("none") : done.error().message();
  };
  EXPECT_TRUE(error(folder.file("none.glb"), folder.file("a.glb"))
                  .starts_with(folder.file("none.glb") + ": "));
  EXPECT_EQ(error(source, folder.file("a.obj")),
            folder.file("a.obj") + ": a scene is written as .glb or .gltf");
  const std::string odd = folder.write("source/odd.gltf", R"({"scenes": 3, "nodes": {}})");
  GltfEdits edits{.lights = std::vector<Light>{Light{}}};
  const Result<void> done = copy_gltf(odd, folder.file("a.glb"), edits);
  ASSERT_FALSE(done);
  EXPECT_TRUE(done.error().message().starts_with(odd + ": cannot be copied"))
      << done.error().message();
}

}  // namespace
}  // namespace asos::test::copy_test
