#include "renderer/features/feature_set.h"
#include "tests/renderer/features/feature_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace asos::test {
namespace {

TEST(Features, ASquareHasItsFourOpenEdgesAndNoDiagonal) {
  World world = empty_world();
  add_part(world, square, up, two_triangles);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().open, 4u);
  EXPECT_EQ(features.edges().size(), 4u);
  EXPECT_EQ(features.smooth_surface(0), features.smooth_surface(1));
}

TEST(Features, AFlatShadedCubeHasTwelveCreases) {
  const World world = cube(false);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().crease, 12u);
  EXPECT_EQ(features.edges().size(), 12u);
  for (const FeatureEdge& e : features.edges()) EXPECT_TRUE(e.folds);
  std::set<std::uint32_t> sheets;
  for (std::uint32_t t = 0; t < 12; ++t) sheets.insert(features.smooth_surface(t));
  EXPECT_EQ(sheets.size(), 6u);
}

TEST(Features, ASmoothCubeHasTwelveSilhouetteCandidatesAndOneSheet) {
  const World world = cube(true);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().silhouette_candidates, 12u);
  EXPECT_EQ(features.edges().size(), 12u);
  for (std::uint32_t t = 1; t < 12; ++t)
    EXPECT_EQ(features.smooth_surface(t), features.smooth_surface(0));
}

// Duplicated walls, with the second copy flipped.
TEST(Features, WallsModelledTwiceCountOnce) {
  const auto twice = [](auto&& change) {
    World world = cube(true);
    world.materials.resize(2);
    World second = world;
    for (glm::uvec3& t : second.triangles) std::swap(t.y, t.z);
    change(second, world);
    add_part(world, second.positions.own(), second.normals.own(), second.triangles.own(),
             second.parts[0].material);
    return FeatureSet(world);
  };
  const FeatureSet same = twice([](World&, World&) {});
  EXPECT_EQ(same.counts().open, 0u);
  EXPECT_EQ(same.counts().silhouette_candidates, 12u);
  for (std::uint32_t t = 1; t < 24; ++t) EXPECT_EQ(same.smooth_surface(t), same.smooth_surface(0));
  EXPECT_EQ(twice([](World& second, World&) {
              for (glm::vec3& n : second.normals) n = -n;
            })
                .counts()
                .open,
            0u);
  // Copies that look different stay: all diagonals and edges have four faces.
  const auto repainted = twice([](World& second, World& all) {
    all.materials[1].metallic = 0.3f;
    second.parts[0].material = 1;
  });
  EXPECT_EQ(repainted.counts().open, 18u);
  const auto bent = twice([](World& second, World&) {
    for (glm::vec3& n : second.normals) n = glm::normalize(n + glm::vec3(0.1f, 0.2f, 0.3f));
  });
  EXPECT_EQ(bent.counts().open, 18u);
}

TEST(Features, AWallModelledTwiceByItselfHasItsOutline) {
  World world = empty_world();
  add_part(world, square, up, two_triangles);
  add_part(world, square, up, {{0, 2, 1}, {3, 2, 0}});
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().open, 4u);
  EXPECT_EQ(features.edges().size(), 4u);
}

// The winding of neighbours does not matter if both of their sides are visible.
TEST(Features, FlippedFacesHaveTheSameEdges) {
  std::mt19937 random(2);
  for (const bool smooth : {false, true}) {
    World world = cube(smooth);
    world.materials[0].double_sided = true;
    const FeatureSet features(world);
    for (int i = 0; i < 20; ++i) {
      World flipped = world;
      for (glm::uvec3& t : flipped.triangles)
        if (random() % 2) std::swap(t.y, t.z);
      const FeatureSet found(flipped);
      ASSERT_EQ(found.edges().size(), features.edges().size());
      for (std::size_t e = 0; e < found.edges().size(); ++e) {
        EXPECT_EQ(found.edges()[e].a, features.edges()[e].a);
        EXPECT_EQ(found.edges()[e].b, features.edges()[e].b);
        EXPECT_EQ(found.edges()[e].kind, features.edges()[e].kind);
        EXPECT_EQ(found.edges()[e].left, features.edges()[e].left);
        EXPECT_EQ(found.edges()[e].right, features.edges()[e].right);
      }
    }
  }
}

