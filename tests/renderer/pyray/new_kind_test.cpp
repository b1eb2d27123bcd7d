#include "tests/support/subdivide_polygons.h"

#include <gtest/gtest.h>

// A new kind of pyray needs a frame and a caster. This one, which the renderer does not have,
// measures the visible fraction of a square window from a point.

namespace asos::test {
namespace {

/// Sums the leaves without an occluder.
class WindowView final : public BruteForceCaster {
 public:
  using BruteForceCaster::BruteForceCaster;

  void take(std::span<const PyrayLeaf> leaves) override {
    for (const PyrayLeaf& leaf : leaves)
      if (surface(leaf.sample) == Hit::none) open += leaf.weight;
  }

  double open = 0.0;
};

TEST(NewKindOfPyray, TheOpenShareOfAWindowIsExact) {
  PolygonScene room;
  add_polygon(room, {{0.1, 0.2}, {0.6, 0.2}, {0.6, 0.7}, {0.1, 0.7}}, 2.0);
  add_polygon(room, {{0.4, 0.4}, {0.9, 0.4}, {0.4, 0.9}}, 1.0);
  const FeatureSet features(room.world);
  const Pyray pyray = unit_pyray();
  WindowView view(room.world, features, pyray.frame);
  (void)Tracer().trace(features, pyray, rules_of(4), view);
  // A square of 0.25 and a triangle of 0.125, minus their overlap: the square's corner (0.4..0.6) x
  // (0.4..0.7), which the triangle's side u + v = 1.3 just touches.
  const double shared = 0.2 * 0.3;
  EXPECT_NEAR(view.open, 1.0 - 0.25 - 0.125 + shared, 1e-5);
}

}  // namespace
}  // namespace asos::test
