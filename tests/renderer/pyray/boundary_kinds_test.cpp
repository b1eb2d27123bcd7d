#include "renderer/pyray/subdivide.h"
#include "tests/support/subdivide_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

// Kinds of edges that a root was split for, and whether MAX ended the subdivision.

namespace asos::test {
namespace {

constexpr std::array all_kinds{FeatureKind::open,    FeatureKind::crease,
                               FeatureKind::seam,    FeatureKind::intersection,
                               FeatureKind::cut_out, FeatureKind::silhouette};

/// Expects exactly these kinds.
void expect_kinds(const SubdivisionOutcome& outcome, const std::vector<FeatureKind>& expected) {
  for (const FeatureKind kind : all_kinds) {
    const bool wanted = std::find(expected.begin(), expected.end(), kind) != expected.end();
    EXPECT_EQ(outcome.boundaries.has(kind), wanted) << static_cast<int>(kind);
  }
}

/// A ridge from top to bottom of the square at u = 0.4. Its left side covers the rest of the
/// square; its right side ends at `right_u`, `right_depth`.
PolygonScene ridge(double right_u, double right_depth) {
  const glm::vec3 top = at_depth(0.4, -2, 2), bottom = at_depth(0.4, 3, 2);
  PolygonScene scene;
  scene.add({top, bottom, at_depth(-3, 3, 3), at_depth(-3, -2, 3)});
  scene.add({bottom, top, at_depth(right_u, -2, right_depth), at_depth(right_u, 3, right_depth)});
  return scene;
}

TEST(BoundaryKinds, AnOpenEdge) {
  PolygonScene scene;
  add_polygon(scene, half_plane({0.3, 0.4}, 0.7), 2.0);
  for (const bool exact : {true, false})
    expect_kinds(subdivide(scene.world, rules_of(3, 0.0, exact)).outcome, {FeatureKind::open});
}

TEST(BoundaryKinds, CreaseWithBothSidesVisible) {
  const PolygonScene scene = ridge(4.0, 3.0);
  for (const bool exact : {true, false})
    expect_kinds(subdivide(scene.world, rules_of(3, 0.0, exact)).outcome, {FeatureKind::crease});
}

TEST(BoundaryKinds, CreaseWithOneSideHiddenIsASilhouette) {
  const PolygonScene scene = ridge(-2.9, 9.0);
  const SubdivisionOutcome outcome = subdivide(scene.world, rules_of(3)).outcome;
  expect_kinds(outcome, {FeatureKind::silhouette});
  EXPECT_EQ(outcome.deepest, 1);
}

TEST(BoundaryKinds, ALineWhereSurfacesPassThroughEachOther) {
  PolygonScene scene;
  scene.add({at_depth(-3, -3, 3), at_depth(4, -3, 3), at_depth(4, 4, 3), at_depth(-3, 4, 3)});
  // The second plane is at depth 3 where x is 1.
  scene.add({at_depth(-1.5, -3, 4), at_depth(4, -3, 2), at_depth(4, 4, 2), at_depth(-1.5, 4, 4)});
  expect_kinds(subdivide(scene.world, rules_of(3)).outcome, {FeatureKind::intersection});
}

TEST(BoundaryKinds, IgnoresHiddenEdges) {
  PolygonScene scene = ridge(4.0, 3.0);
  add_polygon(scene, half_plane({0.5, 0.5}, 1.0), 50.0);
  // The sample at the centre reveals that the far edge is hidden.
  expect_kinds(subdivide(scene.world, rules_of(3)).outcome, {FeatureKind::crease});
}

TEST(BoundaryKinds, NoneWithoutASplit) {
  PolygonScene scene;
  add_polygon(scene, {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}, 2.0);
  const SubdivisionOutcome outcome = subdivide(scene.world, rules_of(3)).outcome;
  EXPECT_TRUE(outcome.boundaries.empty());
  EXPECT_EQ(outcome.deepest, 0);
}

TEST(AtLimit, OnlyWhereTheRuleStillAskedForMore) {
  PolygonScene scene;
  add_polygon(scene, half_plane({0.3, 0.4}, 0.7), 2.0);
  // With point leaves an edge's cells stay marginal: at least one column of them.
  EXPECT_TRUE(subdivide(scene.world, rules_of(2, 0.0, false)).outcome.at_limit);
  EXPECT_TRUE(subdivide(scene.world, rules_of(2, 0.1, false)).outcome.at_limit);
  EXPECT_FALSE(subdivide(scene.world, rules_of(2, 0.9, false)).outcome.at_limit);
  EXPECT_FALSE(subdivide(scene.world, rules_of(2)).outcome.at_limit);
}

}  // namespace
}  // namespace asos::test