// From either side only one of the two faces is visible.
TEST(Features, ASingleSidedFaceBesideOneThatIsTurnedOverBounds) {
  const auto diagonals = [](bool double_sided, const std::vector<glm::uvec3>& triangles) {
    World world = empty_world();
    world.materials[0].double_sided = double_sided;
    add_part(world, square, up, triangles);
    const FeatureSet features(world);
    EXPECT_EQ(features.counts().open, 4u);
    EXPECT_EQ(features.edges().size(), 4u + features.counts().seam);
    return features.counts().seam;
  };
  const std::vector<glm::uvec3> turned{{0, 1, 2}, {0, 3, 2}};
  EXPECT_EQ(diagonals(false, turned), 1u);
  EXPECT_EQ(diagonals(true, turned), 0u);
  // With a flipped copy a face is visible from both sides; its neighbour is not.
  EXPECT_EQ(diagonals(false, {{0, 1, 2}, {0, 2, 1}, {0, 2, 3}}), 1u);
  EXPECT_EQ(diagonals(false, {{0, 1, 2}, {0, 2, 1}, {0, 2, 3}, {0, 3, 2}}), 0u);
  // A copy with the same winding adds nothing.
  EXPECT_EQ(diagonals(false, {{0, 1, 2}, {1, 2, 0}, {0, 2, 3}}), 0u);
}

TEST(Features, MoreThanTwoFacesAtAnEdgeAlwaysBound) {
  World world = empty_world();
  add_part(world, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
           std::vector<glm::vec3>(5, glm::vec3(0, 0, 1)), {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().open, 7u);
}

// The surface on a side of an edge is that of the triangle with this edge and that third vertex.
// The hierarchy has reordered the edges.
TEST(Features, AnEdgeKnowsTheSheetsOfItsFaces) {
  World world = cube(false);
  add_part(world, {{5, 5, 5}, {7, 5, 5}, {5, 7, 5}}, {up[0], up[0], up[0]}, {{0, 1, 2}});
  const FeatureSet features(world);
  ASSERT_EQ(features.edges().size(), 15u);
  const auto surface_beside = [&](const FeatureEdge& e, std::uint32_t third) {
    for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
      const auto has = [&](std::uint32_t v) {
        const glm::uvec3 c = world.triangles[t];
        return world.positions[c.x] == world.positions[v] ||
               world.positions[c.y] == world.positions[v] ||
               world.positions[c.z] == world.positions[v];
      };
      if (has(e.a) && has(e.b) && has(third)) return features.smooth_surface(t);
    }
    return FeatureEdge::none;
  };
  std::size_t open = 0;
  for (const FeatureEdge& e : features.edges()) {
    EXPECT_EQ(e.left_surface, surface_beside(e, e.left));
    if (e.kind == FeatureKind::open) {
      ++open;
      EXPECT_EQ(e.right_surface, FeatureEdge::none);
      continue;
    }
    EXPECT_EQ(e.right_surface, surface_beside(e, e.right));
    EXPECT_NE(e.left_surface, e.right_surface);
  }
  EXPECT_EQ(open, 3u);
}

