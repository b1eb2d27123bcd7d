#include "renderer/scene/load.h"
#include "renderer/scene/surroundings.h"
#include "tests/renderer/scene/gltf_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

// EXT_lights_image_based as files say it: scene/gltf/LIGHTS.md.

namespace asos::import_surroundings_test {
namespace {

using nlohmann::json;
using test::GltfBuilder;

constexpr const char* name = "EXT_lights_image_based";

/// 2 x 2 pixels of (255, 128, 0) and an alpha of 51.
constexpr const char* png_with_alpha =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAEUlEQVR4nGP438BgDMIMMAYA"
    "QuIGyeMPakYAAAAASUVORK5CYII=";

/// A square lit by a cube of 2 x 2 pictures, the last of which has alpha; `change` is made to it.
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
  const Surroundings& all = *scene.surroundings;
  EXPECT_EQ(all.intensity, 2.5f);
  for (std::size_t i = 0; i < all.sides.size(); ++i) {
    EXPECT_EQ(all.sides[i].image.width, 2) << i;
    EXPECT_EQ(all.sides[i].divided, i == 5) << i;
  }
  // Turned by 2 atan(0.6 / 0.8) about +Y.
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

}  // namespace
}  // namespace asos::import_surroundings_test
