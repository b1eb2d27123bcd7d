#include "renderer/features/intersections.h"

#include "renderer/features/feature_set.h"
#include "renderer/features/welded_vertices.h"
#include "tests/support/polygon_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace asos::test {
namespace {

constexpr IntersectionBudget plenty{100'000, 1'000'000'000};

Intersections intersections_of(const World& world, const IntersectionBudget& budget) {
  return find_intersections(world, welded_vertices(world.positions.own()), budget);
}

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
  const Intersections found = intersections_of(scene.world, plenty);
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
  EXPECT_NEAR(total_length(intersections_of(scene.world, plenty)), 2.0, 1e-6);
}

TEST(Intersections, ABoxThroughAFloorHasTheOutlineOfItsSection) {
  PolygonScene scene;
  scene.add({{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}});
  add_box(scene, {-1, -1, -2}, {1, 3, 2});
  EXPECT_NEAR(total_length(intersections_of(scene.world, plenty)), 2 * (2 + 4), 1e-5);
}

TEST(Intersections, ABoxOnAFloorOnlyTouchesIt) {
  PolygonScene scene;
  scene.add({{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}});
  add_box(scene, {-1, 0, -2}, {1, 3, 2});
  EXPECT_TRUE(intersections_of(scene.world, plenty).lines.empty());
}

TEST(Intersections, NeighboursAndCoplanarOverlapsHaveNone) {
  PolygonScene scene;
  add_box(scene, {0, 0, 0}, {1, 1, 1});
  scene.add({{0.2f, 0.2f, 1}, {0.9f, 0.2f, 1}, {0.2f, 0.9f, 1}});
  EXPECT_TRUE(intersections_of(scene.world, plenty).lines.empty());
}

TEST(Intersections, MoreThanTheBudgetIsSaidAndLeavesNone) {
  PolygonScene scene;
  for (int i = 0; i < 10; ++i) {
    const float x = static_cast<float>(i);
    scene.add({{x, -20, -20}, {x, 20, -20}, {x, 0, 30}});
    scene.add({{-20, x, -20}, {30, x, -20}, {0, x, 30}});
  }
  const Intersections found = intersections_of(scene.world, {20, 1000});
  EXPECT_FALSE(found.complete);
  EXPECT_TRUE(found.lines.empty());
  EXPECT_GT(intersections_of(scene.world, plenty).lines.size(), 20u);
}

glm::mat3 random_turn(std::mt19937& random) {
  std::normal_distribution<float> normal;
  const auto vector = [&] { return glm::vec3(normal(random), normal(random), normal(random)); };
  const glm::vec3 x = glm::normalize(vector());
  const glm::vec3 y = glm::normalize(glm::cross(x, vector()));
  return {x, y, glm::cross(x, y)};
}

// Overlapping sheets in one oblique plane, whose corners are rounded.
TEST(Intersections, CoplanarOverlapsHaveNoneHoweverTheyAreTurned) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (int i = 0; i < 1000; ++i) {
    const glm::mat3 turn = random_turn(random);
    const glm::vec3 centre = 10.0f * glm::vec3(unit(random), unit(random), unit(random));
    PolygonScene scene;
    for (int k = 0; k < 2; ++k) {
      std::vector<glm::vec3> corners;
      const glm::vec3 o(unit(random), unit(random), 0.0f);
      for (const glm::vec3& c :
           {glm::vec3(-1, -1, 0), glm::vec3(1, -1, 0), glm::vec3(1, 1, 0), glm::vec3(-1, 1, 0)})
        corners.push_back(centre + turn * (o + c));
      scene.add(corners);
    }
    ASSERT_TRUE(intersections_of(scene.world, plenty).lines.empty()) << "case " << i;
  }
}

// One long edge along two short ones, flat or bent, with the middle corner on the long edge. If
// both sides hang down from it, intersections along the edges themselves are allowed, which are
// boundaries anyway.
TEST(Intersections, TJunctionsHaveNoneButAlongTheJunction) {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> unit(0.1f, 0.9f);
  for (int i = 0; i < 1000; ++i) {
    const glm::mat3 turn = random_turn(random);
    const float at = unit(random), rise = i % 2 ? 2.0f * unit(random) - 1.0f : 0.0f;
    const auto place = [&](float x, float y) {
      return turn * glm::vec3(x, y, y > 0.0f ? rise * y : 0.0f);
    };
    PolygonScene scene;
    scene.add({place(0, 0), place(0, -1), place(1, -1), place(1, 0)});
    scene.add({place(0, 0), place(at, 0), place(at, 1), place(0, 1)});
    scene.add({place(at, 0), place(1, 0), place(1, 1), place(at, 1)});
    const Intersections found = intersections_of(scene.world, plenty);
    if (rise == 0.0f) {
      ASSERT_TRUE(found.lines.empty()) << "case " << i;
    }
    for (const IntersectionLine& line : found.lines) {
      for (const glm::vec3& end : {line.a, line.b}) {
        const glm::vec3 local = glm::transpose(turn) * end;
        ASSERT_NEAR(local.y, 0.0f, 1e-6f) << "case " << i;
        ASSERT_NEAR(local.z, 0.0f, 1e-6f) << "case " << i;
      }
    }
  }
}

