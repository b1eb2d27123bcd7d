#include "renderer/asos/leaf_variation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace asos::test::leaf_variation_test {
namespace {

constexpr Square square{0.25f, 0.5f, 0.125f};

ShadedLeaf leaf(std::uint32_t root, std::uint32_t surface, double weight, float shading,
                glm::vec2 at = {}) {
  ShadedLeaf shaded;
  shaded.leaf = {root, 0, weight, {square, {}}};
  shaded.surface = surface;
  shaded.at = at;
  shaded.radiance = shaded.shading = glm::vec3(shading);
  return shaded;
}

/// The quarters of a root, with a value in each.
void add_quarters(LeafVariation& variation, const std::array<float, 4>& values,
                  std::uint32_t root = 3, std::uint32_t surface = 7) {
  for (int i = 0; i < 4; ++i)
    variation.add(leaf(root, surface, 0.25, values[static_cast<std::size_t>(i)],
                       {static_cast<float>(i % 2), static_cast<float>(i / 2)}));
}

// Quarters of +-a by turns lie off every plane by a, of four values of which a plane takes three:
// they scatter by 2 a, and the mean is off by the half of that.
TEST(LeafVariation, TakesLeavesThatDifferByMoreThanTheTolerance) {
  constexpr float a = 0.05f;
  for (const double scale : {0.9, 1.1}) {
    LeafVariation variation;
    add_quarters(variation, {0.3f + a, 0.3f - a, 0.3f - a, 0.3f + a});
    const auto taken = variation.take_uneven(scale * static_cast<double>(a));
    EXPECT_EQ(taken.size(), scale < 1.0 ? 4u : 0u);
  }
}

TEST(LeafVariation, WhatGrowsEvenlyIsNoError) {
  LeafVariation variation;
  add_quarters(variation, {0.1f, 0.4f, 0.3f, 0.6f});
  EXPECT_TRUE(variation.take_uneven(1e-6).empty());
}

TEST(LeafVariation, ComparesWithinOneSurfaceOfOneRootOnly) {
  LeafVariation variation;
  for (std::uint32_t i = 0; i < 4; ++i) {
    add_quarters(variation,
                 {0.25f * static_cast<float>(i), 0.25f * static_cast<float>(i),
                  0.25f * static_cast<float>(i), 0.25f * static_cast<float>(i)},
                 i / 2, i % 2);
  }
  EXPECT_TRUE(variation.take_uneven(1e-3).empty());
}

TEST(LeafVariation, WhatIsBrighterThanWhiteIsWhite) {
  LeafVariation variation;
  add_quarters(variation, {2.0f, 50.0f, 7.0f, 1.0f});
  EXPECT_TRUE(variation.take_uneven(1e-3).empty());
}

// A curve that shows what is brighter than white by several steps.
TEST(LeafVariation, JudgesAsTheCurveShows) {
  constexpr std::array<float, 4> values{1.0f, 3.0f, 3.0f, 1.0f};
  const double shown = displayed_intensity(glm::dvec3(3.0), ToneCurve::neutral).x -
                       displayed_intensity(glm::dvec3(1.0), ToneCurve::neutral).x;
  EXPECT_GT(shown, 0.1);
  for (const double scale : {0.9, 1.1}) {
    LeafVariation variation(ToneCurve::neutral);
    add_quarters(variation, values);
    EXPECT_EQ(variation.take_uneven(scale * 0.5 * shown).size(), scale < 1.0 ? 4u : 0u);
  }
  LeafVariation clipped;
  add_quarters(clipped, values);
  EXPECT_TRUE(clipped.take_uneven(1e-3).empty());
}

TEST(LeafVariation, KeepsRegionsAndNothingElse) {
  LeafVariation variation;
  const std::array<BorderEdge, 3> border = {BorderEdge{{0.3f, 0.5f}, {0.4f, 0.5f}},
                                            {{0.4f, 0.5f}, {0.3f, 0.6f}},
                                            {{0.3f, 0.6f}, {0.3f, 0.5f}}};
  variation.add(leaf(0, 1, 0.25, 0.5f, {0, 0}));
  variation.add(leaf(0, 1, 0.25, 0.5f, {1, 1}));
  variation.add(leaf(0, 1, 0.25, 0.1f, {1, 0}));
  ShadedLeaf cut = leaf(0, 1, 0.25, 0.1f, {0, 1});
  cut.leaf.region.border = border;
  variation.add(cut);
  const auto taken = variation.take_uneven(1e-3);
  ASSERT_EQ(taken.size(), 4u);
  EXPECT_TRUE(taken[0].leaf.region.border.empty());
  ASSERT_EQ(taken[3].leaf.region.border.size(), 3u);
  EXPECT_EQ(taken[3].leaf.region.border[1].to, border[1].to);
  EXPECT_TRUE(variation.take_uneven(1e-3).empty());
}

}  // namespace
}  // namespace asos::test::leaf_variation_test
