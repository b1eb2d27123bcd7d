#include "renderer/shadows/shadow_groups.h"

#include "renderer/geometry/view.h"
#include "renderer/gltf/load.h"
#include "renderer/shading/footprint.h"
#include "tests/support/sample_lights.h"
#include "tests/support/shadow_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Groups of points get the same visibility as each point alone.

namespace asos::test::shadow_groups_test {
namespace {

constexpr int side = 8;  // of a block

struct Block {
  View view;
  PixelRect rect;
};

/// Visibility of a light for the pixels of a block, with groups or one by one.
std::vector<double> shares_of(const ShadowFixture& fixture, const Block& block, bool together,
                              RenderStatistics& counts) {
  const World& world = fixture.world();
  const RenderFeatures render_features = find_render_features(world);
  const ShadowScene scene{world, fixture.features(), fixture.rays()};
  const PixelSpacing spacing = PixelSpacing::of(block.view);
  const Frame frame = block.view.frame(block.rect.x, block.rect.y, side, side);
  ShadowGroups groups(scene);
  ShadowWorkspace work;
  NoView view;
  ShadowContext context;
  context.scene = &scene;
  context.rules.error_budget.max_level = 5;
  context.frame = &frame;
  context.view = &view;
  context.groups = &groups;
  context.work = &work;
  groups.reset(1);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < side * side; ++i) {
    const Ray ray = block.view.ray(block.rect.x + i % side + 0.5, block.rect.y + i / side + 0.5);
    const Hit hit = fixture.rays().closest(ray);
    if (!hit.valid()) {
      points.emplace_back();
      continue;
    }
    points.push_back(surface_point(world, render_features, hit, -ray.direction));
    const Patch patch =
        patch_on_plane(spacing, ray.direction, hit.t, points.back().geometric_normal, 1.0f);
    if (together) groups.add(hit, points.back().position, points.back().geometric_normal, patch);
  }
  std::vector<double> shares;
  constexpr float pixel = 1.0f / side;
  for (int i = 0; i < side * side; ++i) {
    const SurfacePoint& point = points[static_cast<std::size_t>(i)];
    const Square square{pixel * static_cast<float>(i % side), pixel * static_cast<float>(i / side),
                        pixel};
    if (point.triangle == Hit::none) continue;
    if (!(unshadowed_irradiance(fixture.light(), receiver_at(point)).x > 0.0f)) continue;
    const Leaf leaf = leaf_of({square, {}}, pixel, 3);
    const Estimate seen = light_visibility(
        context, {fixture.light(), 0, point, glm::vec3(1.0f), glm::vec3(1.0f), 0}, leaf, counts);
    shares.push_back(seen.value.x);
  }
  return shares;
}

/// `allowed`: RMS difference over all pixels.
void expect_same_shares(const std::string& name, const std::vector<Light>& lights, double allowed) {
  const Scene scene = load_scene("builtin:" + name).value();
  const World world = flatten(scene).value().world;
  const Camera camera = world.cameras.front();
  const View view(camera, 96, 64);
  double worst = 0.0;
  int all_shaded = 0;
  for (Light light : lights) {
    // A few units above the objects and to their side.
    light = scaled(light, 2.0);
    light.position += glm::dvec3(-1.0, 0.5, 1.5);
    for (auto& outline : light.outlines)
      for (glm::dvec3& corner : outline) corner += glm::dvec3(-1.0, 0.5, 1.5);
    ShadowFixture fixture(world, light);
    RenderStatistics together, alone;
    int shaded = 0, lit = 0, count = 0;
    double sum2 = 0.0;
    for (int y = 0; y < 64; y += side) {
      for (int x = (y / side) % 2 * side; x < 96; x += 2 * side) {
        const Block block{view, {x, y, side, side}};
        const auto grouped = shares_of(fixture, block, true, together);
        const auto single = shares_of(fixture, block, false, alone);
        ASSERT_EQ(grouped.size(), single.size());
        for (std::size_t i = 0; i < single.size(); ++i) {
          const double off = std::abs(grouped[i] - single[i]);
          sum2 += off * off;
          ++count;
          worst = std::max(worst, off);
          shaded += single[i] < 1e-6;
          lit += single[i] > 1.0 - 1e-6;
        }
      }
    }
    EXPECT_LT(std::sqrt(sum2 / count), allowed) << light.name;
    all_shaded += shaded;
    EXPECT_GT(lit, 20) << light.name;
    EXPECT_LT(together.shadow_rays, alone.shadow_rays) << light.name;
  }
  EXPECT_GT(all_shaded, 20);
  testing::Test::RecordProperty("worst_error", testing::PrintToString(worst));
}

TEST(ShadowGroups, MatchSinglePoints) {
  expect_same_shares("boxes", all_lights(), 1e-5);
}

// Outlines of fine meshes are cut along chains that depend on the hit list's contents: equal within
// a finest cell.
TEST(ShadowGroups, MatchSinglePointsForFineMeshes) {
  expect_same_shares("primitives", all_lights(), std::ldexp(1.0, -10));
  expect_same_shares("primitives-rectangle", all_lights(), std::ldexp(1.0, -10));
}

}  // namespace
}  // namespace asos::test::shadow_groups_test
