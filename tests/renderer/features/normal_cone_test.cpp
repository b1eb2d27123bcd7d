#include "renderer/features/normal_cone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace asos::test {
namespace {

double angle_of(const NormalCone& cone) {
  return std::atan2(cone.sine, cone.cosine);
}

double angle_between_lines(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), std::abs(glm::dot(a, b)));
}

glm::dvec3 random_normal(std::mt19937& rng, glm::dvec3 around, double spread) {
  std::normal_distribution<double> normal;
  return glm::normalize(around + spread * glm::dvec3(normal(rng), normal(rng), normal(rng)));
}

TEST(NormalCone, HoldsAllThatItWasMergedOf) {
  std::mt19937 rng(7);
  int narrow = 0;
  for (const double spread : {1e-12, 1e-7, 1e-4, 0.01, 0.1, 0.3, 1.0}) {
    for (int k = 0; k < 200; ++k) {
      const glm::dvec3 around = random_normal(rng, glm::dvec3(0), 1.0);
      NormalCone whole;
      std::vector<glm::dvec3> normals;
      for (int i = 0; i < 6; ++i) {
        const glm::dvec3 a = random_normal(rng, around, spread),
                         b = random_normal(rng, around, spread);
        normals.push_back(a);
        normals.push_back(b);
        // Every other direction is reversed, which gives the same double cone.
        NormalCone of = cone_of(a, b);
        if (i % 2 == 1) of.axis = -of.axis;
        whole = merge(whole, of);
      }
      ASSERT_FALSE(whole.holds_nothing());
      if (whole.holds_everything()) continue;
      ++narrow;
      EXPECT_NEAR(glm::length(whole.axis), 1.0, 1e-12);
      EXPECT_NEAR(std::hypot(whole.sine, whole.cosine), 1.0, 1e-12);
      for (const glm::dvec3& n : normals)
        EXPECT_LE(angle_between_lines(n, whole.axis), angle_of(whole) + 1e-7) << spread;
    }
  }
  EXPECT_GT(narrow, 1000);
}

// The smallest cone around two cones, by arcs: half of both angles and of the angle between.
TEST(NormalCone, OfTwoIsTheSmallest) {
  std::mt19937 rng(8);
  std::uniform_real_distribution<double> angle(0.0, 0.5 * std::numbers::pi);
  int everything = 0, one = 0, wider = 0;
  for (int k = 0; k < 3000; ++k) {
    const double scale = k % 3 == 0 ? 0.01 : 1.0;
    const double x = scale * angle(rng), y = scale * angle(rng);
    const NormalCone a{random_normal(rng, glm::dvec3(0), 1.0), std::sin(x), std::cos(x)};
    const NormalCone b{random_normal(rng, a.axis, 0.5 * scale), std::sin(y), std::cos(y)};
    const double between = angle_between_lines(a.axis, b.axis);
    const NormalCone whole = merge(a, b);
    const double expected = std::max({x, y, 0.5 * (x + y + between)});
    if (expected >= 0.5 * std::numbers::pi) {
      EXPECT_TRUE(whole.holds_everything());
      ++everything;
      continue;
    }
    EXPECT_NEAR(angle_of(whole), expected, 1e-7);
    (expected > std::max(x, y) ? wider : one) += 1;
  }
  EXPECT_GT(everything, 100);
  EXPECT_GT(one, 300);
  EXPECT_GT(wider, 300);
}

TEST(NormalCone, OfNormalsThatFaceEachOtherOrAreNoneIsEverything) {
  EXPECT_TRUE(cone_of({0, 0, 1}, glm::normalize(glm::dvec3(1, 0, -0.01))).holds_everything());
  EXPECT_FALSE(cone_of({0, 0, 1}, glm::normalize(glm::dvec3(1, 0, 0.01))).holds_everything());
  const NormalCone none = cone_of(glm::dvec3(std::nan("")), {0, 0, 1});
  EXPECT_TRUE(none.holds_everything());
  EXPECT_TRUE(merge(cone_of({0, 0, 1}, {0, 0, 1}), none).holds_everything());
}

}  // namespace
}  // namespace asos::test
