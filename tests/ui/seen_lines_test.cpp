#include "ui/panels/seen_lines.h"

#include "renderer/prepared/render_scene.h"
#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

namespace asos::test::seen_lines_test {
using namespace ui;
namespace {

// Two triangles, seen from (0, 0, 3). The nearer one, in the plane z = 0, extends from x = -0.479
// to 0.544 at y = 0, and hides 4/3 of that one unit behind it.
class SeenLines : public PanelsTest {
 protected:
  SeenLines() : PanelsTest(1, {960, 520}) {}
  /// The parts of a line, in the author's coordinates.
  [[nodiscard]] std::vector<LinePart> parts(glm::dvec3 a, glm::dvec3 b) {
    const RenderScene& scene = *rig.scene();
    const glm::dvec3 origin = scene.world().origin;
    std::vector<LinePart> found =
        seen_parts(scene.rays(), rig.viewpoint().view(), Culling::none, a - origin, b - origin);
    for (LinePart& part : found) part.from += origin, part.to += origin;
    return found;
  }
};

TEST_F(SeenLines, WhatASurfaceIsBeforeIsHidden) {
  const std::vector<LinePart> found = parts({-2, 0, -1}, {2, 0, -1});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_FALSE(found[0].hidden);
  EXPECT_TRUE(found[1].hidden);
  EXPECT_FALSE(found[2].hidden);
  EXPECT_LT(glm::distance(found[0].from, glm::dvec3(-2, 0, -1)), 1e-12);
  EXPECT_NEAR(found[1].from.x, -4.0 / 3.0 * 0.47895, 2e-3);
  EXPECT_NEAR(found[1].to.x, 4.0 / 3.0 * 0.54444, 2e-3);
  EXPECT_EQ(found[0].to, found[1].from);
  EXPECT_EQ(found[1].to, found[2].from);
  EXPECT_LT(glm::distance(found[2].to, glm::dvec3(2, 0, -1)), 1e-12);
}

TEST_F(SeenLines, InFrontOfASurfaceOrInItNothingIsHidden) {
  for (const double z : {0.5, 0.0}) {
    const std::vector<LinePart> found = parts({-2, 0, z}, {2, 0, z});
    ASSERT_EQ(found.size(), 1u) << z;
    EXPECT_FALSE(found[0].hidden) << z;
  }
  // Lines from in front of the triangle to behind it, and past the viewer.
  EXPECT_EQ(parts({0, 0, 1}, {0, 0, -1}).size(), 2u);
  EXPECT_FALSE(parts({0, 0, 1}, {0.1, 0, 9}).back().hidden);
}

// A floor of a hundred units has lines of three hundred, while the objects on it are small.
TEST_F(SeenLines, ALongLineGoesBehindWhatIsSmallBesideIt) {
  const std::vector<LinePart> found = parts({-150, 0, -1}, {151.5, 0, -1});
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(found[1].hidden);
  EXPECT_NEAR(found[1].from.x, -4.0 / 3.0 * 0.47895, 2e-3);
  EXPECT_NEAR(found[1].to.x, 4.0 / 3.0 * 0.54444, 2e-3);
  EXPECT_TRUE(parts({0, 9, -1}, {1, 9, -1}).empty()) << "above the picture";
  EXPECT_TRUE(parts({0, 0, 4}, {1, 0, 5}).empty()) << "behind the viewer";
}

// The triangle hides the grid behind it, but the axes stay visible.
TEST_F(SeenLines, TheGridGoesBehindWhatStandsOnIt) {
  rig.set_blind(false);
  rig.frame();
  const std::vector<glm::u8vec3> before = rig.pixels();
  display().show_grid = true;
  rig.frame();
  const std::vector<glm::u8vec3> with = rig.pixels();
  const Viewpoint& viewpoint = rig.viewpoint();
  const PixelRect area = rig.content().picture_rect();
  int hidden = 0, drawn_in_front = 0, beside = 0;
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      const auto i = static_cast<std::size_t>(y * rig.size().x + x);
      const Hit hit = viewpoint.seen_at(x + 0.5, y + 0.5);
      if (hit.valid() && hit.triangle == 0) {
        ++hidden;
        drawn_in_front += with[i] != before[i];
      } else {
        beside += with[i] != before[i];
      }
    }
  }
  EXPECT_GT(hidden, 1000);
  // Only the border, where lines end, and the axes are drawn.
  EXPECT_LT(drawn_in_front, hidden / 20);
  EXPECT_GT(beside, 200);
}

}  // namespace
}  // namespace asos::test::seen_lines_test
