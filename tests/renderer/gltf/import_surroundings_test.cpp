#include "renderer/files/read_file.h"
#include "renderer/gltf/load.h"
#include "renderer/scene/environment_cube.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

// EXT_lights_image_based in files: gltf/LIGHTS.md.

namespace asos::import_surroundings_test {
namespace {

using nlohmann::json;
using test::GltfBuilder;

constexpr const char* name = "EXT_lights_image_based";

/// 2 x 2 pixels of (255, 128, 0) and an alpha of 51.
constexpr const char* png_with_alpha =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAEUlEQVR4nGP438BgDMIMMAYA"
    "QuIGyeMPakYAAAAASUVORK5CYII=";

/// A square lit by a cube of 2 x 2 images, the last with alpha; `change` edits the file.
json file_of(const std::function<void(json& file, json& light)>& change = {}) {
  GltfBuilder b = GltfBuilder::square();
  json file = b.json;
  file["extensionsUsed"] = {name};
  file["images"] = {{{"uri", test::small_png}}, {{"uri", png_with_alpha}}};
  json light = {{"intensity", 2.5},
                {"rotation", {0.0, 0.6, 0.0, 0.8}},
                {"irradianceCoefficients", json(9, json{0.1, 0.2, 0.3})},
                {"specularImageSize", 2},
                {"specularImages", {{0, 0, 0, 0, 0, 1}}}};
  file["scenes"][0]["extensions"][name] = {{"light", 0}};
  if (change) change(file, light);
  file["extensions"][name]["lights"] = {light};
  b.json = file;
  return json{{"json", b.json}, {"bin", std::vector<int>(b.bin.begin(), b.bin.end())}};
}

Scene scene_of(const std::function<void(json& file, json& light)>& change = {}) {
  const json made = file_of(change);
  GltfBuilder b;
  b.json = made["json"];
  for (const int byte : made["bin"]) b.bin.push_back(static_cast<char>(byte));
  const test::TemporaryFolder folder;
  const Result<Scene> scene = import_gltf(folder.write("test.glb", b.glb()));
  EXPECT_TRUE(scene) << scene.error().message();
  return scene ? *scene : Scene{};
}

bool warns(const Scene& scene, const std::string& words) {
  const auto& all = scene.notes.warnings;
  return std::any_of(all.begin(), all.end(),
                     [&](const std::string& one) { return one.find(words) != std::string::npos; });
}

TEST(ImportSurroundings, AreRead) {
  const Scene scene = scene_of();
  ASSERT_TRUE(scene.surroundings);
  EXPECT_TRUE(scene.notes.warnings.empty());
  EXPECT_TRUE(scene.notes.unsupported_extensions.empty());
  const EnvironmentCube& all = *scene.surroundings;
  EXPECT_EQ(all.intensity, 2.5f);
  for (std::size_t i = 0; i < all.sides.size(); ++i) {
    EXPECT_EQ(all.sides[i].image.width, 2) << i;
    EXPECT_EQ(all.sides[i].divided, i == 5) << i;
  }
  // Rotated by 2 atan(0.6 / 0.8) about +Y.
  const glm::dvec3 turned = all.world_from_cube * glm::dvec3(1, 0, 0);
  EXPECT_NEAR(turned.x, 0.28, 1e-6);
  EXPECT_NEAR(turned.z, -0.96, 1e-6);
  EXPECT_FALSE(
      scene_of([](json& file, json&) { file["scenes"][0].erase("extensions"); }).surroundings);
}

TEST(ImportSurroundings, ThatAreBrokenAreLeftOutAndNamed) {
  struct Broken {
    std::string says;
    std::function<void(json& file, json& light)> change;
  };
  const std::vector<Broken> all{
      {"does not exist",
       [](json& file, json&) { file["scenes"][0]["extensions"][name]["light"] = 7; }},
      {"does not exist",
       [](json& file, json&) { file["scenes"][0]["extensions"][name]["light"] = "x"; }},
      {"intensity", [](json&, json& light) { light["intensity"] = -1; }},
      {"rotation",
       [](json&, json& light) {
         light["rotation"] = {0, 0, 0};
       }},
      {"quaternion",
       [](json&, json& light) {
         light["rotation"] = {0, 0, 0, 0};
       }},
      {"irradianceCoefficients", [](json&, json& light) { light.erase("irradianceCoefficients"); }},
      {"irradianceCoefficients",
       [](json&, json& light) {
         light["irradianceCoefficients"] = json(9, json{1, 2});
       }},
      {"specularImages", [](json&, json& light) { light.erase("specularImages"); }},
      {"specularImages", [](json&, json& light) { light["specularImages"] = json::array(); }},
      {"not six",
       [](json&, json& light) {
         light["specularImages"] = {{0, 0, 0, 0, 0}};
       }},
      {"not six",
       [](json&, json& light) {
         light["specularImages"] = {{0, 0, 0, 0, 0, "x"}};
       }},
      {"image 9",
       [](json&, json& light) {
         light["specularImages"] = {{0, 0, 9, 0, 0, 0}};
       }},
      {"image 0",
       [](json& file, json&) {
         file["images"][0] = {{"uri", "missing.png"}};
       }},
      {"image 0", [](json& file, json&) {
         const std::string cut = std::string(test::small_png).substr(0, 70);
         file["images"][0] = {{"uri", cut}};
       }}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Scene scene = scene_of(all[i].change);
    EXPECT_FALSE(scene.surroundings) << i;
    EXPECT_TRUE(warns(scene, "image-based light")) << i;
    EXPECT_TRUE(warns(scene, all[i].says)) << i << ' ' << all[i].says;
  }
  const Scene other_size = scene_of([](json&, json& light) { light["specularImageSize"] = 256; });
  EXPECT_TRUE(other_size.surroundings);
  EXPECT_TRUE(warns(other_size, "specularImageSize"));
}

// The surroundings are the same after export and import, with or without division by alpha.
TEST(ImportSurroundings, AreWrittenAsTheyWereRead) {
  const Scene scene = scene_of([](json&, json& light) { light["name"] = "dusk"; });
  const test::TemporaryFolder folder;
  const std::string path = folder.write("again.glb", "");
  ASSERT_TRUE(export_gltf(scene, path));
  const Result<Scene> again = import_gltf(path);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_TRUE(again->notes.warnings.empty()) << testing::PrintToString(again->notes.warnings);
  ASSERT_TRUE(again->surroundings);
  const EnvironmentCube &a = *scene.surroundings, &b = *again->surroundings;
  EXPECT_EQ(b.name, "dusk");
  EXPECT_EQ(b.intensity, a.intensity);
  for (std::size_t i = 0; i < a.sides.size(); ++i) {
    EXPECT_EQ(b.sides[i].image.rgba, a.sides[i].image.rgba) << i;
    EXPECT_EQ(b.sides[i].divided, a.sides[i].divided) << i;
  }
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r)
      EXPECT_NEAR(b.world_from_cube[c][r], a.world_from_cube[c][r], 1e-12);
  }
}

