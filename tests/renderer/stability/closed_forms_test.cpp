#include "renderer/stability/closed_forms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asos::stability {
namespace {

using std::numbers::pi;

// Hottel's and Hamilton's configuration factor of a rectangle over a parallel element under one of
// its corners (Howell, "A catalog of radiation heat transfer configuration factors", B-3).
double corner_lux(double a, double b, double height) {
  const double x = a / height;
  const double y = b / height;
  const double p = std::sqrt(1 + x * x);
  const double q = std::sqrt(1 + y * y);
  return 0.5 * (x / p * std::atan(y / p) + y / q * std::atan(x / q));
}

TEST(ClosedForms, ContourSumIsTheRectanglesConfigurationFactor) {
  for (const double height : {1e-3, 1.0, 50.0}) {
    const double got =
        contour_illuminance({{0, height, 0}, {2, height, 0}, {2, height, 3}, {0, height, 3}});
    EXPECT_NEAR(got, corner_lux(2, 3, height), 1e-12);
  }
}

TEST(ClosedForms, ContourSumCutsAtTheHorizon) {
  // A quarter of all directions, seen edge on: an infinite wall on one side gives half of pi.
  const double far = 1e9;
  EXPECT_NEAR(contour_illuminance({{1, -far, -far}, {1, far, -far}, {1, far, far}, {1, -far, far}}),
              0.5 * pi, 1e-6);
  EXPECT_EQ(contour_illuminance({{0, -1, 0}, {1, -1, 0}, {1, -1, 1}}), 0.0);
}

TEST(ClosedForms, CoverageOfAHalfPlaneIsItsShare) {
  // A picture of 4 x 2 pixels of one unit each; the edge is at x = -0.75.
  const PictureView view{parallel({0, 0, 1}, {0, 0, 0}, 2.0), 4, 2};
  const std::vector<glm::dvec3> half{{-0.75, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-0.75, 9, 0}};
  EXPECT_NEAR(coverage(view, half, 0, 0), 0.0, 1e-15);
  EXPECT_NEAR(coverage(view, half, 1, 0), 0.75, 1e-15);
  EXPECT_NEAR(coverage(view, half, 3, 1), 1.0, 1e-15);
}

TEST(ClosedForms, CoverageOfAGroundThatReachesBehindTheEyeEndsAtTheHorizon) {
  const PictureView view{look_at({0, 1, 0}, {0, 1, -1}, 90.0), 1, 1};
  const double far = 1e6;
  const double seen =
      coverage(view, {{-far, 0, 5}, {far, 0, 5}, {far, 0, -far}, {-far, 0, -far}}, 0, 0);
  // The far end is 1e-6 below the horizon, which halves the pixel of height 2.
  EXPECT_NEAR(seen, 0.5 - 0.5e-6, 1e-12);
}

TEST(ClosedForms, AreasAddUpOverThePicture) {
  const PictureView view{card_camera(), 16, 16};
  double sum = 0.0;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) sum += coverage(view, tilted_card().corners, x, y);
  }
  const double side2 = 4.0 * (239.0 * 239.0 + 92.0 * 92.0) / (256.0 * 256.0);
  const double pixel = view.pixels_per_unit() / 4.0;
  EXPECT_NEAR(sum, side2 * pixel * pixel, 1e-10);
}

}  // namespace
}  // namespace asos::stability
