#include "renderer/gltf/load.h"
#include "tests/support/flat_mesh.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <string>

// Hidden geometry adds almost no cost, counted in pyrays and rays.

namespace asos::test::hidden_cost_test {
namespace {

std::uint64_t pyrays_of(const RenderStatistics& statistics) {
  const auto& levels = statistics.pyrays_by_level;
  return std::accumulate(levels.begin(), levels.end(), std::uint64_t{0});
}

TEST(HiddenCost, AWallBeforeAMillionTrianglesCostsAsMuchAsTheWall) {
  auto loaded = load_scene("builtin:dense");
  ASSERT_TRUE(loaded) << loaded.error().message();
  Scene& dense = *loaded;
  Scene bare = dense;
  bare.meshes.clear();
  bare.instances.clear();
  add_wall_before_camera(bare);
  add_wall_before_camera(dense);
  const auto alone = prepare(bare);
  const auto before = prepare(dense);
  ASSERT_TRUE(alone && before);
  RenderSettings settings = make_settings(320, 180);
  for (const bool shadows : {false, true}) {
    settings.shadow.cast = shadows;
    const auto count = [&](const RenderScene& scene) {
      return render_picture(scene, scene.world().cameras.front(), settings).statistics;
    };
    const RenderStatistics a = count(**alone);
    const RenderStatistics b = count(**before);
    EXPECT_LE(10 * b.eye_rays, 13 * a.eye_rays);
    EXPECT_LE(10 * pyrays_of(b), 13 * pyrays_of(a));
    EXPECT_EQ(b.missed_splits, 0u);
    if (!shadows) continue;
    EXPECT_GT(a.shadow_rays, 0u);
    EXPECT_LE(10 * b.shadow_rays, 13 * a.shadow_rays);
    RecordProperty("shadow_rays_alone", std::to_string(a.shadow_rays));
    RecordProperty("shadow_rays_before_dense", std::to_string(b.shadow_rays));
  }
}

}  // namespace
}  // namespace asos::test::hidden_cost_test