TEST(Intersections, ACornerOnAPlaneOnlyTouchesIt) {
  PolygonScene scene;
  scene.add({{-4, 0, -4}, {4, 0, -4}, {0, 0, 4}});
  scene.add({{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}});      // stands on its tip
  scene.add({{1, 0, 1}, {1.5f, -1, 1}, {1, -1, 1}});  // hangs from it
  EXPECT_TRUE(intersections_of(scene.world, plenty).lines.empty());
}

TEST(Intersections, ACornerOnAPlaneBetweenTwoSidesCrossesFromThere) {
  PolygonScene scene;
  scene.add({{-4, 0, -4}, {4, 0, -4}, {0, 0, 4}});
  scene.add({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}});
  EXPECT_NEAR(total_length(intersections_of(scene.world, plenty)), 1.0, 1e-6);
}

TEST(Intersections, TrianglesThatShareOneCornerCanCrossFromThere) {
  PolygonScene scene;
  scene.add({{0, 0, 0}, {4, 0, -1}, {4, 0, 1}});
  scene.add({{0, 0, 0}, {3, 1, 0}, {3, -1, 0}});
  const Intersections found = intersections_of(scene.world, plenty);
  ASSERT_EQ(found.lines.size(), 1u);
  EXPECT_NEAR(total_length(found), 3.0, 1e-6);
}

// Pairs that share a corner but no edge, in closed meshes without self-intersections.
TEST(Intersections, NeighboursAtACornerHaveNone) {
  World world;
  std::mt19937 random(7);
  for (std::uint32_t k = 0; k < 50; ++k) {
    const glm::mat3 turn = random_turn(random);
    const auto first = static_cast<std::uint32_t>(world.positions.size());
    const std::uint32_t n = 3 + k;
    const float step = 2.0f * std::numbers::pi_v<float> / static_cast<float>(n);
    for (std::uint32_t i = 0; i < n * n; ++i) {
      const float u = step * static_cast<float>(i / n), v = step * static_cast<float>(i % n);
      const float ring = 1.0f + 0.4f * std::cos(v);
      world.positions.push_back(
          glm::vec3(4.0f * static_cast<float>(k), 0.0f, 0.0f) +
          turn * glm::vec3(ring * std::cos(u), ring * std::sin(u), 0.4f * std::sin(v)));
      const auto at = [&](std::uint32_t du, std::uint32_t dv) {
        return first + (i / n + du) % n * n + (i % n + dv) % n;
      };
      world.triangles.emplace_back(at(0, 0), at(1, 0), at(1, 1));
      world.triangles.emplace_back(at(0, 0), at(1, 1), at(0, 1));
    }
  }
  EXPECT_TRUE(intersections_of(world, plenty).lines.empty());
}

// A small object that intersects a floor of kilometres.
TEST(Intersections, TheSizeOfTheOtherTriangleHidesNothing) {
  PolygonScene scene;
  scene.add({{-4000, -1.04f, -4000}, {4000, -1.04f, -4000}, {0, -1.04f, 4000}});
  add_box(scene, {0.001f, -1.0405f, 0.001f}, {0.003f, -1.03f, 0.004f});
  EXPECT_NEAR(total_length(intersections_of(scene.world, plenty)), 2 * (0.002 + 0.003), 1e-7);
}

// All boxes overlap all others: the search gives up after a limited number of tests, reproducibly.
TEST(Intersections, ASceneOfNothingButOverlapsIsGivenUp) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> unit(0.0f, 0.01f);
  World world;
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    for (const glm::vec3& c : {glm::vec3(3, 0, 0), glm::vec3(0, 3, 0), glm::vec3(0, 0, 3)})
      world.positions.push_back(c + glm::vec3(unit(random), unit(random), unit(random)));
    world.triangles.push_back(3u * i + glm::uvec3(0, 1, 2));
  }
  EXPECT_FALSE(intersections_of(world, IntersectionBudget::of(world)).complete);
}

