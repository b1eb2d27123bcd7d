#include "renderer/shadows/shaft.h"

#include "renderer/features/feature_set.h"
#include "tests/support/random_space.h"
#include "tests/support/sanitized.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace asos::test::shaft_test {
namespace {

/// Boxes of all proportions, including points, lines and flat ones.
Box random_box(RandomSpace& random, glm::vec3 around, double size) {
  Box box;
  const glm::vec3 corner = around + glm::vec3(size * random.direction());
  box.grow(corner);
  glm::vec3 extent(size * random.between(0, 1), size * random.between(0, 1),
                   size * random.between(0, 1));
  for (int k = 0; k < 3; ++k)
    if (random.between(0, 1) < 0.25) extent[k] = 0.0f;
  box.grow(corner + extent);
  return box;
}

glm::dvec3 point_in(RandomSpace& random, const Box& box) {
  const glm::dvec3 lo(box.lo), hi(box.hi);
  return lo +
         (hi - lo) * glm::dvec3(random.between(0, 1), random.between(0, 1), random.between(0, 1));
}

/// A node whose first child is the box around an edge.
FeatureNode node_around(glm::vec3 a, glm::vec3 b) {
  FeatureNode node{};
  for (int k = 0; k < 3; ++k) {
    node.lo[k][0] = std::min(a[k], b[k]);
    node.hi[k][0] = std::max(a[k], b[k]);
  }
  node.child_count = 1;
  return node;
}

TEST(Shaft, MissesNoEdgeThatCrossesAWayBetweenItsBoxes) {
  RandomSpace random(1);
  const int cases = sanitized ? 10'000 : 100'000;
  for (int i = 0; i < cases; ++i) {
    const double scale = std::pow(10.0, random.between(-4, 4));
    const glm::vec3 place(scale * random.between(0, i % 3 ? 3 : 100) * random.direction());
    const Box from = random_box(random, place, scale);
    const Box to = random_box(random, place, scale * std::pow(10.0, random.between(-2, 1)));
    const glm::dvec3 p = point_in(random, from), q = point_in(random, to);
    const glm::dvec3 x = p + random.between(0, 1) * (q - p);
    const glm::dvec3 along = scale * std::pow(10.0, random.between(-3, 1)) * random.direction();
    const glm::vec3 a(x - random.between(0, 1) * along), b(x + random.between(0, 1) * along);
    Shaft shaft(from, to);
    ASSERT_TRUE(shaft.meets(a, b)) << i;
    ASSERT_EQ(shaft.met_children(node_around(a, b)), 1u) << i;
    // A half-space that contains the crossing, with a margin for the rounding of the edge's ends.
    const glm::dvec3 normal = random.direction();
    const double rounding = 1e-6 * (glm::length(x) + glm::length(along));
    shaft.keep_within({normal, glm::dot(normal, x) - rounding});
    ASSERT_TRUE(shaft.meets(a, b)) << i;
    ASSERT_EQ(shaft.met_children(node_around(a, b)), 1u) << i;
  }
}

// Conservative, but not too much: boxes farther from the hull than a tenth of its size are
// excluded.
TEST(Shaft, ExcludesBoxesNextToIt) {
  const auto box = [](glm::vec3 lo, glm::vec3 hi) {
    Box b;
    b.grow(lo);
    b.grow(hi);
    return b;
  };
  const Shaft shaft(box({0, 0, 0}, {1, 1, 1}), box({9, 9, 9}, {10, 10, 10}));
  EXPECT_TRUE(shaft.meets({5, 5, 5}, {5, 6, 5}));
  EXPECT_FALSE(shaft.meets({2, 8, 5}, {3, 8, 5}));    // within the bounds, but beyond the bevels
  EXPECT_FALSE(shaft.meets({-1, 0, 0}, {-1, 5, 0}));  // beyond the bounds
  EXPECT_TRUE(shaft.meets({2, 8, 5}, {8, 2, 5}));     // through the middle
  EXPECT_EQ(shaft.met_children(node_around({2, 8, 5}, {3, 8, 5})), 0u);
}

/// Collects the edges below a cut.
void collect(const FeatureSet& features, std::uint32_t node_index, unsigned children,
             std::set<std::uint32_t>& edges) {
  const FeatureNode& node = features.nodes()[node_index];
  for (unsigned c = 0; c < node.child_count; ++c) {
    if (!(children >> c & 1)) continue;
    if (node.edge_count[c] == FeatureNode::inner) {
      collect(features, node.child[c], ~0u, edges);
    } else {
      for (std::uint32_t e = 0; e < node.edge_count[c]; ++e) edges.insert(node.child[c] + e);
    }
  }
}

TEST(ShaftSearch, HoldsAllEdgesThatMeetTheShaftWhateverTheLimit) {
  RandomSpace random(2);
  World world;
  add_sphere(world, {0, 0, 0}, 1.0f, 12, matte({1, 1, 1}));
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 a(3.0 * random.direction() * random.between(0, 1));
    add_triangle(world, a, a + glm::vec3(0.2 * random.direction()),
                 a + glm::vec3(0.2 * random.direction()), matte({1, 1, 1}));
  }
  const FeatureSet features(world);
  ShaftSearch found;
  int empty = 0, whole = 0, cut_short = 0;
  for (int i = 0; i < (sanitized ? 200 : 400); ++i) {
    const double size = std::pow(10.0, random.between(-3, 0));
    const Box from = random_box(random, glm::vec3(3.0 * random.direction()), size);
    const Box to = random_box(random, glm::vec3(3.0 * random.direction()), size);
    Shaft shaft(from, to);
    if (i % 2) {
      const glm::dvec3 normal = random.direction();
      shaft.keep_within({normal, random.between(-2, 2)});
    }
    SearchBounds ignored;
    if (i % 3 == 0) {
      ignored.first_ignored_vertex = world.parts[0].first_vertex;
      ignored.ignored_vertices = world.parts[0].vertex_count;
    }
    for (const std::size_t most : {0u, 1u, 5u, 24u, 100'000u}) {
      search_shaft(features, shaft, ignored, most, found);
      std::set<std::uint32_t> held;
      for (const CutNode& part : found.cut) collect(features, part.node, part.children, held);
      bool some = false;
      for (std::uint32_t e = 0; e < features.edges().size(); ++e) {
        const FeatureEdge& edge = features.edges()[e];
        if (ignored.ignores(edge.a)) continue;
        if (!shaft.meets(features.positions()[edge.a], features.positions()[edge.b])) continue;
        some = true;
        ASSERT_TRUE(held.contains(e)) << "edge " << e << " of shaft " << i << ", most " << most;
      }
      if (most == 100'000u) {
        ASSERT_TRUE(found.complete);
        // Complete: nothing was found if and only if there is nothing.
        ASSERT_EQ(found.cut.empty(), !some);
        (some ? whole : empty)++;
      }
      cut_short += !found.complete;
    }
  }
  EXPECT_GT(empty, 5);
  EXPECT_GT(whole, 20);
  EXPECT_GT(cut_short, 50);
}

}  // namespace
}  // namespace asos::test::shaft_test
