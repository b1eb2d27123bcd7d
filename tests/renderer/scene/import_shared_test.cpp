#include "renderer/scene/load.h"
#include "renderer/scene/world.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace asos {
namespace {

namespace fs = std::filesystem;

/// The rows of an INDEX.tsv as column name -> text.
std::vector<std::map<std::string, std::string>> read_index(const fs::path& path) {
  std::vector<std::map<std::string, std::string>> rows;
  std::vector<std::string> names;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, '\t');) cells.push_back(cell);
    if (names.empty()) {
      names = cells;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < cells.size() && i < names.size(); ++i) {
      rows.back()[names[i]] = cells[i];
    }
  }
  return rows;
}

struct Loaded {
  Result<Scene> scene;
  double seconds = 0.0;
};

/// Loading takes one thread, whose processor time does not depend on what else the machine does.
Loaded load_timed(const fs::path& path) {
  const std::clock_t start = std::clock();
  Loaded loaded{load_scene(path.string())};
  loaded.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return loaded;
}

void expect_named_error(const fs::path& file, const Error& error) {
  EXPECT_NE(error.message().find(file.filename().string()), std::string::npos) << error.message();
  EXPECT_GT(error.reason.size(), 10u) << error.message();
}

class SharedFiles : public testing::Test {
 protected:
  void SetUp() override {
    const auto dir = test::shared_dir();
    if (!dir) GTEST_SKIP() << "no models: set ASOS_SHARED to a folder with scenes/, odd/ and bad/";
    dir_ = *dir;
  }
  fs::path dir_;
};

TEST_F(SharedFiles, ScenesHaveTheirTrianglesLightsAndCameras) {
  for (const auto& row : read_index(dir_ / "scenes" / "INDEX.tsv")) {
    SCOPED_TRACE(row.at("file"));
    const Loaded loaded = load_timed(dir_ / "scenes" / row.at("file"));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().message();
    const Scene& scene = *loaded.scene;
    EXPECT_EQ(scene.instanced_triangles(), std::stoull(row.at("triangles_instanced")));
    EXPECT_EQ(scene.lights.size(), std::stoull(row.at("punctual_lights")));
    EXPECT_EQ(scene.cameras.size(), std::stoull(row.at("cameras")));
    EXPECT_LT(loaded.seconds, 5.0);
    const Result<World> world = flatten(scene);
    ASSERT_TRUE(world) << world.error().message();
    EXPECT_EQ(world->triangles.size(), scene.instanced_triangles());
    for (const glm::vec3 n : world->normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
  }
}

TEST_F(SharedFiles, OddFilesLoadOrAreRefusedByName) {
  // These are valid but ask for what is not supported, or hold no data; each refusal's reason has
  // to say so.
  const std::map<std::string, std::string> refused = {
      {"ACMEBox.gltf", "ACME_gizmo"},
      {"BoxTextured.gltf", "KHR_technique_webgl"},
      {"ClearCoatCarPaint.glb", "KHR_materials_clearcoat"},
      {"min_version_valid.gltf", "minVersion"},
      {"Compatibility_04.gltf", "minVersion"},
      {"unused_objects.gltf", "has no data"}};
  std::size_t loads = 0;
  for (const auto& row : read_index(dir_ / "odd" / "INDEX.tsv")) {
    const fs::path path = dir_ / "odd" / row.at("file");
    SCOPED_TRACE(path);
    const Loaded loaded = load_timed(path);
    EXPECT_LT(loaded.seconds, 5.0);
    if (loaded.scene) {
      ++loads;
      EXPECT_TRUE(flatten(*loaded.scene)) << flatten(*loaded.scene).error().message();
      continue;
    }
    expect_named_error(path, loaded.scene.error());
    const auto reason = refused.find(path.filename().string());
    ASSERT_NE(reason, refused.end()) << loaded.scene.error().message();
    EXPECT_NE(loaded.scene.error().reason.find(reason->second), std::string::npos)
        << loaded.scene.error().message();
  }
  EXPECT_GE(loads, 150u);
}

TEST_F(SharedFiles, BadFilesGiveAnErrorOrAWarning) {
  // Faults that change nothing of what is drawn, so that no word is lost on them.
  const std::map<std::string, std::string> harmless = {
      {"Animation_Skin_06.gltf", "joints without a common root are placed all the same"},
      {"box_sparse.glb", "an offset into no buffer view is not used"},
      {"mode5.gltf", "declared minima and maxima are not used"},
      {"meshopt-fallback.gltf", "its normals are a little off unit length, which is put right"}};
  for (const auto& row : read_index(dir_ / "bad" / "INDEX.tsv")) {
    const fs::path path = dir_ / "bad" / row.at("file");
    SCOPED_TRACE(path);
    const Loaded loaded = load_timed(path);
    EXPECT_LT(loaded.seconds, 5.0);
    if (!loaded.scene) {
      expect_named_error(path, loaded.scene.error());
    } else if (!harmless.contains(path.filename().string())) {
      EXPECT_FALSE(loaded.scene->notes.warnings.empty());
      EXPECT_TRUE(flatten(*loaded.scene));
    }
  }
}

}  // namespace
}  // namespace asos
