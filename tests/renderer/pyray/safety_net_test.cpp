#include "renderer/pyray/safety_net.h"

#include "tests/support/polygon_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace asos::test {
namespace {

// Splitting by samples alone finds a half-plane's area to within the finest cells along its edge.
TEST(SafetyNet, SplitsUntilTheSamplesAgreeOrAtMax) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec2 p(unit(random), unit(random));
    const double angle = 6.3 * unit(random);
    const glm::dvec2 d(std::cos(angle), std::sin(angle)), n(-d.y, d.x);
    const std::vector<glm::dvec2> polygon{p - 4.0 * d, p + 4.0 * d, p + 4.0 * (d + n),
                                          p + 4.0 * (n - d)};
    PolygonScene scene;
    std::vector<glm::vec3> corners;
    for (const glm::dvec2& c : polygon) corners.push_back(at_depth(c.x, c.y, 2.0));
    scene.add(corners);
    const FeatureSet features(scene.world);
    const Frame frame = unit_frame();
    BruteForceCaster caster(scene.world, features, frame);
    const int max_level = 1 + i % 5;
    const SubdivisionOutcome outcome = split_by_samples(Root{}, max_level, caster);
    EXPECT_NEAR(caster.total, 1.0, 1e-12);
    EXPECT_LE(outcome.deepest, max_level);
    // A line crosses at most 2 * 2^K of the 4^K finest cells, each with an error of at most half
    // its area. A part beyond the samples of the first trusted level is never detected: a strip of
    // 1/8 with four by four samples, of 1/4 with two by two.
    const double cells = std::ldexp(2.0, max_level) * std::ldexp(0.5, -2 * max_level);
    const double unseen = max_level == 1 ? 0.25 : 0.125;
    EXPECT_NEAR(caster.coverage[0], area(clip_to_unit_square(polygon)), cells + unseen);
  }
}

TEST(SafetyNet, MaxZeroIsTheCentre) {
  PolygonScene scene;
  scene.add({at_depth(-1, -1, 2), at_depth(3, -1, 2), at_depth(-1, 3, 2)});
  const FeatureSet features(scene.world);
  const Frame frame = unit_frame();
  BruteForceCaster caster(scene.world, features, frame);
  (void)split_by_samples(Root{}, 0, caster);
  EXPECT_EQ(caster.probes(), 1);
  EXPECT_DOUBLE_EQ(caster.coverage[0], 1.0);
}

}  // namespace
}  // namespace asos::test
