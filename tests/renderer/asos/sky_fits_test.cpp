#include "renderer/asos/sky_fits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <vector>

namespace asos::test::sky_fits_test {
namespace {

/// The leaves of a block on one plane, side x side of them, whose first rays found the fraction
/// `value` of the sky.
class Leaves {
 public:
  static constexpr int side = 6;

  template <typename Value>
  explicit Leaves(Value&& value) {
    for (int i = 0; i < side * side; ++i) {
      Leaf& leaf = leaves.emplace_back();
      leaf.root = static_cast<std::uint32_t>(i);
      leaf.at = (glm::vec2(i % side, i / side) + 0.5f) / static_cast<float>(side);
      SkyLeaf lit;
      lit.share = leaf.root;
      lit.leaf = &leaf;
      lit.smooth_surface = 1;
      lit.point.position = {lit.leaf->at.x, lit.leaf->at.y, 0.0f};
      lit.point.shading_normal = lit.point.geometric_normal = {0, 0, 1};
      lit.material.diffuse = glm::vec3(1.0f);
      lit.open = lit.unit = glm::vec3(1.0f);
      lits.push_back(lit);
      set_rays(static_cast<std::uint32_t>(i), 8, value(lit.leaf->at));
    }
    expected.assign(lits.size(), {0.04, 2048});
  }

  void set_rays(std::uint32_t lit, std::uint32_t rays, double value) {
    lits[lit].rays = rays;
    lits[lit].sent = glm::dvec3(rays);
    lits[lit].arrived = glm::dvec3(rays * value);
  }

  std::deque<Leaf> leaves;
  std::vector<SkyLeaf> lits;
  std::vector<SkyFits::Expected> expected;
};

constexpr double error = 0.5 / 256.0;

double ramp(glm::vec2 at) {
  return 0.6 + 0.3 * static_cast<double>(at.x);
}

/// Gives the cell's nodes their rays. Returns whether the cell's leaves could be interpolated.
template <typename Value>
bool interpolated(Leaves& leaves, Value&& value) {
  const SkyFits sky_fits(leaves.lits, leaves.expected, error);
  std::vector<SkyFits::Cell> cells = sky_fits.cells();
  EXPECT_EQ(cells.size(), 1u);
  EXPECT_TRUE(sky_fits.choose_nodes(cells.front()));
  for (const std::uint32_t node : cells.front().nodes)
    leaves.set_rays(node, cells.front().node_rays, value(leaves.lits[node].leaf->at));
  return sky_fits.assign(cells.front());
}

TEST(SkyFits, InterpolateSmoothVariation) {
  Leaves leaves(ramp);
  ASSERT_TRUE(interpolated(leaves, ramp));
  for (const SkyLeaf& lit : leaves.lits) {
    ASSERT_TRUE(lit.fitted.has_value());
    EXPECT_NEAR(lit.fitted->x, ramp(lit.leaf->at), 1e-6);
  }
}

// A shadow's edge, which no quadratic fits.
TEST(SkyFits, RefuseToInterpolateAcrossAnEdge) {
  const auto edge = [](glm::vec2 at) { return at.x + 0.3f * at.y < 0.6f ? 0.9 : 0.55; };
  Leaves leaves(edge);
  EXPECT_FALSE(interpolated(leaves, edge));
  for (const SkyLeaf& lit : leaves.lits) EXPECT_FALSE(lit.fitted.has_value());
}

// A leaf whose own rays contradict the fit is sampled instead.
TEST(SkyFits, ExcludeLeavesThatContradictTheFit) {
  Leaves leaves(ramp);
  const std::uint32_t odd = Leaves::side + 1;  // not a node: see choose_nodes
  leaves.set_rays(odd, 8, 0.05);
  ASSERT_TRUE(interpolated(leaves, ramp));
  EXPECT_FALSE(leaves.lits[odd].fitted.has_value());
  EXPECT_TRUE(leaves.lits[odd + 1].fitted.has_value());
}

TEST(SkyFits, KeepSurfacesApart) {
  Leaves leaves(ramp);
  for (std::size_t i = 0; i < leaves.lits.size() / 2; ++i) leaves.lits[i].smooth_surface = 2;
  const SkyFits sky_fits(leaves.lits, leaves.expected, error);
  const std::vector<SkyFits::Cell> cells = sky_fits.cells();
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells[0].lits.size() + cells[1].lits.size(), leaves.lits.size());
  // A leaf tilted by more than 25 degrees counts as another surface, too small for a cell.
  leaves.lits[0].point.shading_normal = {1, 0, 0};
  EXPECT_EQ(sky_fits.cells().size(), 2u);
}

TEST(SkyFits, ChooseNodesOnlyWhereTheySaveRays) {
  Leaves leaves(ramp);
  leaves.expected.assign(leaves.lits.size(), {0.04, 8});
  const SkyFits sky_fits(leaves.lits, leaves.expected, error);
  SkyFits::Cell cell = sky_fits.cells().front();
  EXPECT_FALSE(sky_fits.choose_nodes(cell)) << "all leaves have enough rays already";
}

TEST(SkyFits, DivideIntoQuarters) {
  Leaves leaves(ramp);
  const SkyFits sky_fits(leaves.lits, leaves.expected, error);
  const SkyFits::Cell cell = sky_fits.cells().front();
  std::vector<SkyFits::Cell> quarters;
  sky_fits.divide(cell, quarters);
  EXPECT_TRUE(quarters.empty()) << "nine leaves each are too few";
}

}  // namespace
}  // namespace asos::test::sky_fits_test
