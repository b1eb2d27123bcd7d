#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/gltf/load.h"
#include "renderer/scene/builtin.h"
#include "tests/renderer/gltf/light_checks.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <string>
#include <unistd.h>

namespace asos {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;
using test::content_of;

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

struct Parsed {
  json root;
  std::string binary;
};

/// Takes a .glb apart, with assertions on its every length.
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

/// Every accessor lies in its view, every view in the buffer, at multiples of four.
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
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / ("asos-export-" + std::to_string(::getpid()) + "-" +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }

  fs::path folder_;
};

Mesh triangle() {
  Mesh mesh;
  mesh.name = "triangle";
  mesh.positions = {{0.1f, -2.0f, 1.0f / 3.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, -5.0f}};
  mesh.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TextureUse moved(int texture, double angle, glm::vec2 scale, glm::vec2 offset) {
  TextureUse use;
  use.texture = texture;
  use.texcoord = 1;
  const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  use.uv_transform = {glm::vec3(c * scale.x, -s * scale.x, 0.0f),
                      glm::vec3(s * scale.y, c * scale.y, 0.0f), glm::vec3(offset, 1.0f)};
  return use;
}

/// A scene that uses every field that can be written.
Scene rich_scene() {
  Scene scene;
  scene.name = "rich \"\u00e9\u6f22\"";
  Image image{"checks", 3, 2, {}};
  for (int i = 0; i < 24; ++i) image.rgba.own().push_back(static_cast<std::uint8_t>(10 * i));
  scene.images = {image};
  scene.textures = {{"first", 0, Wrap::clamp_to_edge, Wrap::mirrored_repeat, Filter::nearest},
                    {"second", 0, Wrap::repeat, Wrap::repeat, Filter::linear}};

  Material full;
  full.name = "full";
  full.base_color = {0.1f, 0.2f, 0.3f, 0.4f};
  full.base_color_texture = moved(0, 0.7, {2.0f, -3.0f}, {0.25f, -0.5f});
  full.metallic = 0.6f;
  full.roughness = 0.7f;
  full.metallic_roughness_texture.texture = 1;
  full.normal_texture.texture = 1;
  full.normal_texture.scale = 0.8f;
  full.occlusion_texture.texture = 0;
  full.occlusion_texture.scale = 0.7f;
  full.emissive = {0.5f, 0.25f, 1.0f};
  full.emissive_strength = 12.5f;
  full.emissive_texture.texture = 0;
  full.alpha_mode = AlphaMode::mask;
  full.alpha_cutoff = 0.3f;
  full.double_sided = true;
  full.ior = 1.33f;
  full.transmission = 0.9f;
  full.specular = 0.4f;
  full.specular_color = {1.0f, 0.5f, 2.0f};
  full.specular_texture.texture = 1;
  full.specular_color_texture = moved(0, 0.7, {2.0f, -3.0f}, {0.25f, -0.5f});
  full.transmission_texture.texture = 0;
  full.transmission_texture.texcoord = 1;
  full.coat.factor = 0.75f;
  full.coat.roughness = 0.3f;
  full.coat.texture.texture = 1;
  full.coat.roughness_texture = moved(1, 0.2, {2.0f, 3.0f}, {0.25f, -0.5f});
  full.coat.normal_texture.texture = 0;
  full.coat.normal_texture.scale = 0.6f;
  full.sheen.color = {0.9f, 0.1f, 0.3f};
  full.sheen.roughness = 0.4f;
  full.sheen.color_texture.texture = 0;
  full.sheen.roughness_texture.texture = 1;
  full.film.factor = 0.75f;
  full.film.ior = 1.4f;
  full.film.thickness_min_nm = 50.0f;
  full.film.thickness_max_nm = 350.0f;
  full.film.texture.texture = 1;
  full.film.thickness_texture.texture = 0;
  full.anisotropy.strength = 0.6f;
  full.anisotropy.rotation_rad = 1.57f;
  full.anisotropy.texture = moved(1, 0.3, {1.5f, 2.0f}, {0.5f, 0.25f});
  full.diffuse_transmission.factor = 0.7f;
  full.diffuse_transmission.color = {0.1f, 0.2f, 0.9f};
  full.diffuse_transmission.texture.texture = 1;
  full.diffuse_transmission.color_texture.texture = 0;
  full.volume.thickness = 0.3f;
  full.volume.thickness_texture.texture = 1;
  full.volume.attenuation_distance = 0.7f;
  full.volume.attenuation_color = {0.1f, 0.5f, 1.0f};
  full.volume.dispersion = 0.36f;
  full.dfr = Dfr{{{{0.1, 0.9, 2.0}, {0.2, 1.0 / 3.0, 2.5}, {0.0, 1.0, 32.0}}}, 0.125};
  Material flat;
  flat.name = "flat";
  flat.unlit = true;
  flat.alpha_mode = AlphaMode::blend;
  flat.dfr = Dfr{{{{0.05, 1.0, 64.0}, {0.05, 1.0, 64.0}, {0.05, 1.0, 64.0}}}, 0.0};
  scene.materials = {full, flat};

  Mesh mesh = triangle();
  mesh.tangents = {{1, 0, 0, 1}, {1, 0, 0, -1}, {0, 1, 0, 1}};
  mesh.texcoords[0] = {{0, 0}, {1, 0}, {0.3f, 1}};
  mesh.texcoords[1] = {{2, 0}, {1, -1}, {0.7f, 1}};
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 0.5f}, {0, 0, 1, 1}};
  mesh.material = 0;
  Mesh plain = triangle();
  plain.name = "plain";
  plain.material = 1;
  scene.meshes = {mesh, plain};
  glm::dmat4 mirrored(1.0);
  mirrored[0].x = -1.0 / 3.0;
  mirrored[3] = {1e6 + 0.123456789, 2.0, 3.0, 1.0};
  scene.instances = {{"a", 0, glm::dmat4(1.0)}, {"b", 1, mirrored}, {"c", 0, mirrored}};

  Light sun;
  sun.name = "sun";
  sun.type = Light::Type::directional;
  sun.direction = {0.0, 0.0, 1.0};  // straight against glTF's own axis
  sun.intensity = 3.25f;
  Light spot;
  spot.name = "spot";
  spot.type = Light::Type::spot;
  spot.position = {1.5, -2.25, 1e5};
  spot.direction = glm::normalize(glm::dvec3(1, -2, 0.5));
  spot.color = {1.0f, 0.5f, 0.25f};
  spot.inner_cone_rad = 0.2;
  spot.outer_cone_rad = 0.6;
  spot.range = 40.0;
  Light point;
  point.name = "point";
  point.position = {0.1, 0.2, 0.3};
  point.intensity = 80.0f;
  point.casts_shadows = false;
  scene.lights = {sun, spot, point};

  Camera perspective;
  perspective.name = "perspective";
  perspective.world_from_camera[3] = {4.0, 5.0, 6.0, 1.0};
  perspective.fov_y_rad = 0.7;
  Camera flat_camera;
  flat_camera.name = "orthographic";
  flat_camera.type = Camera::Type::orthographic;
  flat_camera.height = 7.0;
  flat_camera.aspect_ratio = 1.5;
  scene.cameras = {perspective, flat_camera};
  return scene;
}

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
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.1f, 2, -3}};
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}};
  mesh.segments = {{0, 1}, {2, 0}};
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
  Scene scene;
  scene.meshes = {Mesh{}};
  scene.meshes[0].name = "nothing";
  scene.instances = {{"place of nothing", 0, glm::dmat4(1.0)}};
  ASSERT_TRUE(export_gltf(scene, path("empty.glb")));
  const Parsed file = parse_glb(content_of(path("empty.glb")));
  for (const char* list : {"meshes", "buffers", "bufferViews", "accessors", "materials", "images",
                           "textures", "cameras", "extensionsUsed", "extensions"}) {
    EXPECT_FALSE(file.root.contains(list)) << list << " must not be there rather than be empty";
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

/// Each change makes the rich scene impossible to write; the error has to name the culprit.
TEST_F(ExportTest, BrokenScenesAreRefusedByName) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refused = [this](auto change, const std::string& expected) {
    Scene scene = rich_scene();
    change(scene);
    const Result<void> result = export_gltf(scene, path("broken.glb"));
    ASSERT_FALSE(result) << expected;
    EXPECT_EQ(result.error().subject, path("broken.glb"));
    EXPECT_NE(result.error().reason.find(expected), std::string::npos) << result.error().reason;
    EXPECT_TRUE(fs::is_empty(folder_));
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
  // Nothing half-written stays behind.
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ExportTest, FailureKeepsTheOldFile) {
  ASSERT_TRUE(export_gltf(rich_scene(), path("kept.glb")));
  const std::string before = content_of(path("kept.glb"));
  Scene broken = rich_scene();
  broken.meshes[0].positions[0].x = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(export_gltf(broken, path("kept.glb")));
  EXPECT_EQ(content_of(path("kept.glb")), before);
}

/// A locale that writes commas and groups digits, without needing one to be installed.
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

void expect_equal(const TextureUse& a, const TextureUse& b) {
  EXPECT_EQ(a.texture, b.texture);
  EXPECT_EQ(a.texcoord, b.texcoord);
  EXPECT_EQ(a.scale, b.scale);
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(a.uv_transform[c][r], b.uv_transform[c][r], 1e-6f);
  }
}

