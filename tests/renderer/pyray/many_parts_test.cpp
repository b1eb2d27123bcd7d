#include "renderer/pyray/tracer.h"
#include "tests/support/subdivide_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// Roots that edges cut into many parts are sampled if that is cheaper than shading the parts.

namespace asos::test::many_parts_test {
namespace {

/// Assumes that samples cost as much as `price` parts, for weights up to `largest_sampled`, and
/// that leaves heavier than `largest_even` are uneven.
class PricedCaster final : public BruteForceCaster {
 public:
  PricedCaster(const World& world, const FeatureSet& features, const Frame& frame,
               std::size_t price, double largest_sampled, double largest_even)
      : BruteForceCaster(world, features, frame),
        price_(price),
        largest_sampled_(largest_sampled),
        largest_even_(largest_even) {}

  [[nodiscard]] LeafDecision decide(const PyrayLeaf& leaf, bool may_split) override {
    if (!may_split || leaf.weight <= largest_even_) return {};
    return {Estimator::split, LeafVariation::shading};
  }
  [[nodiscard]] bool samples_suffice(double weight, std::size_t parts) const override {
    return parts >= price_ && weight <= largest_sampled_;
  }
  [[nodiscard]] SampleId sample_saturated(std::uint32_t, const Square&, double weight) override {
    sampled.push_back(weight);
    return 0;
  }

  std::vector<double> sampled;  ///< weights of what was sampled
 private:
  std::size_t price_;
  double largest_sampled_, largest_even_;
};

/// A wall, with objects in front of it.
struct Wall {
  Wall() { add_polygon(scene, {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}, 4.0); }

  void trace(std::size_t price, double largest_sampled = 1.0, double largest_even = 1.0,
             int max_level = 4) {
    const FeatureSet features(scene.world);
    const Frame frame = unit_frame();
    PricedCaster caster(scene.world, features, frame, price, largest_sampled, largest_even);
    Tracer tracer;
    outcome = tracer.trace(features, Pyray{frame}, rules_of(max_level, eps), caster).outcome;
    sampled = caster.sampled;
    wall = caster.coverage[0];
    total = caster.total;
  }

  double eps = 0.0;
  PolygonScene scene;
  SubdivisionOutcome outcome;
  std::vector<double> sampled;
  double wall = 0.0;
  double total = 0.0;  // of all leaves
};

/// Vertical strips, each a fifth as wide as its period.
struct Strips : Wall {
  explicit Strips(int count) {
    for (int i = 0; i < count; ++i) {
      const double u = (i + 0.4) / count, width = 0.2 / count;
      add_polygon(scene, {{u, -1}, {u + width, -1}, {u + width, 2}, {u, 2}}, 2.0);
    }
  }
};

/// Many specks in a small area. They form a few groups, which stay unresolved in one of the 4 x 4
/// cells.
struct Specks : Wall {
  Specks() {
    constexpr int count = 40;
    constexpr double space = 0.05 / count, size = 0.5 * space;
    for (int i = 0; i < count * count; ++i) {
      const double u = 0.6 + i % count * space, v = 0.6 + i / count * space;
      add_polygon(scene, {{u, v}, {u + size, v}, {u + size, v + size}, {u, v + size}}, 2.0);
    }
  }
};

// Four strips and the wall between them.
constexpr int many = 4;
constexpr std::size_t parts = 9;

TEST(ManyParts, AreSampledWhereSamplesCostNoMore) {
  Strips strips(many);
  strips.trace(parts);
  ASSERT_EQ(strips.sampled, std::vector<double>{1.0}) << "the whole root, once";
  EXPECT_EQ(strips.total, 0.0) << "and no other part of it";
  EXPECT_TRUE(strips.outcome.saturated);
}

TEST(ManyParts, AreCutWhereSamplesCostMore) {
  Strips strips(many);
  strips.trace(parts + 1);
  EXPECT_TRUE(strips.sampled.empty());
  EXPECT_NEAR(strips.wall, 0.8, 1e-6);
  EXPECT_NEAR(strips.total, 1.0, 1e-6);
  EXPECT_FALSE(strips.outcome.saturated);
}

TEST(ManyParts, FewAreCutWhateverSamplesCost) {
  Strips strips(1);
  strips.trace(0);
  EXPECT_TRUE(strips.sampled.empty());
  EXPECT_NEAR(strips.wall, 0.8, 1e-6);
}

TEST(ManyParts, AreCutAfterASplit) {
  Strips strips(many);
  strips.trace(0, 0.5, 0.15);
  EXPECT_EQ(strips.outcome.deepest, 2) << "a fifth of it was uneven";
  EXPECT_TRUE(strips.sampled.empty());
  EXPECT_NEAR(strips.wall, 0.8, 1e-6);
}

TEST(ManyParts, ThatOnlyMaxEndsAreSampledThere) {
  Specks specks;
  specks.trace(1000000, 0.0, 1.0, 2);
  EXPECT_EQ(specks.sampled, std::vector<double>{1.0 / 16.0}) << "the finest cell around them";
  EXPECT_NEAR(specks.total, 15.0 / 16.0, 1e-6) << "and the wall beside them";
  EXPECT_EQ(specks.outcome.unresolved_area, 1.0 / 16.0);
  EXPECT_TRUE(specks.outcome.at_limit);
}

TEST(ManyParts, ThatEpsEndsAreOneSample) {
  Specks specks;
  specks.eps = 0.1;
  specks.trace(1000000, 0.0, 1.0, 2);
  EXPECT_TRUE(specks.sampled.empty());
  EXPECT_NEAR(specks.total, 1.0, 1e-6);
  EXPECT_FALSE(specks.outcome.at_limit);
}

TEST(ManyParts, OfARootThatIsNotSplitAreOneSample) {
  Specks specks;
  specks.trace(1000000, 0.0, 1.0, 0);
  EXPECT_TRUE(specks.sampled.empty());
  EXPECT_NEAR(specks.total, 1.0, 1e-6);
}

}  // namespace
}  // namespace asos::test::many_parts_test
