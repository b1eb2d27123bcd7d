#include "renderer/asos/pixel_trace.h"
#include "tests/renderer/comparison/rival_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// Pixel filters wider than a pixel (CGF'98 section 3).

namespace asos::test::filter_width_test {
namespace {

constexpr float line = 3.3f;

auto white_left_of_the_line() {
  return make_render_scene(two_colours(line, glm::vec3(1), glm::vec3(0)));
}

/// White fraction of a pixel that averages `width` columns around its centre.
double share_left_of_the_line(int x, double width) {
  return std::clamp((static_cast<double>(line) - (x + 0.5 - 0.5 * width)) / width, 0.0, 1.0);
}

/// Slanted edges at several depths.
auto slanted_cards() {
  World world;
  add_card(world, {-9, -9}, {17, 17}, unlit(glm::vec3(0.1f)));
  add_quad(world, {-2.3f, -3.1f, 1}, {3.1f, 0.9f, 0}, {-0.7f, 3.3f, 0}, unlit(glm::vec3(0.9f)));
  add_quad(world, {-1.1f, -1.6f, 2}, {2.2f, 1.7f, 0}, {-0.4f, 1.3f, 0}, unlit(glm::vec3(0.4f)));
  return make_render_scene(std::move(world));
}

class AsosFilter : public testing::TestWithParam<double> {};

TEST_P(AsosFilter, AStraightEdgeIsExact) {
  const auto scene = white_left_of_the_line();
  for (const Detection detect : {Detection::square, Detection::cone}) {
    RenderSettings settings = settings_for(Method::asos);
    settings.filter_width = GetParam();
    settings.asos.max_level = 0;
    settings.asos.detect = detect;
    const BlockResult result = render_small(*scene, settings);
    for (int x = 0; x < 8; ++x) {
      for (int y = 0; y < 8; ++y)
        EXPECT_NEAR(red_at(result, x, y), share_left_of_the_line(x, GetParam()), 1e-5) << x;
    }
  }
}

TEST_P(AsosFilter, TracedPixelMatchesThePicture) {
  const auto scene = slanted_cards();
  RenderSettings settings = settings_for(Method::asos);
  settings.filter_width = GetParam();
  const BlockResult whole = render_small(*scene, settings);
  const View view(orthographic(8.0), 8, 8);
  for (const int x : {0, 2, 3, 7}) {
    const PixelTrace trace = trace_pixel(*scene, view, settings, x, 3);
    EXPECT_EQ(trace.radiance.r, red_at(whole, x, 3)) << x;
    for (const TracedCell& cell : trace.cells) {
      EXPECT_GE(std::min(cell.corner.x, cell.corner.y), -1e-5f);
      EXPECT_LE(std::max(cell.corner.x, cell.corner.y) + cell.side, 1.0f + 1e-5f);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, AsosFilter, testing::Values(1.0, 1.5, 2.0, 3.0, 4.0));

TEST(FilterWidth, ThreePixelsWideIsTheMeanOfNinePixels) {
  const auto scene = slanted_cards();
  RenderSettings settings = settings_for(Method::asos);
  settings.asos.eps = 0.0;
  settings.asos.max_level = 4;
  const BlockResult narrow = render_small(*scene, settings);
  settings.filter_width = 3.0;
  const BlockResult wide = render_small(*scene, settings);
  bool grey = false;
  for (int y = 1; y < 7; ++y) {
    for (int x = 1; x < 7; ++x) {
      double mean = 0.0;
      for (int v = y - 1; v <= y + 1; ++v) {
        for (int u = x - 1; u <= x + 1; ++u)
          mean += static_cast<double>(red_at(narrow, u, v)) / 9.0;
      }
      EXPECT_NEAR(red_at(wide, x, y), mean, 1e-4) << x << ' ' << y;
      grey |= mean > 0.2 && mean < 0.35;
    }
  }
  EXPECT_TRUE(grey) << "the edges are seen";
}

TEST(FilterWidth, RivalsSampleTheSameSquare) {
  const auto scene = white_left_of_the_line();
  // At most one column of samples is on the wrong side of the edge.
  const std::pair<Method, int> cases[] = {
      {Method::uniform, 16}, {Method::stochastic, 16}, {Method::sobol, 256}};
  for (const auto& [method, columns] : cases) {
    RenderSettings settings = settings_for(method, 256);
    settings.filter_width = 2.5;
    const BlockResult result = render_small(*scene, settings);
    for (int x = 0; x < 8; ++x)
      EXPECT_NEAR(red_at(result, x, 4), share_left_of_the_line(x, 2.5), 1.0 / columns) << x;
  }
}

TEST(FilterWidth, RejectsWidthsOutOfRange) {
  for (const double width : {0.99, 4.01, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    RenderSettings settings;
    settings.filter_width = width;
    const auto result = validated(settings);
    ASSERT_FALSE(result.has_value()) << width;
    EXPECT_EQ(result.error().subject, "filter-width");
  }
}

}  // namespace
}  // namespace asos::test::filter_width_test