void expect_equal(const Material& a, const Material& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.base_color, b.base_color);
  EXPECT_EQ(a.metallic, b.metallic);
  EXPECT_EQ(a.roughness, b.roughness);
  EXPECT_EQ(a.emissive, b.emissive);
  EXPECT_EQ(a.emissive_strength, b.emissive_strength);
  EXPECT_EQ(a.alpha_mode, b.alpha_mode);
  if (a.alpha_mode == AlphaMode::mask) {
    EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
  }
  EXPECT_EQ(a.double_sided, b.double_sided);
  EXPECT_EQ(a.unlit, b.unlit);
  EXPECT_EQ(a.ior, b.ior);
  EXPECT_EQ(a.transmission, b.transmission);
  EXPECT_EQ(a.specular, b.specular);
  EXPECT_EQ(a.specular_color, b.specular_color);
  EXPECT_EQ(a.dfr, b.dfr);
  EXPECT_EQ(a.film.factor, b.film.factor);
  EXPECT_EQ(a.film.ior, b.film.ior);
  EXPECT_EQ(a.film.thickness_min_nm, b.film.thickness_min_nm);
  EXPECT_EQ(a.film.thickness_max_nm, b.film.thickness_max_nm);
  EXPECT_EQ(a.anisotropy.strength, b.anisotropy.strength);
  EXPECT_EQ(a.anisotropy.rotation_rad, b.anisotropy.rotation_rad);
  EXPECT_EQ(a.diffuse_transmission.factor, b.diffuse_transmission.factor);
  EXPECT_EQ(a.diffuse_transmission.color, b.diffuse_transmission.color);
  EXPECT_EQ(a.volume.thickness, b.volume.thickness);
  EXPECT_EQ(a.volume.attenuation_distance, b.volume.attenuation_distance);
  EXPECT_EQ(a.volume.attenuation_color, b.volume.attenuation_color);
  EXPECT_EQ(a.volume.dispersion, b.volume.dispersion);
  EXPECT_EQ(a.coat.factor, b.coat.factor);
  EXPECT_EQ(a.coat.roughness, b.coat.roughness);
  EXPECT_EQ(a.sheen.color, b.sheen.color);
  EXPECT_EQ(a.sheen.roughness, b.sheen.roughness);
  const auto textures_a = texture_uses(a), textures_b = texture_uses(b);
  for (std::size_t i = 0; i < textures_a.size(); ++i) expect_equal(*textures_a[i], *textures_b[i]);
}

