#include "renderer/features/intersections.h"

#include "renderer/features/feature_set.h"
#include "tests/support/polygon_scene.h"

#include <gtest/gtest.h>

#include <random>

namespace asos::test {
namespace {

double total_length(const Intersections& found) {
  double sum = 0.0;
  for (const IntersectionLine& line : found.lines) sum += glm::distance(line.a, line.b);
  return sum;
}

// A box as six flat polygons without shared vertices.
void add_box(PolygonScene& scene, glm::vec3 lo, glm::vec3 hi) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float at : {lo[axis], hi[axis]}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      std::vector<glm::vec3> corners(4);
      for (int i = 0; i < 4; ++i) {
        glm::vec3& c = corners[static_cast<std::size_t>(i)];
        c[axis] = at;
        c[u] = i == 1 || i == 2 ? hi[u] : lo[u];
        c[v] = i >= 2 ? hi[v] : lo[v];
      }
      scene.add(corners);
    }
  }
}

TEST(Intersections, TwoTrianglesCrossAlongTheLineThatTheyShare) {
  PolygonScene scene;
  scene.add({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  scene.add({{1, 1, -1}, {1, 1, 1}, {3, 1, 0}});
  const Intersections found = find_intersections(scene.world, 100);
  ASSERT_EQ(found.lines.size(), 1u);
  EXPECT_TRUE(found.complete);
  EXPECT_NEAR(total_length(found), 2.0, 1e-6);
  EXPECT_EQ(found.lines[0].first_triangle, 0u);
  EXPECT_EQ(found.lines[0].second_triangle, 1u);
}

TEST(Intersections, CrossingRectanglesShareOneLineInPieces) {
  PolygonScene scene;
  scene.add({{-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}});
  scene.add({{-1, 0.3f, -2}, {1, 0.3f, -2}, {1, 0.3f, 2}, {-1, 0.3f, 2}});
  EXPECT_NEAR(total_length(find_intersections(scene.world, 100)), 2.0, 1e-6);
}

TEST(Intersections, ABoxThroughAFloorHasTheOutlineOfItsSection) {
  PolygonScene scene;
  scene.add({{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}});
  add_box(scene, {-1, -1, -2}, {1, 3, 2});
  EXPECT_NEAR(total_length(find_intersections(scene.world, 100)), 2 * (2 + 4), 1e-5);
}

TEST(Intersections, ABoxOnAFloorOnlyTouchesIt) {
  PolygonScene scene;
  scene.add({{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}});
  add_box(scene, {-1, 0, -2}, {1, 3, 2});
  EXPECT_TRUE(find_intersections(scene.world, 100).lines.empty());
}

TEST(Intersections, NeighboursAndCoplanarOverlapsHaveNone) {
  PolygonScene scene;
  add_box(scene, {0, 0, 0}, {1, 1, 1});
  scene.add({{0.2f, 0.2f, 1}, {0.9f, 0.2f, 1}, {0.2f, 0.9f, 1}});
  EXPECT_TRUE(find_intersections(scene.world, 100).lines.empty());
}

TEST(Intersections, MoreThanTheBudgetIsSaidAndLeavesNone) {
  PolygonScene scene;
  for (int i = 0; i < 10; ++i) {
    const float x = static_cast<float>(i);
    scene.add({{x, -20, -20}, {x, 20, -20}, {x, 0, 30}});
    scene.add({{-20, x, -20}, {30, x, -20}, {0, x, 30}});
  }
  const Intersections found = find_intersections(scene.world, 20);
  EXPECT_FALSE(found.complete);
  EXPECT_TRUE(found.lines.empty());
  EXPECT_GT(find_intersections(scene.world, 1000).lines.size(), 20u);
}

// Against every pair, on random triangles; and twice the same.
TEST(Intersections, FindEveryCrossingPair) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  PolygonScene scene;
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 c = 3.0f * vector();
    scene.add({c + vector(), c + vector(), c + vector()});
  }
  const Intersections found = find_intersections(scene.world, 100'000);
  const Intersections again = find_intersections(scene.world, 100'000);
  ASSERT_EQ(found.lines.size(), again.lines.size());
  std::size_t pairs = 0;
  for (std::uint32_t s = 0; s < 400; ++s) {
    for (std::uint32_t t = s + 1; t < 400; ++t) {
      // Two triangles cross if an edge of one passes through the inside of the other.
      const auto pierces = [&](std::uint32_t x, std::uint32_t y) {
        const auto corner = [&](std::uint32_t n, int k) {
          return glm::dvec3(scene.world.positions[scene.world.triangles[n][k]]);
        };
        const glm::dvec3 a = corner(y, 0), e1 = corner(y, 1) - a, e2 = corner(y, 2) - a;
        for (int k = 0; k < 3; ++k) {
          const glm::dvec3 o = corner(x, k), d = corner(x, (k + 1) % 3) - o;
          const glm::dvec3 p = glm::cross(d, e2);
          const double det = glm::dot(e1, p);
          const double u = glm::dot(o - a, p) / det;
          const glm::dvec3 q = glm::cross(o - a, e1);
          const double v = glm::dot(d, q) / det, at = glm::dot(e2, q) / det;
          if (u > 0 && v > 0 && u + v < 1 && at > 0 && at < 1) return true;
        }
        return false;
      };
      pairs += pierces(s, t) || pierces(t, s);
    }
  }
  EXPECT_EQ(found.lines.size(), pairs);
  EXPECT_GT(pairs, 100u);
  for (std::size_t i = 0; i < found.lines.size(); ++i)
    EXPECT_EQ(found.lines[i].a, again.lines[i].a);
}

TEST(Intersections, BecomeFeatureEdges) {
  PolygonScene scene;
  scene.add({{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}});
  add_box(scene, {-1, -1, -2}, {1, 3, 2});
  const FeatureSet features(scene.world);
  EXPECT_GE(features.counts().intersection, 4u);
  EXPECT_TRUE(features.intersections_complete());
}

}  // namespace
}  // namespace asos::test
