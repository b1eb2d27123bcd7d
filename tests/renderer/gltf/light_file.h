#pragma once

#include "renderer/gltf/load.h"
#include "tests/renderer/gltf/gltf_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace asos::test {

/// A file with a square and one more node, the subject of the test.
class LightFile {
 public:
  LightFile() {
    builder_.json["scenes"][0]["nodes"] = {0, 1};
    node() = {{"name", "lamp"}};
  }

  nlohmann::json& node() { return builder_.json["nodes"][1]; }
  nlohmann::json& json() { return builder_.json; }
  /// Attaches `light` to the node through an extension.
  LightFile& with(const std::string& extension, nlohmann::json light) {
    builder_.json["extensionsUsed"].push_back(extension);
    builder_.json["extensions"][extension]["lights"] = {std::move(light)};
    node()["extensions"][extension]["light"] = 0;
    return *this;
  }
  LightFile& with_extras(nlohmann::json light) {
    node()["extras"]["asos_light"] = std::move(light);
    return *this;
  }
  /// Places the node; a quarter turn about +Y takes its -Z to -X and its X to -Z.
  LightFile& turned(glm::dvec3 translation, glm::dvec3 scale) {
    node()["translation"] = {translation.x, translation.y, translation.z};
    node()["rotation"] = {0.0, std::sqrt(0.5), 0.0, std::sqrt(0.5)};
    node()["scale"] = {scale.x, scale.y, scale.z};
    return *this;
  }

  [[nodiscard]] Scene load() const {
    const TemporaryFolder folder;
    Result<Scene> scene = import_gltf(folder.write("light.glb", builder_.glb()));
    if (!scene) throw std::runtime_error(scene.error().message());
    return std::move(*scene);
  }
  /// Returns the only light of the file, which must load without warnings.
  [[nodiscard]] Light light() const {
    const Scene scene = load();
    EXPECT_EQ(scene.notes.warnings, std::vector<std::string>());
    EXPECT_EQ(scene.lights.size(), 1u);
    return scene.lights.empty() ? Light() : scene.lights[0];
  }
  /// Expects that the light is ignored with a single warning that contains `words`.
  void expect_left_out(const std::string& words) const {
    const Scene scene = load();
    EXPECT_TRUE(scene.lights.empty()) << words;
    expect_warning(scene, words);
    expect_warning(scene, "lamp");
  }
  static void expect_warning(const Scene& scene, const std::string& words) {
    ASSERT_EQ(scene.notes.warnings.size(), 1u) << words;
    EXPECT_NE(scene.notes.warnings[0].find(words), std::string::npos) << scene.notes.warnings[0];
  }

 private:
  GltfBuilder builder_ = GltfBuilder::square();
};

}  // namespace asos::test
