#include "renderer/world/world.h"
#include "tests/renderer/gltf/load_timer.h"
#include "tests/support/flat_world.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace asos {
namespace {

namespace fs = std::filesystem;

using test::load_in_time;

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
    const Result<Scene> loaded = load_in_time(dir_ / "scenes" / row.at("file"));
    ASSERT_TRUE(loaded) << loaded.error().message();
    const Scene& scene = *loaded;
    EXPECT_EQ(scene.instanced_triangles(), std::stoull(row.at("triangles_instanced")));
    EXPECT_EQ(scene.lights.size(), std::stoull(row.at("punctual_lights")));
    EXPECT_EQ(scene.cameras.size(), std::stoull(row.at("cameras")));
    const Result<World> world = test::flat_world(scene);
    ASSERT_TRUE(world) << world.error().message();
    EXPECT_EQ(world->triangles.size(), scene.instanced_triangles());
    for (const glm::vec3 n : world->normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
  }
}

TEST_F(SharedFiles, OddFilesLoadOrAreRefusedByName) {
  // Valid files that need unsupported features or have no data; the error has to say so.
  const std::map<std::string, std::string> refused = {{"ACMEBox.gltf", "ACME_gizmo"},
                                                      {"BoxTextured.gltf", "KHR_technique_webgl"},
                                                      {"min_version_valid.gltf", "minVersion"},
                                                      {"Compatibility_04.gltf", "minVersion"},
                                                      {"unused_objects.gltf", "has no data"}};
  std::size_t loads = 0;
  for (const auto& row : read_index(dir_ / "odd" / "INDEX.tsv")) {
    const fs::path path = dir_ / "odd" / row.at("file");
    SCOPED_TRACE(path);
    const Result<Scene> loaded = load_in_time(path);
    if (loaded) {
      ++loads;
      EXPECT_TRUE(flatten(*loaded)) << flatten(*loaded).error().message();
      continue;
    }
    expect_named_error(path, loaded.error());
    const auto reason = refused.find(path.filename().string());
    ASSERT_NE(reason, refused.end()) << loaded.error().message();
    EXPECT_NE(loaded.error().reason.find(reason->second), std::string::npos)
        << loaded.error().message();
  }
  EXPECT_GE(loads, 150u);
}

TEST_F(SharedFiles, BadFilesGiveAnErrorOrAWarning) {
  // Defects that do not affect the picture, so that no warning is given.
  const std::map<std::string, std::string> harmless = {
      {"Animation_Skin_06.gltf", "joints without a common root are placed all the same"},
      {"box_sparse.glb", "an offset into no buffer view is not used"},
      {"mode5.gltf", "declared minima and maxima are not used"},
      {"meshopt-fallback.gltf", "its normals are a little off unit length, which is put right"}};
  for (const auto& row : read_index(dir_ / "bad" / "INDEX.tsv")) {
    const fs::path path = dir_ / "bad" / row.at("file");
    SCOPED_TRACE(path);
    const Result<Scene> loaded = load_in_time(path);
    if (!loaded) {
      expect_named_error(path, loaded.error());
    } else if (!harmless.contains(path.filename().string())) {
      EXPECT_FALSE(loaded->notes.warnings.empty());
      EXPECT_TRUE(flatten(*loaded));
    }
  }
}

}  // namespace
}  // namespace asos
