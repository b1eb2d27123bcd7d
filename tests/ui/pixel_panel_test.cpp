#include "renderer/film/split_map.h"
#include "tests/ui/panels_fixture.h"
#include "ui/pixel_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

namespace asos {
using namespace ui;
namespace {

using test::PanelsTest;

class PixelPanelTest : public PanelsTest {
 protected:
  PixelPanelTest() : PanelsTest(1) {}
  /// A pixel that only the left edge of the red triangle crosses.
  [[nodiscard]] glm::ivec2 cut_pixel() {
    const Film& film = rig.film();
    // A little above the centre of a picture that shows 2.8 units vertically: there the edge is
    // well inside, and the grey triangle has not started.
    const int y = film.height / 2 - film.height / 28;
    for (int x = 1; x + 1 < film.width; ++x) {
      const float share = film.radiance[film.index(x, y)].x;
      const bool split = film.cause[film.index(x, y)] != SplitCause::none;
      if (split && share > 0.3f && share < 0.7f) return {x, y};
    }
    ADD_FAILURE() << "no edge";
    return {0, 0};
  }
  /// With Ctrl, so that the first click inspects.
  void click(glm::ivec2 pixel) {
    rig.move_to(glm::vec2(pixel) + 0.5f);
    rig.input().add(KeyChanged{Key::ctrl, true});
    rig.press(MouseButton::left);
    rig.release(MouseButton::left);
    rig.input().add(KeyChanged{Key::ctrl, false});
    rig.frame();
  }
  void pick(glm::ivec2 pixel) {
    click(pixel);
    ASSERT_EQ(rig.state().picked, pixel);
    ASSERT_TRUE(rig.frames_until([&] { return rig.controls().contains("Subdivision"); }));
    rig.move_to({-10.0f, -10.0f});
    for (int i = 0; i < 5; ++i) rig.frame();
  }
  [[nodiscard]] glm::u8vec3 at(const std::vector<glm::u8vec3>& pixels, glm::ivec2 p) const {
    return pixels[static_cast<std::size_t>(p.y * rig.size().x + p.x)];
  }
};

TEST_F(PixelPanelTest, TheSquareShowsWhatThePixelConsistsOf) {
  const glm::ivec2 pixel = cut_pixel();
  const Film& film = rig.film();
  const glm::vec3 mean = film.radiance[film.index(pixel.x, pixel.y)];
  const glm::vec3 sky = film.radiance[film.index(pixel.x - 5, pixel.y)];
  const float covered = (mean.x - sky.x) / (1.0f - sky.x);
  pick(pixel);
  const Controls::Placed square = rig.control("Subdivision");
  const std::vector<glm::u8vec3> pixels = rig.pixels();
  const DisplayTransform display = test::usual_display;
  const glm::u8vec3 red = display_bytes({1, 0, 0}, {});  // the triangle is unlit: no tone curve
  const glm::u8vec3 background = display_bytes(sky, display);
  int reds = 0, backgrounds = 0;
  for (int y = static_cast<int>(square.lo.y) + 2; y < static_cast<int>(square.hi.y) - 2; ++y) {
    for (int x = static_cast<int>(square.lo.x) + 2; x < static_cast<int>(square.hi.x) - 2; ++x) {
      reds += at(pixels, {x, y}) == red;
      backgrounds += at(pixels, {x, y}) == background;
    }
  }
  // Edge lines and samples cover the rest.
  const float area = (square.hi.x - square.lo.x) * (square.hi.y - square.lo.y);
  EXPECT_GT(static_cast<float>(reds + backgrounds), 0.85f * area);
  EXPECT_NEAR(static_cast<float>(reds) / static_cast<float>(reds + backgrounds), covered, 0.04f);
  EXPECT_TRUE(rig.controls().contains("Verdict"));
  EXPECT_FALSE(restarted()) << "looking at a pixel renders nothing again";
}

// The parts were once squares of a grid, so that an oblique edge was a staircase.
TEST_F(PixelPanelTest, TheSquareHasTheExactSidesOfItsParts) {
  const glm::ivec2 pixel = cut_pixel();
  PixelInspector inspector;
  ASSERT_TRUE(rig.frames_until([&] {
    inspector.update(rig.previewer(), pixel, false);
    return inspector.report() != nullptr && !inspector.busy();
  }));
  const PixelReport& report = *inspector.report();
  std::map<float, double> area, weight;  // by the colour's red
  for (const SeenPart& part : report.seen) area[part.radiance.x] += part.area();
  for (const TracedCell& cell : report.trace.cells)
    for (const TracedSample& sample : cell.samples) weight[sample.radiance.x] += sample.weight;
  ASSERT_EQ(area.size(), weight.size());
  EXPECT_GE(area.size(), 2u);
  for (const auto& [red, share] : weight) EXPECT_NEAR(area[red], share, 1e-5) << red;
}

// Once weight and visibility had changed their places.
TEST(PixelReport, ShadowsSayHowMuchOfTheLightIsVisible) {
  TracedPyray pyray{.kind = TracedPyray::Kind::shadow, .weight = 0.25};
  pyray.cells.resize(1);
  pyray.result = glm::vec3(0.5f);
  EXPECT_EQ(shadow_words("lamp", pyray), "lamp: 50 % visible (25 % of pixel, 1 cell)");
  pyray.result = glm::vec3(0.0f);
  EXPECT_EQ(shadow_words("lamp", pyray), "lamp: hidden (25 % of pixel, 1 cell)");
  pyray.result = glm::vec3(1.0f);
  EXPECT_EQ(shadow_words("lamp", pyray), "lamp: visible (25 % of pixel, 1 cell)");
  pyray.weight = 0.0f;
  EXPECT_EQ(shadow_words("lamp", pyray), "lamp: visible, adds nothing here");
}

TEST(SeenParts, ARingLeavesItsHoleOut) {
  TracedCell cell;
  TracedSample ring;
  const auto add = [&](std::vector<glm::vec2> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      ring.border.push_back({corners[i], corners[(i + 1) % corners.size()]});
  };
  add({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  add({{0.5f, 0.25f}, {0.25f, 0.5f}, {0.5f, 0.75f}, {0.75f, 0.5f}});
  cell.samples = {ring};
  double area = 0.0;
  for (const SeenPart& part : seen_parts(std::vector{cell})) {
    area += part.area();
    for (const glm::vec2 corner : part.corners)
      EXPECT_GE(std::abs(corner.x - 0.5f) + std::abs(corner.y - 0.5f), 0.25f - 1e-6f);
  }
  EXPECT_NEAR(area, 0.875, 1e-6);
  cell.samples = {TracedSample{}};
  ASSERT_EQ(seen_parts(std::vector{cell}).size(), 1u);
  EXPECT_NEAR(seen_parts(std::vector{cell}).front().area(), 1.0, 1e-6) << "all of the cell";
}

// Map, status line and view agree on one level and one cause.
TEST_F(PixelPanelTest, SaysWhatTheMapShows) {
  const glm::ivec2 pixel = cut_pixel();
  const Film& film = rig.film();
  const std::size_t i = film.index(pixel.x, pixel.y);
  EXPECT_EQ(film.split_level[i], 0) << "one edge cuts it";
  pick(pixel);
  EXPECT_EQ(rig.control("Why").words, "exact, silhouette");
  EXPECT_EQ(rig.control("Why").words, split_words(film, i));
  EXPECT_EQ(rig.control("Verdict").words, "Exact: every cell is free of edges or cut along them.");
}

TEST(PixelReport, ItsReasonsAgreeWithTheCause) {
  PixelReport report;
  TracedCell cell{.fate = CellFate::sampled};
  report.trace.cells = {cell};
  report.trace.level = 3;
  report.trace.cause = SplitCause::shadow;
  report.trace.samples = 64;
  EXPECT_EQ(report.split(), "level 3, 64 samples, shadow") << "one undivided cell";
  EXPECT_EQ(report.verdict(), "Split for varying shading.");
  report.trace.samples = 1;
  EXPECT_EQ(report.split(), "level 3, 1 sample, shadow");
  report.trace.samples = 64;
  report.trace.cells[0].fate = CellFate::cut;
  report.trace.cause = SplitCause::outline;
  EXPECT_EQ(report.verdict(), "Split along its edges and for varying shading.");
}

TEST(PixelReport, CountsEdges) {
  TracedCell cell;
  EXPECT_EQ(edge_words(cell), "0 edges");
  cell.boundaries.resize(1);
  cell.hidden = 1;
  EXPECT_EQ(edge_words(cell), "1 edge, 1 hidden edge");
  cell.clusters = 2;
  cell.hidden = 3;
  EXPECT_EQ(edge_words(cell), "1 edge, 2 unresolved groups, 3 hidden edges");
}

TEST_F(PixelPanelTest, HoveringACellTellsOfIt) {
  pick(cut_pixel());
  const std::vector<glm::u8vec3> before = rig.pixels();
  const Controls::Placed square = rig.control("Subdivision");
  rig.move_to(square.centre());
  rig.frame();
  EXPECT_NE(rig.pixels(), before);
}

TEST_F(PixelPanelTest, ItClosesByKeyAndByButton) {
  const glm::ivec2 pixel = cut_pixel();
  pick(pixel);
  rig.key(Key::escape);
  EXPECT_FALSE(rig.state().picked.has_value());
  EXPECT_FALSE(rig.state().leaving.quit);
  pick(pixel);
  rig.click("Close inspector");
  EXPECT_FALSE(rig.state().picked.has_value());
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("Subdivision"));
}

TEST_F(PixelPanelTest, ADragPicksNothing) {
  rig.drag({200, 200}, {240, 220});
  EXPECT_FALSE(rig.state().picked.has_value());
}

TEST_F(PixelPanelTest, BoundariesAreDrawnIntoThePicture) {
  const glm::ivec2 pixel = cut_pixel();
  pick(pixel);
  // The lines are antialiased, so hardly any pixel has their exact colour.
  const auto yellow = [](glm::u8vec3 c) { return c.x - c.z > 80 && c.y - c.z > 80; };
  const auto outlines = [&] {
    const std::vector<glm::u8vec3> pixels = rig.pixels();
    int count = 0;
    const PixelRect area = rig.content().picture_rect();
    for (int y = 0; y < area.height; ++y)
      for (int x = 0; x < area.width; ++x) count += yellow(at(pixels, {x, y}));
    return count;
  };
  ASSERT_TRUE(yellow(split_cause_colour(SplitCause::outline)));
  const int before = outlines();
  rig.click("Show edges");
  ASSERT_TRUE(rig.frames_until([&] { return outlines() > before + 100; })) << "the triangles'";
  EXPECT_FALSE(restarted());
}

TEST_F(PixelPanelTest, PyraysOfAMirrorAreSteppedInto) {
  settings().mirror.bounces = 2;
  ASSERT_TRUE(rig.opens("mirrors"));
  rig.refinement().set_paused(true);
  rig.frame();
  const Film& film = rig.film();
  pick({film.width / 2, film.height / 2});
  ASSERT_TRUE(rig.frames_until([&] { return rig.controls().contains("Pyray/1"); }));
  rig.click("Pyray/1");
  EXPECT_EQ(rig.state().picked_pyray, 0);
  rig.frame();
  rig.click("Back");
  EXPECT_EQ(rig.state().picked_pyray, -1);
  rig.click("Pyray/1");
  rig.key(Key::escape);
  EXPECT_FALSE(rig.state().picked.has_value());
  click({film.width / 2, film.height / 2});
  EXPECT_EQ(rig.state().picked_pyray, -1) << "another pick begins with the pixel";
}

TEST_F(PixelPanelTest, TheTraceFollowsTheView) {
  const glm::ivec2 pixel = cut_pixel();
  pick(pixel);
  // Next to the pixel panel, which leaves the pixel's half of the picture free.
  const Controls::Placed panel = rig.control("Pixel panel");
  const float x = panel.lo.x > 40.0f ? 10.0f : 320.0f;
  rig.drag({x, 800}, {x + (x < 100.0f ? 25.0f : -25.0f), 820});
  EXPECT_TRUE(restarted());
  PixelInspector inspector;
  ASSERT_TRUE(rig.frames_until([&] {
    inspector.update(rig.previewer(), pixel, false);
    return inspector.report() != nullptr && !inspector.busy();
  }));
  const PixelReport& report = *inspector.report();
  const Film& film = rig.film();
  EXPECT_EQ(report.trace.radiance, film.radiance[film.index(pixel.x, pixel.y)])
      << "bit for bit what the picture shows";
  double weights = 0.0;
  for (const TracedCell& cell : report.trace.cells)
    for (const TracedSample& sample : cell.samples) weights += sample.weight;
  EXPECT_NEAR(weights, 1.0, 1e-6);
  EXPECT_FALSE(report.verdict().empty());
}

TEST_F(PixelPanelTest, AnIdleWindowSleepsWithAPixelPicked) {
  pick(cut_pixel());
  EXPECT_TRUE(rig.settle());
  for (int i = 0; i < 60; ++i) rig.frame();
  EXPECT_FALSE(rig.content().seconds_to_redraw().has_value());
}

TEST(PixelReport, TheSmallestCellIsFound) {
  PixelReport report;
  const auto add = [&](int level, glm::vec2 corner, CellFate fate) {
    TracedCell& cell = report.trace.cells.emplace_back();
    cell.level = level;
    cell.corner = corner;
    cell.side = std::ldexp(1.0f, -level);
    cell.fate = fate;
  };
  report.trace.cause = SplitCause::outline;
  add(0, {0, 0}, CellFate::split);
  for (int i = 0; i < 4; ++i)
    add(1, {0.5f * static_cast<float>(i % 2), i < 2 ? 0.0f : 0.5f}, CellFate::uniform);
  EXPECT_EQ(cell_at(report.trace.cells, {0.1f, 0.1f}), 1u);
  EXPECT_EQ(cell_at(report.trace.cells, {0.9f, 0.1f}), 2u);
  EXPECT_EQ(cell_at(report.trace.cells, {0.1f, 0.9f}), 3u);
  EXPECT_EQ(cell_at(report.trace.cells, {0.9f, 0.9f}), 4u);
  EXPECT_EQ(report.verdict(), "Exact: every cell is free of edges or cut along them.");
  report.trace.cells.back().fate = CellFate::finest;
  report.trace.unresolved_area = 0.25;
  EXPECT_EQ(report.verdict(), "MAX reached: 25.00 % of the pixel is unresolved.");
}

}  // namespace
}  // namespace asos
