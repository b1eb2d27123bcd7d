#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/rich_scene.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <limits>
#include <locale>
#include <string>

namespace asos {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;
using test::content_of;
using test::moved;
using test::rich_scene;

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

struct Parsed {
  json root;
  std::string binary;
};

/// Parses a .glb and asserts all of its lengths.
Parsed parse_glb(const std::string& file) {
  Parsed parsed;
  EXPECT_GE(file.size(), 20u);
  EXPECT_EQ(file.substr(0, 4), "glTF");
  EXPECT_EQ(u32(file, 4), 2u);
  EXPECT_EQ(u32(file, 8), file.size());
  const std::size_t json_size = u32(file, 12);
  EXPECT_EQ(json_size % 4, 0u);
  EXPECT_EQ(file.substr(16, 4), "JSON");
  parsed.root = json::parse(file.substr(20, json_size));
  const std::size_t rest = 20 + json_size;
  if (rest == file.size()) return parsed;
  EXPECT_EQ(u32(file, rest) % 4, 0u);
  EXPECT_EQ(rest + 8 + u32(file, rest), file.size());
  EXPECT_EQ(file.substr(rest + 4, 4), std::string("BIN\0", 4));
  parsed.binary = file.substr(rest + 8);
  return parsed;
}

/// Every accessor is within its view, every view within the buffer, at multiples of four.
void expect_sound_accessors(const Parsed& file) {
  const json& root = file.root;
  for (const json& view : root.value("bufferViews", json::array())) {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
              root["buffers"][0]["byteLength"].get<std::size_t>());
  }
  for (const json& accessor : root.value("accessors", json::array())) {
    const std::string type = accessor["type"];
    const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    const json& view = root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    EXPECT_GT(accessor["count"].get<std::size_t>(), 0u);
    EXPECT_EQ(view["byteLength"].get<std::size_t>(),
              4 * width * accessor["count"].get<std::size_t>());
    EXPECT_EQ(view["target"].get<int>(), accessor["componentType"] == 5125 ? 34963 : 34962);
  }
}

class ExportTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }

  const test::TemporaryFolder folder_;
};

TEST_F(ExportTest, GlbIsSoundAndSelfContained) {
  ASSERT_TRUE(export_gltf(rich_scene(), path("rich.glb")));
  const Parsed file = parse_glb(content_of(path("rich.glb")));
  const json& root = file.root;
  EXPECT_EQ(root["asset"]["version"], "2.0");
  EXPECT_EQ(root["asset"]["generator"], "ASOS");
  EXPECT_EQ(root["buffers"][0]["byteLength"], file.binary.size());
  EXPECT_FALSE(root["buffers"][0].contains("uri"));
  EXPECT_EQ(root["scenes"][0]["name"], rich_scene().name);
  expect_sound_accessors(file);

  // Three instances, three lights, two cameras.
  EXPECT_EQ(root["nodes"].size(), 8u);
  EXPECT_EQ(root["scenes"][root["scene"].get<std::size_t>()]["nodes"].size(), 8u);
  EXPECT_EQ(root["nodes"][1]["matrix"][12].get<double>(), 1e6 + 0.123456789);
  EXPECT_FALSE(root["nodes"][0].contains("matrix"));

  const json& primitive = root["meshes"][0]["primitives"][0];
  const json& position = root["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(position["min"], json::array({0.0f, -2.0f, -5.0f}));
  EXPECT_EQ(position["max"], json::array({1.0f, 1.0f, 1.0f / 3.0f}));
  EXPECT_EQ(primitive["attributes"].size(), 6u);

  const json used = {"KHR_lights_punctual",        "KHR_materials_anisotropy",
                     "KHR_materials_clearcoat",    "KHR_materials_diffuse_transmission",
                     "KHR_materials_dispersion",   "KHR_materials_emissive_strength",
                     "KHR_materials_ior",          "KHR_materials_iridescence",
                     "KHR_materials_sheen",        "KHR_materials_specular",
                     "KHR_materials_transmission", "KHR_materials_unlit",
                     "KHR_materials_volume",       "KHR_texture_transform"};
  EXPECT_EQ(root["extensionsUsed"], used);
  EXPECT_FALSE(root.contains("extensionsRequired"));

  const json& image = root["bufferViews"][root["images"][0]["bufferView"].get<std::size_t>()];
  EXPECT_EQ(file.binary.substr(image["byteOffset"].get<std::size_t>(), 4), "\x89PNG");
}

TEST_F(ExportTest, GltfHoldsItsBufferAsDataUri) {
  ASSERT_TRUE(export_gltf(rich_scene(), path("rich.GLTF")));
  const json root = json::parse(content_of(path("rich.GLTF")));
  const std::string uri = root["buffers"][0]["uri"];
  const std::string prefix = "data:application/octet-stream;base64,";
  ASSERT_TRUE(uri.starts_with(prefix));
  const std::size_t bytes = root["buffers"][0]["byteLength"];
  EXPECT_EQ(uri.size() - prefix.size(), (bytes + 2) / 3 * 4);
}

TEST_F(ExportTest, LinesAndPointsComeBack) {
  Scene scene;
  Mesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0.1f, 2, -3}},
            .colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}},
            .segments = {{0, 1}, {2, 0}}};
  scene.meshes.push_back(mesh);
  mesh.segments.clear();
  mesh.points = {2, 1};
  scene.meshes.push_back(mesh);
  scene.instances = {{"lines", 0, glm::dmat4(1.0)}, {"points", 1, glm::dmat4(1.0)}};
  ASSERT_TRUE(export_gltf(scene, path("lines.glb")));
  expect_sound_accessors(parse_glb(content_of(path("lines.glb"))));
  const Result<Scene> back = import_gltf(path("lines.glb"));
  ASSERT_TRUE(back) << back.error().message();
  ASSERT_EQ(back->meshes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back->meshes[i].positions, scene.meshes[i].positions);
    EXPECT_EQ(back->meshes[i].colors, scene.meshes[i].colors);
    EXPECT_EQ(back->meshes[i].segments, scene.meshes[i].segments);
    EXPECT_EQ(back->meshes[i].points, scene.meshes[i].points);
  }
}