void expect_equal(const Camera& a, const Camera& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.type, b.type);
  EXPECT_EQ(a.aspect_ratio, b.aspect_ratio);
  if (a.type == Camera::Type::perspective) {
    EXPECT_EQ(a.fov_y_rad, b.fov_y_rad);
  } else {
    EXPECT_EQ(a.height, b.height);
  }
  for (int c = 0; c < 4; ++c) {
    EXPECT_LT(glm::length(a.world_from_camera[c] - b.world_from_camera[c]), 1e-12);
  }
}

void expect_equal(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.instances.size(), b.instances.size());
  for (std::size_t i = 0; i < a.instances.size(); ++i) {
    const Mesh& was = a.meshes.at(a.instances[i].mesh);
    const Mesh& is = b.meshes.at(b.instances[i].mesh);
    SCOPED_TRACE(a.instances[i].name);
    EXPECT_EQ(a.instances[i].name, b.instances[i].name);
    EXPECT_EQ(a.instances[i].world_from_mesh, b.instances[i].world_from_mesh);
    EXPECT_EQ(a.instances[i].shows_light, b.instances[i].shows_light);
    EXPECT_TRUE(was.positions == is.positions);
    EXPECT_TRUE(was.triangles == is.triangles);
    EXPECT_TRUE(was.colors == is.colors);
    EXPECT_EQ(was.material, is.material);
    ASSERT_EQ(was.normals.size(), is.normals.size());
    for (std::size_t v = 0; v < was.normals.size(); ++v) {
      ASSERT_LT(glm::length(was.normals[v] - is.normals[v]), 1e-6f);
    }
  }
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) {
    SCOPED_TRACE(a.materials[i].name);
    expect_equal(a.materials[i], b.materials[i]);
  }
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) test::expect_equal(a.lights[i], b.lights[i]);
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (std::size_t i = 0; i < a.cameras.size(); ++i) expect_equal(a.cameras[i], b.cameras[i]);
}

