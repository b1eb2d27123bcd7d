#include "renderer/asos/highlight_rays.h"

#include "tests/support/eye_block.h"
#include "tests/support/make_light.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <utility>

namespace asos::test::highlight_rays_test {
namespace {

Material metal() {
  return {.metallic = 1.0f, .roughness = 0.3f};
}

/// A metal wall opposite a panel behind the camera. A plate hides the panel at coordinates above x.
EyeBlock wall_behind(float x) {
  World world;
  add_quad(world, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, metal());
  Material plate = matte({0.5f, 0.5f, 0.5f});
  plate.double_sided = true;
  add_quad(world, {x, -40, 15}, {80, 0, 0}, {0, 80, 0}, plate);
  const Light panel = make_panel({0, 0, 20}, {0, 0, -1}, {20, 0, 0}, {0, 20, 0});
  return EyeBlock(make_render_scene(std::move(world), {panel}), orthographic(16.0));
}

TEST(HighlightRays, ReachALightThatNothingHides) {
  const EyeBlock block = wall_behind(60.0f);
  const Leaf leaf = block.leaf(1, 1);
  EXPECT_TRUE(shows_highlight(block.eye(), 0, leaf.point, leaf.to_viewer()));
  const auto [sent, arrived] =
      rays_to_highlight(block.eye(), 0, leaf.point, leaf.to_viewer(), 0.3f);
  EXPECT_EQ(sent, 13);
  EXPECT_EQ(arrived, sent);
}

TEST(HighlightRays, DoNotReachALightThatIsHidden) {
  const EyeBlock block = wall_behind(-40.0f);
  const Leaf leaf = block.leaf(1, 1);
  EXPECT_FALSE(shows_highlight(block.eye(), 0, leaf.point, leaf.to_viewer()));
  EXPECT_EQ(rays_to_highlight(block.eye(), 0, leaf.point, leaf.to_viewer(), 0.3f).arrived, 0);
}

// The plate's edge crosses the lobe, so some of the lobe's rays reach the light.
TEST(HighlightRays, ReachAPartOfALightThatIsHalfHidden) {
  const EyeBlock block = wall_behind(-0.5f);
  const Leaf leaf = block.leaf(1, 1);
  const auto [sent, arrived] =
      rays_to_highlight(block.eye(), 0, leaf.point, leaf.to_viewer(), 0.3f);
  EXPECT_GT(arrived, 2);
  EXPECT_LT(arrived, sent - 2);
}

}  // namespace
}  // namespace asos::test::highlight_rays_test