TEST_F(ExportTest, EmptySceneIsValid) {
  Scene scene{.meshes = {Mesh{}}};
  scene.meshes[0].name = "nothing";
  scene.instances = {{"place of nothing", 0, glm::dmat4(1.0)}};
  ASSERT_TRUE(export_gltf(scene, path("empty.glb")));
  const Parsed file = parse_glb(content_of(path("empty.glb")));
  for (const char* list : {"meshes", "buffers", "bufferViews", "accessors", "materials", "images",
                           "textures", "cameras", "extensionsUsed", "extensions"}) {
    EXPECT_FALSE(file.root.contains(list)) << list << " must be absent, not empty";
  }
  EXPECT_EQ(file.root["nodes"], json::array({{{"name", "place of nothing"}}}));
}

TEST_F(ExportTest, BrightEmissionGoesIntoTheStrength) {
  Scene scene;
  scene.materials.resize(1);
  scene.materials[0].emissive = {8.0f, 4.0f, 0.0f};
  scene.materials[0].emissive_strength = 3.0f;
  ASSERT_TRUE(export_gltf(scene, path("bright.glb")));
  const json root = parse_glb(content_of(path("bright.glb"))).root;
  EXPECT_EQ(root["materials"][0]["emissiveFactor"], json::array({1.0f, 0.5f, 0.0f}));
  EXPECT_EQ(root["materials"][0]["extensions"]["KHR_materials_emissive_strength"],
            (json{{"emissiveStrength", 24.0f}}));
}

TEST(TextureTransform, DecomposesEveryTurnAndMirror) {
  for (int turn = -7; turn <= 7; ++turn) {
    for (const glm::vec2 scale : {glm::vec2(1, 1), glm::vec2(0.5f, 3), glm::vec2(2, -4)}) {
      const double angle = 0.44 * turn;
      const auto t = exporting::decompose(moved(0, angle, scale, {0.3f, -7.0f}).uv_transform);
      ASSERT_TRUE(t) << angle;
      EXPECT_NEAR(std::remainder(t->rotation_rad - angle, 2.0 * 3.141592653589793), 0.0, 1e-6);
      EXPECT_NEAR(t->scale.x, scale.x, 1e-6);
      EXPECT_NEAR(t->scale.y, scale.y, 1e-6);
      EXPECT_EQ(glm::vec2(t->offset), glm::vec2(0.3f, -7.0f));
    }
  }
  glm::mat3 sheared(1.0f);
  sheared[1].x = 0.5f;
  EXPECT_FALSE(exporting::decompose(sheared));
}

