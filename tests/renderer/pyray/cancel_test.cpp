#include "renderer/pyray/tracer.h"
#include "tests/support/subdivide_polygons.h"

#include <gtest/gtest.h>

#include <cmath>

// A cancelled subdivision queries only samples that it has taken.

namespace asos::test {
namespace {

/// A caster that is cancelled after `patience` calls, and counts queries of samples that it did not
/// return.
class ImpatientCaster final : public BruteForceCaster {
 public:
  ImpatientCaster(const World& world, const FeatureSet& features, const Frame& frame, int patience)
      : BruteForceCaster(world, features, frame), patience_(patience) {}

  [[nodiscard]] bool cancelled() const override { return asked_++ >= patience_; }
  [[nodiscard]] OccluderPlane cover(SampleId id) const override {
    return known(id) ? BruteForceCaster::cover(id) : OccluderPlane::none();
  }
  [[nodiscard]] std::uint32_t surface(SampleId id) const override {
    return known(id) ? BruteForceCaster::surface(id) : Hit::none;
  }
  [[nodiscard]] LeafDecision decide(const PyrayLeaf& leaf, bool) override {
    (void)known(leaf.sample);
    return {};
  }
  void take(std::span<const PyrayLeaf> leaves) override {
    for (const PyrayLeaf& leaf : leaves)
      if (known(leaf.sample)) BruteForceCaster::take(std::span(&leaf, 1));
  }

  mutable int unknown = 0;

  [[nodiscard]] bool was_cancelled() const { return asked_ > patience_; }

 private:
  [[nodiscard]] bool known(SampleId id) const {
    const bool is = id < static_cast<SampleId>(probes());
    unknown += !is;
    return is;
  }

  int patience_;
  mutable int asked_ = 0;
};

class Cancel : public testing::TestWithParam<StoppingRule> {};

TEST_P(Cancel, NeverReadsSamplesThatWereNotTaken) {
  PolygonScene scene;
  add_polygon(scene, half_plane({0.3, 0.4}, 0.7), 3.0);
  add_polygon(scene, half_plane({0.6, 0.5}, 2.1), 2.0);
  add_polygon(scene, {{0.2, 0.2}, {0.7, 0.3}, {0.4, 0.8}}, 1.0);
  const FeatureSet features(scene.world);
  const Frame frame = unit_frame();
  const SubdivisionRules rules = rules_of(3, 0.0, false, GetParam());  // so that cells are split
  int patience = 0;
  for (bool finished = false; !finished; ++patience) {
    ASSERT_LT(patience, 10'000);
    ImpatientCaster caster(scene.world, features, frame, patience);
    Tracer tracer;
    (void)tracer.trace(features, Pyray{frame}, rules, caster);
    EXPECT_EQ(caster.unknown, 0) << "cancelled after " << patience << " questions";
    finished = !caster.was_cancelled();
    if (finished) {
      EXPECT_NEAR(caster.total, 1.0, 1e-9);
    }
  }
  EXPECT_GT(patience, 5) << "some runs must have been cancelled";
}

INSTANTIATE_TEST_SUITE_P(Rules, Cancel,
                         testing::Values(StoppingRule::unresolved, StoppingRule::published));

}  // namespace
}  // namespace asos::test