// A cube that emits on one side only. A surface facing that side's centre receives the form factor
// of a cube's face from its centre, 0.554 of pi (by numerical integration of the cosine); a surface
// facing away receives nothing. Three bands of spherical harmonics are within 9 percent of the
// largest irradiance (Ramamoorthi and Hanrahan 2001).
TEST(ImportSurroundings, AreWrittenWithTheirIrradiance) {
  for (std::size_t lit = 0; lit < 6; ++lit) {
    Scene scene = scene_of();
    auto cube = std::make_shared<EnvironmentCube>();
    for (std::size_t i = 0; i < 6; ++i) {
      cube->sides[i].image.width = cube->sides[i].image.height = 32;
      const auto value = static_cast<std::uint8_t>(i == lit ? 255 : 0);
      cube->sides[i].image.rgba = std::vector<std::uint8_t>(32 * 32 * 4, value);
    }
    scene.surroundings = cube;
    const test::TemporaryFolder folder;
    const std::string path = folder.write("cube.gltf", "");
    ASSERT_TRUE(export_gltf(scene, path));
    const auto bytes = read_file(path, {.most_bytes = 1u << 20});
    ASSERT_TRUE(bytes);
    const json file = json::parse(bytes->begin(), bytes->end());
    const json& c = file["extensions"][name]["lights"][0]["irradianceCoefficients"];
    const auto irradiance = [&](const glm::dvec3& n) {
      const double basis[9] = {0.282095,
                               0.488603 * n.y,
                               0.488603 * n.z,
                               0.488603 * n.x,
                               1.092548 * n.x * n.y,
                               1.092548 * n.y * n.z,
                               0.315392 * (3 * n.z * n.z - 1),
                               1.092548 * n.x * n.z,
                               0.546274 * (n.x * n.x - n.y * n.y)};
      double sum = 0.0;
      for (std::size_t k = 0; k < 9; ++k) sum += basis[k] * c[k][1].get<double>();
      return sum;
    };
    double facing = 0.0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) {
        const double u = (x + 0.5) / 100 - 1, v = (y + 0.5) / 100 - 1;
        facing += 1e-4 / ((1 + u * u + v * v) * (1 + u * u + v * v));
      }
    }
    glm::dvec3 normal(0.0);
    normal[static_cast<int>(lit / 2)] = lit % 2 == 0 ? 1.0 : -1.0;
    EXPECT_NEAR(irradiance(normal), facing, 0.09 * facing) << lit;
    EXPECT_NEAR(irradiance(-normal), 0.0, 0.09 * facing) << lit;
    const glm::dvec3 across(normal.y, normal.z, normal.x);
    EXPECT_NEAR(irradiance(across), irradiance(-across), 1e-6) << lit;
  }
}

}  // namespace
}  // namespace asos::import_surroundings_test
