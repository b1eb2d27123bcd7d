#include "renderer/features/feature_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace asos {
namespace {

World empty_world(std::size_t materials = 1) {
  World world;
  world.materials.resize(materials);
  return world;
}

// Adds a part of triangles over vertices with one normal each.
void add_part(World& world, const std::vector<glm::vec3>& positions,
              const std::vector<glm::vec3>& normals, const std::vector<glm::uvec3>& triangles,
              std::uint32_t material = 0) {
  Part part;
  part.first_vertex = static_cast<std::uint32_t>(world.positions.size());
  part.first_triangle = static_cast<std::uint32_t>(world.triangles.size());
  part.vertex_count = static_cast<std::uint32_t>(positions.size());
  part.triangle_count = static_cast<std::uint32_t>(triangles.size());
  part.material = material;
  world.positions.insert(world.positions.end(), positions.begin(), positions.end());
  world.normals.insert(world.normals.end(), normals.begin(), normals.end());
  for (const glm::uvec3& t : triangles) {
    world.triangles.push_back(t + part.first_vertex);
    world.triangle_part.push_back(static_cast<std::uint32_t>(world.parts.size()));
  }
  world.parts.push_back(part);
}

const std::vector<glm::vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<glm::vec3> up(4, glm::vec3(0, 0, 1));
const std::vector<glm::uvec3> two_triangles{{0, 1, 2}, {0, 2, 3}};

// The cube's faces as six separate quads, as exporters write flat shading.
World cube(bool smooth) {
  World world = empty_world();
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto first = static_cast<std::uint32_t>(positions.size());
      for (const auto& [a, b] :
           {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
        glm::vec3 p;
        p[axis] = side, p[(axis + 1) % 3] = a, p[(axis + 2) % 3] = b;
        glm::vec3 n(0.0f);
        n[axis] = side;
        positions.push_back(p);
        normals.push_back(smooth ? glm::normalize(p) : n);
      }
      triangles.push_back(first + glm::uvec3(0, 1, 2));
      triangles.push_back(first + glm::uvec3(0, 2, 3));
    }
  }
  add_part(world, positions, normals, triangles);
  return world;
}

TEST(Features, ASquareHasItsFourOpenEdgesAndNoDiagonal) {
  World world = empty_world();
  add_part(world, square, up, two_triangles);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().open, 4u);
  EXPECT_EQ(features.edges().size(), 4u);
  EXPECT_EQ(features.sheet(0), features.sheet(1));
}

TEST(Features, AFlatShadedCubeHasTwelveCreases) {
  const World world = cube(false);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().crease, 12u);
  EXPECT_EQ(features.edges().size(), 12u);
  for (const FeatureEdge& e : features.edges()) EXPECT_TRUE(e.folds);
  std::set<std::uint32_t> sheets;
  for (std::uint32_t t = 0; t < 12; ++t) sheets.insert(features.sheet(t));
  EXPECT_EQ(sheets.size(), 6u);
}

TEST(Features, ASmoothCubeHasTwelveSilhouetteCandidatesAndOneSheet) {
  const World world = cube(true);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().silhouette_candidates, 12u);
  EXPECT_EQ(features.edges().size(), 12u);
  for (std::uint32_t t = 1; t < 12; ++t) EXPECT_EQ(features.sheet(t), features.sheet(0));
}

TEST(Features, NeighboursOfAnotherMaterialMeetInASeam) {
  World world = empty_world(2);
  add_part(world, square, up, two_triangles, 0);
  std::vector<glm::vec3> beside = square;
  for (glm::vec3& p : beside) p.x += 1.0f;
  add_part(world, beside, up, two_triangles, 1);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().seam, 1u);
  EXPECT_EQ(features.counts().open, 6u);
  EXPECT_NE(features.sheet(0), features.sheet(2));
}

TEST(Features, TextureCoordinatesCountOnlyWhereATextureUsesThem) {
  for (const bool textured : {false, true}) {
    World world = empty_world();
    if (textured) world.materials[0].base_color_texture.texture = 0;
    // Two squares side by side with coordinates that jump between them.
    std::vector<glm::vec3> positions = square, normals(8, glm::vec3(0, 0, 1));
    for (const glm::vec3& p : square) positions.push_back(p + glm::vec3(1, 0, 0));
    add_part(world, positions, normals, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
    world.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const FeatureSet features(world);
    EXPECT_EQ(features.counts().seam, textured ? 1u : 0u);
  }
}

TEST(Features, MoreThanTwoFacesAtAnEdgeAlwaysBound) {
  World world = empty_world();
  add_part(world, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
           std::vector<glm::vec3>(5, glm::vec3(0, 0, 1)), {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().open, 7u);
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

// Every edge lies in exactly one leaf, and inside all the boxes above it.
TEST(Features, TheHierarchyHoldsEveryEdgeOnce) {
  const World world = cube(false);
  World many = empty_world();
  for (int i = 0; i < 50; ++i) {
    std::vector<glm::vec3> positions = world.positions;
    for (glm::vec3& p : positions)
      p = 0.3f * p +
          glm::vec3(static_cast<float>(i % 7), static_cast<float>(i % 5), static_cast<float>(i));
    add_part(many, positions, world.normals, world.triangles);
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
}  // namespace asos
