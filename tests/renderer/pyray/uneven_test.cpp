#include "renderer/pyray/tracer.h"
#include "tests/support/subdivide_polygons.h"

#include <gtest/gtest.h>

#include <cmath>

// Cells without edges that are split for their shading.

namespace asos::test {
namespace {

/// Decides that leaves heavier than a limit must be split.
class PickyCaster final : public BruteForceCaster {
 public:
  PickyCaster(const World& world, const FeatureSet& features, const Frame& frame, double most)
      : BruteForceCaster(world, features, frame), most_(most) {}

  [[nodiscard]] LeafDecision decide(const PyrayLeaf& leaf, bool may_split) override {
    if (!may_split || leaf.weight <= most_) return {};
    return {Estimator::split, LeafVariation::shading};
  }
  void take(std::span<const PyrayLeaf> leaves) override {
    for (const PyrayLeaf& leaf : leaves) largest = std::max(largest, leaf.weight);
    BruteForceCaster::take(leaves);
  }

  double largest = 0.0;

 private:
  double most_;
};

struct Case {
  explicit Case(double most, int max_level, double eps = 0.0) {
    add_polygon(scene, half_plane({0.3, 0.4}, 0.7), 2.0);
    const FeatureSet features(scene.world);
    const Frame frame = unit_frame();
    PickyCaster caster(scene.world, features, frame, most);
    SubdivisionRules rules = rules_of(max_level);
    rules.error_budget.eps = eps;
    Tracer tracer;
    outcome = tracer.trace(features, Pyray{frame}, rules, caster, &trace).outcome;
    coverage = caster.coverage[0];
    total = caster.total;
    largest = caster.largest;
  }

  PolygonScene scene;
  TracedPyray trace;
  SubdivisionOutcome outcome;
  double coverage = 0.0;
  double total = 0.0;
  double largest = 0.0;
};

TEST(Uneven, CellsAreSplitUntilTheirLeavesAreSmallEnough) {
  const Case c(1.0 / 16.0, 4);
  EXPECT_TRUE(c.outcome.uneven_shading);
  EXPECT_FALSE(c.outcome.uneven_shadow);
  EXPECT_LE(c.largest, 1.0 / 16.0);
  EXPECT_GE(c.largest, 1.0 / 64.0);  // split no further
  EXPECT_NEAR(c.total, 1.0, 1e-9);
}

TEST(Uneven, ExactAreasStayExactAndNothingIsUnresolved) {
  const Case coarse(2.0, 4);
  const Case fine(1.0 / 64.0, 4);
  EXPECT_FALSE(coarse.outcome.uneven_shading);
  EXPECT_NEAR(fine.coverage, coarse.coverage, 1e-6);
  EXPECT_EQ(fine.outcome.unresolved_area, 0.0);
  EXPECT_TRUE(fine.trace.levels.empty());  // the rule's tables are about edges
}

TEST(Uneven, StopsAtMax) {
  const Case c(0.0, 3);
  EXPECT_EQ(c.outcome.deepest, 3);
  EXPECT_LE(c.largest, 1.0 / 64.0);
  EXPECT_GT(c.largest, 1.0 / 256.0);
  EXPECT_NEAR(c.total, 1.0, 1e-9);
}

TEST(Uneven, TheRuleForBoundariesDoesNotEndIt) {
  const Case c(1.0 / 16.0, 4, 1.0);
  EXPECT_LE(c.largest, 1.0 / 16.0);
}

TEST(Uneven, TheTraceTellsWhichCellsWereSplitForIt) {
  const Case c(1.0 / 4.0, 4);
  int uneven = 0;
  for (const TracedCell& cell : c.trace.cells) uneven += cell.fate == CellFate::uneven;
  EXPECT_EQ(uneven, 1);
  EXPECT_EQ(c.trace.cells.front().fate, CellFate::uneven);
}

}  // namespace
}  // namespace asos::test
