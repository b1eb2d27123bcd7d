#include "renderer/load_progress.h"

#include "renderer/gltf/load.h"
#include "renderer/prepared/render_scene.h"
#include "tests/renderer/gltf/gltf_builder.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

/// Opens a file, and returns the number of stop points in each stage.
std::array<std::uint64_t, load_stage_count> points_by_stage(const std::string& path) {
  std::array<std::uint64_t, load_stage_count> points{};
  LoadProgress* watched = nullptr;
  std::uint64_t before = 0;
  std::size_t stage = 0;
  const auto end_stage = [&] {
    points[stage] += watched->points() - before;
    before = watched->points();
    stage = static_cast<std::size_t>(watched->stage());
  };
  LoadProgress progress(end_stage);
  watched = &progress;
  EXPECT_FALSE(stops(path, progress));
  end_stage();
  return points;
}

// One accessor, its tangents, the JSON, and the search for default lights are long by themselves.
TEST(LoadProgress, HasStopPointsWithinLargeParts) {
  GltfBuilder b = GltfBuilder::square();
  constexpr int side = 600;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> uv;
  std::vector<std::uint32_t> indices;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      positions.emplace_back(x, y, 0);
      uv.emplace_back(static_cast<float>(x) / side, static_cast<float>(y) / side);
      if (x == side || y == side) continue;
      const auto i = static_cast<std::uint32_t>(y * (side + 1) + x);
      for (const std::uint32_t corner : {0u, 1u, side + 2u, 0u, side + 2u, side + 1u})
        indices.push_back(i + corner);
    }
  }
  const TemporaryFolder folder;
  const auto small = points_by_stage(folder.write("small.glb", b.glb()));
  const int p = b.vec3(positions), t = b.vec2(uv);
  const int n = b.vec3(std::vector<glm::vec3>(positions.size(), glm::vec3(0, 0, 1)));
  const int i = b.accessor(b.view(indices), 5125, "SCALAR", indices.size());
  nlohmann::json& primitive = b.primitive({{"POSITION", p}, {"NORMAL", n}, {"TEXCOORD_0", t}});
  primitive["indices"] = i;
  const auto flat = points_by_stage(folder.write("flat.glb", b.glb()));
  primitive["material"] = 0;
  b.json["images"] = {{{"uri", small_png}}};
  b.json["textures"] = {{{"source", 0}}};
  b.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
  b.json["extras"] = std::string(1u << 20, 'x');
  const auto large = points_by_stage(folder.write("large.glb", b.glb()));
  const auto of = [](const auto& points, LoadStage stage) {
    return points[static_cast<std::size_t>(stage)];
  };
  constexpr std::uint64_t vertices = (side + 1) * (side + 1), triangles = 2 * side * side;
  EXPECT_GE(of(flat, LoadStage::meshes), of(small, LoadStage::meshes) + vertices / 65536);
  EXPECT_GE(of(large, LoadStage::meshes),
            of(flat, LoadStage::meshes) + (vertices + triangles) / 16384);
  EXPECT_GE(of(large, LoadStage::reading), of(flat, LoadStage::reading) + 8)
      << "a megabyte of JSON";
  EXPECT_GE(of(small, LoadStage::finishing), 18u) << "rows of the search for default lights";
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