TEST(Features, AnEdgeOfThreeFacesKnowsTheFirstTwo) {
  World world = empty_world();
  add_part(world, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
           std::vector<glm::vec3>(5, glm::vec3(0, 0, 1)), {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const FeatureSet features(world);
  std::size_t shared = 0;
  for (const FeatureEdge& e : features.edges()) {
    if (e.right_surface == FeatureEdge::none) continue;
    ++shared;
    EXPECT_EQ(e.left_surface, features.smooth_surface(0));
    EXPECT_EQ(e.right_surface, features.smooth_surface(1));
  }
  EXPECT_EQ(shared, 1u);
}

// Distance by which a surface may leave a face's plane before it ends: a neighbouring face of the
// cube, but none beyond a crease.
TEST(Features, ASmoothSurfaceDepartsFromItsTrianglesPlanes) {
  const World smooth = cube(true), creased = cube(false);
  const FeatureSet bent(smooth), flat(creased);
  for (std::uint32_t t = 0; t < 12; ++t) {
    EXPECT_FLOAT_EQ(bent.deviation(t), 2.0f);
    EXPECT_EQ(flat.deviation(t), 0.0f);
  }
  // A roof that falls by 3 in 4 on one side, which is modelled twice.
  World roof = empty_world();
  roof.materials[0].double_sided = true;
  add_part(roof, {{0, 0, 0}, {1, 0, 0}, {0, 5, 0}, {0, -4, -3}},
           std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)), {{0, 1, 2}, {0, 1, 3}, {0, 3, 1}});
  const FeatureSet features(roof);
  EXPECT_FLOAT_EQ(features.deviation(0), 3.0f);
  EXPECT_FLOAT_EQ(features.deviation(1), 3.0f);  // 5 times the sine, which is 3/5
  EXPECT_FLOAT_EQ(features.deviation(2), 3.0f);
}

TEST(Features, ZeroAreaTrianglesBoundNothing) {
  World world = empty_world();
  std::vector<glm::vec3> positions = square;
  positions.insert(positions.end(), {{2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
  add_part(world, positions, std::vector<glm::vec3>(7, glm::vec3(0, 0, 1)),
           {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 4, 5}, {0, 0, 0}});
  const FeatureSet features(world);
  EXPECT_EQ(features.edges().size(), 4u);
}

TEST(Features, NegativeZeroWeldsToZero) {
  World world = empty_world();
  add_part(world, square, up, two_triangles);
  add_part(world, {{-0.0f, -0.0f, 0}, {0, 1, -0.0f}, {-1, 0, 0}}, {up[0], up[0], up[0]},
           {{0, 1, 2}});
  EXPECT_EQ(FeatureSet(world).counts().open, 5u);  // the shared edge is coplanar and dropped
}

TEST(Features, AnEmptyWorldHasNone) {
  const World world = empty_world();
  const FeatureSet features(world);
  EXPECT_TRUE(features.edges().empty());
  EXPECT_TRUE(features.nodes().empty());
}

// Every edge is in exactly one leaf, and inside all boxes above it.
TEST(Features, TheHierarchyHoldsEveryEdgeOnce) {
  const World world = cube(false);
  World many = empty_world();
  for (int i = 0; i < 50; ++i) {
    std::vector<glm::vec3> positions = world.positions.own();
    for (glm::vec3& p : positions)
      p = 0.3f * p +
          glm::vec3(static_cast<float>(i % 7), static_cast<float>(i % 5), static_cast<float>(i));
    add_part(many, positions, world.normals.own(), world.triangles.own());
  }
  const FeatureSet features(many);
  ASSERT_EQ(features.edges().size(), 600u);
  std::vector<int> seen(600);
  const auto walk = [&](auto&& self, std::uint32_t n) -> void {
    const FeatureNode& node = features.nodes()[n];
    for (std::uint32_t c = 0; c < node.child_count; ++c) {
      if (node.edge_count[c] == FeatureNode::inner) {
        self(self, node.child[c]);
        continue;
      }
      for (std::uint32_t e = node.child[c]; e < node.child[c] + node.edge_count[c]; ++e) {
        ++seen[e];
        for (const std::uint32_t v : {features.edges()[e].a, features.edges()[e].b}) {
          for (int k = 0; k < 3; ++k) {
            EXPECT_GE(many.positions[v][k], node.lo[k][c]);
            EXPECT_LE(many.positions[v][k], node.hi[k][c]);
          }
        }
      }
    }
  };
  walk(walk, 0);
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
}

}  // namespace
}  // namespace asos::test
