#include "tests/renderer/comparison/rival_scenes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace asos::test::average_test {
namespace {

World black_with_white(int x, int y) {
  World world;
  add_card(world, {-9, -9}, {17, 17}, unlit(glm::vec3(0)));
  const glm::vec2 at(static_cast<float>(x), static_cast<float>(y));
  add_card(world, at, at + 1.0f, unlit(glm::vec3(1)), 1.0f);
  return world;
}

TEST(Average, SpreadsAPixelOverItsNeighbours) {
  // The white pixel is in the block, at its border, in a corner, or outside the picture.
  for (const glm::ivec2 at : {glm::ivec2{3, 4}, {0, 5}, {7, 7}, {8, 8}, {-1, 2}}) {
    const auto scene = make_render_scene(black_with_white(at.x, at.y));
    const BlockResult r = render_small(*scene, settings_for(Method::average));
    EXPECT_EQ(r.statistics.eye_rays, 100u);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        const int dx = std::abs(x - at.x), dy = std::abs(y - at.y);
        const float expected =
            dx > 1 || dy > 1 ? 0.0f : static_cast<float>((2 - dx) * (2 - dy)) / 16.0f;
        EXPECT_EQ(red_at(r, x, y), expected) << at.x << ' ' << at.y << ": " << x << ' ' << y;
      }
    }
  }
}

TEST(Average, TakesOneSampleAPixelAndThoseAroundEachBlock) {
  const auto scene = make_render_scene(black_with_white(3, 4));
  RenderSettings settings = settings_for(Method::average, 64, 40);
  const Picture picture = render_picture(*scene, orthographic(8.0), settings);
  EXPECT_EQ(picture.statistics.eye_rays, 34u * 34u + 2u * 34u * 10u + 10u * 10u);
  EXPECT_EQ(picture.statistics.split_pixels, 0u);
}

TEST(Average, LeavesOutWhatIsNotFinite) {
  World world = black_with_white(3, 4);
  world.colors.assign(world.positions.size(), glm::vec4(1));
  for (std::size_t i = 4; i < 8; ++i) world.colors[i].r = std::numeric_limits<float>::quiet_NaN();
  const auto scene = make_render_scene(std::move(world));
  const BlockResult r = render_small(*scene, settings_for(Method::average));
  EXPECT_EQ(r.statistics.rejected_samples, 1u);
  for (const glm::vec3& c : r.tile.radiance) EXPECT_EQ(c, glm::vec3(0));
}

}  // namespace
}  // namespace asos::test::average_test
