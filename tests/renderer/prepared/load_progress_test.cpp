#include "renderer/load_progress.h"

#include "renderer/gltf/load.h"
#include "renderer/prepared/render_scene.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

// The stages of opening a scene, and its end at any stop point.

namespace asos::test::load_progress_test {
namespace {

/// Opens a file; returns whether it was stopped.
bool stops(const std::string& path, LoadProgress& progress) {
  const LoadProgress::Scope scope(&progress);
  try {
    const Result<Scene> scene = load_scene(path);
    EXPECT_TRUE(scene);
    if (scene) {
      EXPECT_TRUE(prepare(*scene));
    }
    return false;
  } catch (const LoadStopped&) {
    return true;
  }
}

/// A glowing grid of crossing squares with a texture.
GltfBuilder glowing_grid() {
  GltfBuilder b = GltfBuilder::square();
  const int uv = b.vec2({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  nlohmann::json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = uv;
  primitive["material"] = 0;
  b.json["images"] = {{{"uri", small_png}}};
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"] = {{{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}}};
  b.json["nodes"].clear();
  b.json["scenes"][0]["nodes"].clear();
  for (int i = 0; i < 40; ++i) {
    b.json["nodes"].push_back({{"mesh", 0}, {"translation", {0.3 * (i % 8), 0.3 * (i / 8), 0}}});
    b.json["scenes"][0]["nodes"].push_back(i);
  }
  return b;
}

TEST(LoadProgress, PassesAllStagesInOrder) {
  const TemporaryFolder folder;
  const std::string path = folder.write("grid.glb", glowing_grid().glb());
  std::vector<LoadStage> seen;
  LoadProgress* watched = nullptr;
  LoadProgress progress([&] {
    if (seen.empty() || seen.back() != watched->stage()) seen.push_back(watched->stage());
  });
  watched = &progress;
  EXPECT_FALSE(stops(path, progress));
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.size(), load_stage_count);
}

TEST(LoadProgress, EndsTheLoadAtEveryStopPoint) {
  const TemporaryFolder folder;
  const std::string path = folder.write("grid.glb", glowing_grid().glb());
  LoadProgress whole;
  ASSERT_FALSE(stops(path, whole));
  std::set<LoadStage> stages;
  // Embree's own points differ from run to run.
  const std::uint64_t last = whole.points() - std::min<std::uint64_t>(whole.points(), 20);
  ASSERT_GT(last, 100u);
  for (std::uint64_t point = 1; point <= last; point += 1 + last / 150) {
    LoadProgress progress;
    progress.stop_at(point);
    EXPECT_TRUE(stops(path, progress)) << point << " of " << last;
    stages.insert(progress.stage());
  }
  // A preparation that is not stopped still works.
  LoadProgress again;
  EXPECT_FALSE(stops(path, again));
  EXPECT_GE(stages.size(), load_stage_count - 1);
}

// Whatever a file contains, no stage is long without a stop point.
TEST(LoadProgress, HasStopPointsInEachStageOfAModel) {
  const auto shared = shared_dir();
  if (!shared || !std::filesystem::exists(*shared / "scenes/ToyCar/ToyCar.gltf"))
    GTEST_SKIP() << "no ToyCar in the folder of test models";
  std::vector<std::uint64_t> points;
  LoadProgress* watched = nullptr;
  std::vector<LoadStage> seen;
  LoadProgress progress([&] {
    if (!seen.empty() && seen.back() == watched->stage()) return;
    seen.push_back(watched->stage());
    points.push_back(watched->points());
  });
  watched = &progress;
  ASSERT_FALSE(stops((*shared / "scenes/ToyCar/ToyCar.gltf").string(), progress));
  ASSERT_EQ(seen.size(), load_stage_count);
  const auto passed = [&](LoadStage stage) {
    const auto i = static_cast<std::size_t>(stage);
    return points[i + 1] - points[i];
  };
  EXPECT_GE(passed(LoadStage::reading), 4u);
  EXPECT_GE(passed(LoadStage::textures), 4000u) << "each row of a picture has one";
  EXPECT_GE(passed(LoadStage::meshes), 12u);
  EXPECT_GE(passed(LoadStage::surfaces), 6u);
  EXPECT_GE(passed(LoadStage::lights), 1000u) << "each emitting triangle has one";
  EXPECT_GE(passed(LoadStage::rays), 100u) << "Embree and the search for coplanar triangles";
}

}  // namespace
}  // namespace asos::test::load_progress_test
