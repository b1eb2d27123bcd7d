#include "renderer/shading/highlight_unevenness.h"

#include "tests/support/white_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asos::test {
namespace {

constexpr glm::vec3 ahead{0, 0, 1};

SurfacePoint flat_point() {
  SurfacePoint point;
  point.geometric_normal = point.shading_normal = ahead;
  return point;
}

/// A patch of a perfect mirror at the origin with unit sides, seen by parallel rays at this angle
/// to the normal.
GlossyPatch mirror(const SurfacePoint& point, double angle) {
  const glm::vec3 to_viewer(static_cast<float>(std::sin(angle)), 0.0f,
                            static_cast<float>(std::cos(angle)));
  return {point,
          {},
          {{1, 0, 0}, {0, 1, 0}},
          to_viewer,
          std::numeric_limits<float>::infinity(),
          white_lobe(0.0, 0.04f)};
}

double schlick(double angle) {
  return 0.04 + 0.96 * std::pow(1.0 - std::cos(angle), 5.0);
}

/// Mean of Schlick's term over normals within `turn` in the plane of view, minus that at the
/// centre.
double mean_less_middle(double angle, double turn) {
  constexpr int n = 10000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += schlick(angle + turn * ((i + 0.5) / n - 0.5));
  return sum / n - schlick(angle);
}

TEST(ReflectanceError, IsWhatSchlicksTermIsOffOverTurningNormals) {
  const SurfacePoint point = flat_point();
  for (const double angle : {1.1, 1.2, 1.35}) {
    for (const float turn : {0.1f, 0.2f}) {
      GlossyPatch turning = mirror(point, angle);
      EXPECT_EQ(reflectance_error(turning), 0.0f) << "rays and normals are parallel";
      turning.turn.right = {turn, 0.0f, 0.0f};
      const double expected = mean_less_middle(angle, static_cast<double>(turn));
      EXPECT_NEAR(static_cast<double>(reflectance_error(turning)), expected, 0.05 * expected)
          << angle << ' ' << turn;
    }
  }
  EXPECT_GT(mean_less_middle(1.35, 0.2), 1.0 / 256.0) << "more than EPS";
}

TEST(ReflectanceError, OfAPixelIsNone) {
  const SurfacePoint point = flat_point();
  GlossyPatch pixel = mirror(point, 1.5);
  pixel.viewer_distance = 250.0f;
  EXPECT_EQ(reflectance_error(pixel), 0.0f);
}

}  // namespace
}  // namespace asos::test