// Sixty walls through sixty others: far more lines than triangles, all kept as edges.
TEST(Intersections, AHeapOfFewTrianglesKeepsItsLines) {
  PolygonScene scene;
  constexpr int walls = 60;
  for (int i = 0; i < walls; ++i) {
    const float at = static_cast<float>(i);
    scene.add({{at, -1, -1}, {at, walls, -1}, {at, walls, 1}, {at, -1, 1}});
    scene.add({{-1, at, -1}, {walls, at, -1}, {walls, at, 1}, {-1, at, 1}});
  }
  const Intersections found = intersections_of(scene.world, IntersectionBudget::of(scene.world));
  EXPECT_TRUE(found.complete);
  EXPECT_NEAR(total_length(found), walls * walls * 2.0, 1e-3 * walls * walls);
}

// Triangles that meet at a hub form many pairs, but intersect nowhere.
World fans(int sides, bool closed_at_tips, float slant) {
  World world;
  const auto angle = [&](int i) {
    return 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(sides);
  };
  const auto turned = [&](glm::vec3 p) {
    return glm::vec3(std::cos(slant) * p.x - std::sin(slant) * p.y,
                     std::sin(slant) * p.x + std::cos(slant) * p.y, p.z);
  };
  const float tip = closed_at_tips ? 1.5f : 0.5f;
  world.positions = {turned({0, -tip, 0}), turned({0, tip, 0})};
  for (int i = 0; i < sides; ++i)
    for (const float y : {-0.5f, 0.5f})
      world.positions.push_back(turned({std::cos(angle(i)), y, std::sin(angle(i))}));
  for (int i = 0; i < sides; ++i) {
    const auto a = static_cast<std::uint32_t>(2 + 2 * i);
    const auto b = static_cast<std::uint32_t>(2 + 2 * ((i + 1) % sides));
    world.triangles.insert(world.triangles.end(),
                           {{0, a, b}, {1, a + 1, b + 1}, {a, b, a + 1}, {b, b + 1, a + 1}});
  }
  for (const glm::vec3 p : world.positions) world.bounds.grow(p);
  return world;
}

TEST(Intersections, CylindersAndConesOfManySidesAreComplete) {
  for (const float slant : {0.0f, 0.7f}) {
    for (const bool tips : {false, true}) {
      const World world = fans(4096, tips, slant);
      const Intersections found = intersections_of(world, IntersectionBudget::of(world));
      EXPECT_TRUE(found.complete) << slant << " " << tips;
      EXPECT_EQ(found.lines.size(), 0u) << slant << " " << tips;
    }
  }
}

TEST(Intersections, ThePairsHaveABudgetToo) {
  PolygonScene scene;
  for (int i = 0; i < 100; ++i) {
    const float y = 0.01f * static_cast<float>(i);
    scene.add({{-1, y, -1}, {1, y + 1, -1}, {0, y, 1}});  // parallel, so there are no lines
  }
  // All 4,950 pairs overlap.
  EXPECT_TRUE(intersections_of(scene.world, {0, 4950}).complete);
  EXPECT_FALSE(intersections_of(scene.world, {0, 4949}).complete);
}

// Finds the same pairs as a test of every pair of random triangles, and twice the same lines.
TEST(Intersections, FindEveryCrossingPair) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  const auto vector = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  PolygonScene scene;
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 c = 3.0f * vector();
    scene.add({c + vector(), c + vector(), c + vector()});
  }
  const Intersections found = intersections_of(scene.world, plenty);
  const Intersections again = intersections_of(scene.world, plenty);
  ASSERT_EQ(found.lines.size(), again.lines.size());
  std::size_t pairs = 0;
  for (std::uint32_t s = 0; s < 400; ++s) {
    for (std::uint32_t t = s + 1; t < 400; ++t) {
      // Two triangles intersect if an edge of one passes through the interior of the other.
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
  for (const FeatureEdge& e : features.edges()) {
    if (e.kind != FeatureKind::intersection) continue;
    // The first side is the floor's surface, the other one the box's.
    EXPECT_EQ(e.left_surface, features.smooth_surface(0));
    EXPECT_NE(e.right_surface, features.smooth_surface(0));
    EXPECT_NE(e.right_surface, FeatureEdge::none);
  }
}

}  // namespace
}  // namespace asos::test