TEST_F(ExportTest, RoundTripOfARichScene) {
  for (const char* name : {"rich.glb", "a name with spaces \u00e9.gltf"}) {
    SCOPED_TRACE(name);
    const Scene scene = rich_scene();
    ASSERT_TRUE(export_gltf(scene, path(name)));
    const Result<Scene> back = import_gltf(path(name));
    ASSERT_TRUE(back) << back.error().message();
    expect_equal(scene, *back);
    EXPECT_TRUE(back->notes.warnings.empty());
    EXPECT_TRUE(back->notes.unsupported_extensions.empty());
    ASSERT_EQ(back->images.size(), 1u);
    EXPECT_EQ(back->images[0].rgba, scene.images[0].rgba);
    ASSERT_EQ(back->textures.size(), 2u);
    EXPECT_EQ(back->textures[0].wrap_u, Wrap::clamp_to_edge);
    EXPECT_EQ(back->textures[0].wrap_v, Wrap::mirrored_repeat);
    EXPECT_EQ(back->textures[0].filter, Filter::nearest);
  }
}

TEST_F(ExportTest, RoundTripOfEveryBuiltinScene) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    SCOPED_TRACE(builtin.name);
    const Scene scene = builtin.make();
    ASSERT_TRUE(export_gltf(scene, path(builtin.name + ".glb")));
    const Result<Scene> back = import_gltf(path(builtin.name + ".glb"));
    ASSERT_TRUE(back) << back.error().message();
    expect_equal(scene, *back);
    EXPECT_TRUE(back->notes.warnings.empty());
  }
}

}  // namespace
}  // namespace asos
