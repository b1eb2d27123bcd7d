#include "renderer/gltf/load.h"
#include "renderer/prepared/default_look.h"
#include "renderer/prepared/own_lights.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/work_counts.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

// The work for opening whole models, in counts that do not depend on the machine.

namespace asos::test::opening_counts_test {
namespace {

struct Opened {
  std::array<std::uint64_t, work_kinds> work{};
  std::uint64_t triangles = 0;
  std::uint64_t image_bytes = 0;

  [[nodiscard]] std::uint64_t of(Work kind) const { return work[static_cast<std::size_t>(kind)]; }
};

std::array<std::uint64_t, work_kinds> work_done() {
  std::array<std::uint64_t, work_kinds> now{};
  for (std::size_t i = 0; i < work_kinds; ++i) now[i] = WorkDone::of(static_cast<Work>(i));
  return now;
}

/// Opens a scene on its ground, as the programs do.
Opened opened(const std::string& source) {
  const auto before = work_done();
  Opened opened;
  const Result<Scene> scene = load_scene(source);
  if (!scene) throw std::runtime_error(scene.error().message());
  for (const Image& image : scene->images)
    opened.image_bytes += image.rgba.size() + image.low.size();
  const auto prepared = prepare_on_ground(*scene, {}, nullptr, [](const World& world, bool dark) {
    return GroundChoice{likely_ground(world, dark, first_camera(world))};
  });
  if (!prepared) throw std::runtime_error(prepared.error().message());
  opened.triangles = (*prepared)->world().triangles.size();
  opened.work = work_done();
  for (std::size_t i = 0; i < work_kinds; ++i) opened.work[i] -= before[i];
  return opened;
}

/// `pairs`, `lookups`: most coplanar pairs and emission look-ups per triangle. Each is twice what
/// the scene needs now.
void check(const std::string& source, double pairs, double lookups) {
  const Opened work = opened(source);
  SCOPED_TRACE(source);
  const auto triangles = static_cast<double>(work.triangles);
  EXPECT_EQ(work.of(Work::geometries), 1u);
  EXPECT_EQ(work.of(Work::boundary_searches), 0u) << "nothing needed edges";
  EXPECT_EQ(work.of(Work::decoded_bytes), work.image_bytes) << "each image is decoded once";
  EXPECT_LE(static_cast<double>(work.of(Work::coplanar_pairs)), pairs * triangles);
  EXPECT_LE(static_cast<double>(work.of(Work::emission_lookups)), lookups * triangles);
}

TEST(OpeningCounts, OfBuiltInScenes) {
  check("builtin:office", 0.8, 0.0);
  check("builtin:dense", 0.008, 0.0);
  check("builtin:neon", 0.8, 0.6);
}

TEST(OpeningCounts, OfSharedModels) {
  const auto shared = shared_dir();
  if (!shared || !std::filesystem::exists(*shared / "scenes/Bike/Bike.glb"))
    GTEST_SKIP() << "no Bike in the folder of test models";
  const auto model = [&](const char* path) { return (*shared / "scenes" / path).string(); };
  check(model("Bike/Bike.glb"), 1.2, 0.004);
  check(model("ToyCar/ToyCar.gltf"), 0.32, 4.6);
  check(model("AlphaBlendModeTest/AlphaBlendModeTest.glb"), 1.0, 0.0);
}

}  // namespace
}  // namespace asos::test::opening_counts_test
