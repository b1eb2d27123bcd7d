#include "renderer/asos/leaf_variation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace asos::test::leaf_variation_test {
namespace {

constexpr Square square{0.25f, 0.5f, 0.125f};

ShadedLeaf leaf(std::uint32_t root, std::uint32_t surface, double weight, float shading) {
  ShadedLeaf shaded;
  shaded.leaf = {root, 0, weight, {square, {}}};
  shaded.surface = surface;
  shaded.radiance = shaded.shading = glm::vec3(shading);
  return shaded;
}

// Two halves at a and b scatter by |a - b| / 2; their mean is off by that over the root of 2.
TEST(LeafVariation, TakesLeavesThatDifferByMoreThanTheTolerance) {
  constexpr double off = 0.1 / 2.0 * 0.70710678;
  for (const double scale : {0.9, 1.1}) {
    LeafVariation variation;
    variation.add(leaf(3, 7, 0.5, 0.2f));
    variation.add(leaf(3, 7, 0.5, 0.3f));
    const auto taken = variation.take_uneven(scale * off);
    EXPECT_EQ(taken.size(), scale < 1.0 ? 2u : 0u);
  }
}

TEST(LeafVariation, ComparesWithinOneSurfaceOfOneRootOnly) {
  LeafVariation variation;
  variation.add(leaf(0, 1, 0.5, 0.0f));
  variation.add(leaf(0, 2, 0.5, 1.0f));
  variation.add(leaf(1, 1, 0.5, 1.0f));
  EXPECT_TRUE(variation.take_uneven(1e-3).empty());
}

TEST(LeafVariation, WhatIsBrighterThanWhiteIsWhite) {
  LeafVariation variation;
  variation.add(leaf(0, 1, 0.5, 2.0f));
  variation.add(leaf(0, 1, 0.5, 50.0f));
  EXPECT_TRUE(variation.take_uneven(1e-3).empty());
}

TEST(LeafVariation, KeepsRegionsAndNothingElse) {
  LeafVariation variation;
  const std::array<BorderEdge, 3> border = {BorderEdge{{0.3f, 0.5f}, {0.4f, 0.5f}},
                                            {{0.4f, 0.5f}, {0.3f, 0.6f}},
                                            {{0.3f, 0.6f}, {0.3f, 0.5f}}};
  variation.add(leaf(0, 1, 0.25, 0.5f));
  ShadedLeaf cut = leaf(0, 1, 0.75, 0.1f);
  cut.leaf.region.border = border;
  variation.add(cut);
  const auto taken = variation.take_uneven(1e-3);
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_TRUE(taken[0].leaf.region.border.empty());
  ASSERT_EQ(taken[1].leaf.region.border.size(), 3u);
  EXPECT_EQ(taken[1].leaf.region.border[1].to, border[1].to);
  EXPECT_TRUE(variation.take_uneven(1e-3).empty());
}

}  // namespace
}  // namespace asos::test::leaf_variation_test