/// Each change makes the scene impossible to write; the error must name its cause.
TEST_F(ExportTest, BrokenScenesAreRefusedByName) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refused = [this](auto change, const std::string& expected) {
    Scene scene = rich_scene();
    change(scene);
    const Result<void> result = export_gltf(scene, path("broken.glb"));
    ASSERT_FALSE(result) << expected;
    EXPECT_EQ(result.error().subject, path("broken.glb"));
    EXPECT_NE(result.error().reason.find(expected), std::string::npos) << result.error().reason;
    EXPECT_TRUE(fs::is_empty(folder_.path()));
  };
  refused([&](Scene& s) { s.meshes[1].positions[2].y = nan; }, "mesh 1 'plain'");
  refused([&](Scene& s) { s.meshes[0].triangles[0].z = 3; }, "mesh 0 'triangle'");
  refused([&](Scene& s) { s.meshes[0].normals.pop_back(); }, "different lengths");
  refused([&](Scene& s) { s.meshes[0].material = 2; }, "material 2");
  refused([&](Scene& s) { s.instances[1].mesh = 9; }, "instance 1 'b'");
  refused([&](Scene& s) { s.instances[2].world_from_mesh[3].x = INFINITY; }, "instance 2 'c'");
  refused([&](Scene& s) { s.materials[0].roughness = nan; }, "material 0 'full'");
  refused([&](Scene& s) { s.materials[0].dfr->rgb[1].min = 1.5; }, "defocusing ratio");
  refused([&](Scene& s) { s.materials[1].dfr->rgb[2].exponent = nan; }, "defocusing exponent");
  refused([&](Scene& s) { s.materials[0].dfr->perturbation = -1; }, "perturbation");
  refused([&](Scene& s) { s.materials[0].specular = 2; }, "specular factor");
  refused([&](Scene& s) { s.materials[0].specular_color.g = -1; }, "specular colour");
  refused([&](Scene& s) { s.materials[1].base_color_texture.texture = 5; }, "texture 5");
  refused([&](Scene& s) { s.materials[0].base_color_texture.uv_transform[1].x += 1; }, "shear");
  refused([&](Scene& s) { s.images[0].rgba.own().pop_back(); }, "image 0 'checks'");
  refused([&](Scene& s) { s.textures[1].image = -1; }, "texture 1 'second'");
  refused([&](Scene& s) { s.lights[0].direction = glm::dvec3(0.0); }, "light 0 'sun'");
  refused([&](Scene& s) { s.lights[1].outer_cone_rad = 0.1; }, "light 1 'spot'");
  refused([&](Scene& s) { s.cameras[0].fov_y_rad = 4.0; }, "camera 0 'perspective'");
  refused([&](Scene& s) { s.cameras[1].height = 0.0; }, "camera 1 'orthographic'");
}

TEST_F(ExportTest, UnwritablePathsNameFileAndReason) {
  const Scene scene = rich_scene();
  const Result<void> missing = export_gltf(scene, path("no/such/folder.glb"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().subject, path("no/such/folder.glb"));
  EXPECT_NE(missing.error().reason.find("No such file"), std::string::npos);

  fs::create_directories(path("folder.glb"));
  EXPECT_FALSE(export_gltf(scene, path("folder.glb")));
  EXPECT_TRUE(fs::is_directory(path("folder.glb")));
  EXPECT_FALSE(export_gltf(scene, path("picture.png")));
  // No partly written file is left.
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(ExportTest, FailureKeepsTheOldFile) {
  ASSERT_TRUE(export_gltf(rich_scene(), path("kept.glb")));
  const std::string before = content_of(path("kept.glb"));
  Scene broken = rich_scene();
  broken.meshes[0].positions[0].x = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(export_gltf(broken, path("kept.glb")));
  EXPECT_EQ(content_of(path("kept.glb")), before);
}

/// A locale with decimal commas and digit grouping that need not be installed.
struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_F(ExportTest, NumbersDoNotDependOnTheLocale) {
  ASSERT_TRUE(export_gltf(rich_scene(), path("plain.gltf")));
  const std::locale before = std::locale::global(std::locale(std::locale(), new Commas));
  const Result<void> result = export_gltf(rich_scene(), path("commas.gltf"));
  std::locale::global(before);
  ASSERT_TRUE(result);
  EXPECT_EQ(content_of(path("plain.gltf")), content_of(path("commas.gltf")));
}

}  // namespace
}  // namespace asos
