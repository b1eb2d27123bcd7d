#include "ui/dfr_curve.h"

#include "renderer/reflections/blur_kernel.h"
#include "renderer/shading/dfr.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace asos {
using namespace ui;
namespace {

Dfr dfr_of(DfrCurve curve) {
  Dfr dfr;
  dfr.rgb.fill(curve);
  return dfr;
}

TEST(DfrCurve, TheHalfwayAngleIsWhereTheRatioIsHalfway) {
  for (const double n : {0.3, 1.0, 4.0, 32.0, 64.0, 500.0}) {
    const double angle = halfway_deg(n) * std::numbers::pi / 180.0;
    EXPECT_NEAR(dfr_at({0.2, 0.8, n}, std::cos(angle)), 0.5, 1e-9) << n;
    EXPECT_NEAR(exponent_of_halfway(halfway_deg(n)), n, 1e-6 * n);
  }
  EXPECT_EQ(halfway_deg(0.0), 0.0);
  EXPECT_EQ(exponent_of_halfway(0.0), 0.0);
  EXPECT_EQ(exponent_of_halfway(-10.0), 0.0);
  EXPECT_EQ(exponent_of_halfway(90.0), most_plotted_exponent);
  EXPECT_EQ(exponent_of_halfway(1e9), most_plotted_exponent);
}

TEST(DfrCurve, TheAxisHoldsTheWideningOfAllCurves) {
  EXPECT_EQ(widening_axis(dfr_of({1.0, 1.0, 1.0})), 10.0);
  // Figure 7 begins at 67 %.
  EXPECT_EQ(widening_axis(dfr_of({0.6, 0.95, 1.0})), 100.0);
  EXPECT_EQ(widening_axis(dfr_of({0.1, 1.0, 1.0})), 1000.0);
  Dfr by_colour = dfr_of({0.6, 0.95, 1.0});
  by_colour.rgb[2].max = 0.2;
  EXPECT_EQ(widening_axis(by_colour), 500.0);
}

TEST(DfrCurve, AChannelIsEditedAlone) {
  Dfr dfr = dfr_of({0.6, 0.95, 1.0});
  EXPECT_TRUE(alike(dfr));
  set_curves(dfr, DfrChannel::green, &DfrCurve::min, 0.25);
  EXPECT_FALSE(alike(dfr));
  EXPECT_EQ(dfr.rgb[0].min, 0.6);
  EXPECT_EQ(dfr.rgb[1].min, 0.25);
  EXPECT_EQ(dfr.rgb[2].min, 0.6);
  EXPECT_EQ(curve_of(dfr, DfrChannel::green).min, 0.25);
  set_curves(dfr, DfrChannel::all, &DfrCurve::min, 0.5);
  EXPECT_TRUE(alike(dfr));
}

TEST(MirroredBar, IsSharpInAPerfectMirrorButForThePyray) {
  const Dfr mirror = dfr_of({1.0, 1.0, 1.0});
  const double half = 0.5 * mirrored_bar_width;
  EXPECT_EQ(mirrored_bar(mirror, 0.3, 0.0), glm::vec3(1.0f));
  EXPECT_EQ(mirrored_bar(mirror, 0.3, half - 0.51), glm::vec3(1.0f));
  EXPECT_NEAR(mirrored_bar(mirror, 0.3, half).x, 0.5, 1e-6);
  EXPECT_EQ(mirrored_bar(mirror, 0.3, half + 0.51), glm::vec3(0.0f));
}

TEST(MirroredBar, IsWeightedAsTheRendererWeighsBlur) {
  constexpr double ratio = 0.3;
  const Dfr dfr = dfr_of({ratio, ratio, 1.0});
  const double half = 0.5 * mirrored_bar_width, whole = 1.0 / ratio;
  const double narrow = std::min(1.0, whole - 1.0) / whole;
  const BlurKernel kernel(glm::dvec2(narrow, narrow));
  for (const double beyond : {-1.5, -0.7, 0.0, 0.4, 1.2}) {
    // The fraction of the pyray's square, `whole` wide, on the bar's side of its edge.
    const auto edge = static_cast<float>(0.5 - beyond / whole);
    const std::array<BorderEdge, 4> strip{
        BorderEdge{{0, 0}, {edge, 0}}, BorderEdge{{edge, 0}, {edge, 1}},
        BorderEdge{{edge, 1}, {0, 1}}, BorderEdge{{0, 1}, {0, 0}}};
    const double expected = kernel.integral({{0, 0, 1}, strip});
    EXPECT_NEAR(mirrored_bar(dfr, 0.5, half + beyond).y, expected, 1e-5) << beyond;
  }
}

TEST(MirroredBar, TheColoursAreTheirOwn) {
  Dfr dfr = dfr_of({1.0, 1.0, 1.0});
  dfr.rgb[2] = {0.1, 0.1, 1.0};
  const glm::vec3 beside = mirrored_bar(dfr, 0.2, 0.5 * mirrored_bar_width + 1.0);
  EXPECT_EQ(beside.x, 0.0f);
  EXPECT_GT(beside.z, 0.1f);
}

}  // namespace
}  // namespace asos
