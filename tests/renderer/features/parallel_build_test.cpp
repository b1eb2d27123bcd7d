#include "renderer/features/box_pairs.h"
#include "renderer/features/feature_set.h"
#include "renderer/features/welded_vertices.h"
#include "renderer/gltf/load.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <tbb/global_control.h>
#include <utility>
#include <vector>

namespace asos::test {
namespace {

using Pairs = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

// Small triangles everywhere, a few as large as the world, and some coplanar ones that touch.
World scattered(std::size_t triangles, float scale) {
  World world;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> at(-1.0f, 1.0f);
  for (std::size_t i = 0; i < triangles; ++i) {
    const float size = i % 50 == 0 ? 1.0f : 0.1f;
    const glm::vec3 middle(at(random), at(random), i % 7 == 0 ? 0.0f : at(random));
    const auto first = static_cast<std::uint32_t>(world.positions.size());
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 off(at(random), at(random), i % 7 == 0 ? 0.0f : at(random));
      world.positions.push_back(scale * (middle + size * off));
      world.bounds.grow(world.positions.back());
    }
    world.triangles.emplace_back(first, first + 1, first + 2);
  }
  return world;
}

Pairs all_pairs(const World& world) {
  std::vector<Box> boxes(world.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (int k = 0; k < 3; ++k) boxes[t].grow(world.positions[world.triangles[t][k]]);
  Pairs pairs;
  for (std::uint32_t s = 0; s < boxes.size(); ++s) {
    for (std::uint32_t t = s + 1; t < boxes.size(); ++t) {
      if (glm::all(glm::lessThanEqual(boxes[s].lo, boxes[t].hi)) &&
          glm::all(glm::lessThanEqual(boxes[t].lo, boxes[s].hi)))
        pairs.emplace(s, t);
    }
  }
  return pairs;
}

TEST(BoxTree, VisitsEachPairOfOverlappingBoxesOnce) {
  for (const std::size_t triangles : {1, 2, 8, 9, 65, 700}) {
    for (const float scale : {1.0f, 1e-18f, 1e17f}) {
      const World world = scattered(triangles, scale);
      const BoxTree tree(world);
      Pairs found;
      for (std::size_t leaf = 0; leaf < tree.leaf_count(); ++leaf) {
        tree.visit_pairs(leaf, [&](std::uint32_t s, std::uint32_t t) {
          found.emplace(s, t);
          return true;
        });
      }
      EXPECT_EQ(found, all_pairs(world)) << triangles << " triangles at " << scale;
    }
  }
}

TEST(BoxTree, StopsWhereTheVisitorHasSeenEnough) {
  const World world = scattered(700, 1.0f);
  const BoxTree tree(world);
  int visits = 0;
  tree.visit_pairs(0, [&](std::uint32_t, std::uint32_t) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

/// The house has chains of edges. Under sanitizers only this scene, because the thread sanitizer
/// does not understand the synchronisation of TBB's tasks and is slow with their reads.
std::vector<std::string> scenes() {
  if (sanitized) return {"builtin:house"};
  return {"builtin:house", "builtin:mixed"};
}

World built_in_world(const std::string& scene) {
  return flatten(*load_scene(scene))->world;
}

template <typename T>
bool same_bytes(std::span<const T> x, std::span<const T> y) {
  return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size_bytes()) == 0;
}

bool same_edges(std::span<const FeatureEdge> x, std::span<const FeatureEdge> y) {
  return std::equal(
      x.begin(), x.end(), y.begin(), y.end(), [](const FeatureEdge& a, const FeatureEdge& b) {
        return std::tie(a.a, a.b, a.left, a.right, a.left_surface, a.right_surface, a.kind,
                        a.folds) == std::tie(b.a, b.b, b.left, b.right, b.left_surface,
                                             b.right_surface, b.kind, b.folds);
      });
}

void expect_same_whatever_the_threads(const World& world) {
  const auto build = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return FeatureSet(world);
  };
  const FeatureSet one = build(1);
  EXPECT_GT(one.counts().intersection, 0u);
  for (const std::size_t threads : {2, 5}) {
    const FeatureSet many = build(threads);
    EXPECT_TRUE(same_edges(one.edges(), many.edges()));
    EXPECT_TRUE(same_bytes(one.nodes(), many.nodes()));
    EXPECT_TRUE(same_bytes(one.positions(), many.positions()));
    for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
      ASSERT_EQ(one.smooth_surface(t), many.smooth_surface(t));
      ASSERT_EQ(one.deviation(t), many.deviation(t));
    }
  }
}

TEST(FeatureSet, IsTheSameWhateverTheThreads) {
  for (const std::string& scene : scenes()) {
    SCOPED_TRACE(scene);
    expect_same_whatever_the_threads(built_in_world(scene));
  }
}

void expect_same_built_in_parallel(const World& world) {
  const std::vector<FeatureEdge> edges =
      extract_features(world, welded_vertices(world.positions.own())).edges;
  std::vector<FeatureEdge> in_turn = edges;
  const FeatureHierarchy expected = FeatureHierarchy::build(
      world.positions.own(), in_turn, {}, std::numeric_limits<std::size_t>::max());
  ASSERT_GT(expected.nodes.size(), 200u);
  for (const std::size_t fewest : {1, 300, 20'000}) {
    std::vector<FeatureEdge> ordered = edges;
    const FeatureHierarchy built =
        FeatureHierarchy::build(world.positions.own(), ordered, {}, fewest);
    EXPECT_TRUE(same_bytes<FeatureNode>(built.nodes, expected.nodes)) << fewest;
    EXPECT_TRUE(same_bytes<NodeChains>(built.chains, expected.chains)) << fewest;
    EXPECT_TRUE(same_edges(ordered, in_turn)) << fewest;
  }
}

TEST(WeldedVertices, AtNanAreNotAtTheSamePlace) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<glm::vec3> positions{
      {0, 1, 2}, {nan, 1, 2}, {nan, 1, 2}, {-0.0f, 1, 2}, {nan, nan, nan}};
  EXPECT_EQ(welded_vertices(positions), (std::vector<std::uint32_t>{0, 1, 2, 0, 4}));
}

TEST(FeatureHierarchy, IsTheSameBuiltInParallel) {
  for (const std::string& scene : scenes()) {
    SCOPED_TRACE(scene);
    expect_same_built_in_parallel(built_in_world(scene));
  }
}

}  // namespace
}  // namespace asos::test
