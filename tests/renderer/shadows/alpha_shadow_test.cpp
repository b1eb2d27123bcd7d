#include "tests/support/make_light.h"
#include "tests/support/shadow_fixture.h"
#include "tests/support/shadow_oracle.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Shadows of masked and blended surfaces, whose texels have no edges in the hit list.

namespace asos::test::alpha_shadow_test {
namespace {

Light panel() {
  return make_panel({0.1, 0.05, 2}, {0, 0, -1}, {0.5, 0, 0}, {0, 0.4, 0});
}

Receiver facing_up(float x, float y) {
  Receiver receiver{.position = {x, y, 0}};
  receiver.normal = receiver.geometric = {0, 0, 1};
  return receiver;
}

constexpr int texels = 4;

/// Adds a quad at half height with alternating opaque texels, and returns these.
std::vector<Polygon3> add_checker(World& world) {
  Material material = matte({1, 1, 1});
  material.alpha_mode = AlphaMode::mask;
  material.base_color_texture.texture = add_texture(
      world,
      make_image(texels, texels,
                 [](int x, int y) -> Texel {
                   return {255, 255, 255, static_cast<std::uint8_t>((x + y) % 2 ? 255 : 0)};
                 }),
      Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, {-0.5f, -0.5f, 1}, {1, 0, 0}, {0, 1, 0}, material);
  std::vector<Polygon3> opaque;
  const double s = 1.0 / texels;
  for (int y = 0; y < texels; ++y) {
    for (int x = 0; x < texels; ++x) {
      if ((x + y) % 2 == 0) continue;
      const glm::dvec3 c(-0.5 + x * s, -0.5 + y * s, 1);
      opaque.push_back(
          {c, c + glm::dvec3(s, 0, 0), c + glm::dvec3(s, s, 0), c + glm::dvec3(0, s, 0)});
    }
  }
  return opaque;
}

/// The mean error over a row of receivers.
double mean_checker_error(int max_level, bool outlined) {
  ShadowRules settings{.error_budget = {.max_level = max_level}};
  World world;
  const std::vector<Polygon3> opaque = add_checker(world);
  if (!outlined) leave_cut_outs_to_samples(world);
  ShadowFixture fixture(std::move(world), panel(), settings);
  double sum = 0.0;
  constexpr int count = 60;
  for (int i = 0; i < count; ++i) {
    const Receiver receiver = facing_up(-0.9f + 0.03f * static_cast<float>(i), 0.013f);
    const double all = form_of(corners_of(panel()), receiver);
    // The texels do not overlap.
    double seen = all;
    for (const Polygon3& texel : opaque)
      seen -= form_of(hidden_part(corners_of(panel()), texel, receiver.position), receiver);
    sum += std::abs(fixture.visibility(receiver) - seen / all);
  }
  return sum / count;
}

// With known outlines, the sides of texels are edges that cut the light.
TEST(AlphaShadow, IsExactForOutlinedCutOuts) {
  for (int max_level = 2; max_level <= 6; ++max_level)
    EXPECT_LT(mean_checker_error(max_level, true), 1e-6) << max_level;
}

// A texel's outline crosses about 4 * 2^MAX finest cells, each with a random error of at most half
// its area. The mean of many is far below this bound, which shrinks with the cells' side.
TEST(AlphaShadow, ErrorOfSampledCutOutsFallsWithMax) {
  double last = 1.0, before_last = 1.0;
  for (int max_level = 1; max_level <= 6; ++max_level) {
    const double error = mean_checker_error(max_level, false);
    const double side = std::ldexp(1.0, -max_level);
    // Up to five columns and rows of texel edges across the light.
    EXPECT_LT(error, 0.5 * 2.0 * (texels + 1) * side) << max_level;
    RecordProperty("error_at_" + std::to_string(max_level), testing::PrintToString(error));
    if (max_level > 2) {
      EXPECT_LT(error, 0.8 * before_last) << max_level;
    }
    before_last = last;
    last = error;
  }
  EXPECT_LT(last, 0.005);
}

Material see_through(float alpha) {
  Material material = matte({1, 1, 1});
  material.alpha_mode = AlphaMode::blend;
  material.base_color.a = alpha;
  return material;
}

Light bulb() {
  return {.position = {0.1, 0.05, 2}};
}

// Half of the light is visible through one layer, a quarter through two.
TEST(AlphaShadow, MultipliesTheTransmittanceOfBlendedLayers) {
  for (const Light& light : {panel(), bulb()}) {
    for (const float second : {0.0f, 0.625f}) {
      World world;
      add_quad(world, {-5, -5, 1}, {10, 0, 0}, {0, 10, 0}, see_through(0.25f));
      if (second > 0.0f)
        add_quad(world, {-5, -5, 0.5f}, {10, 0, 0}, {0, 10, 0}, see_through(second));
      ShadowFixture fixture(std::move(world), light);
      EXPECT_NEAR(fixture.visibility(facing_up(0.2f, 0.1f)), 0.75 * (1.0 - second), 1e-6);
    }
  }
}

// A blended pane with an edge across the light: exact, because edges of blended surfaces are
// searched.
TEST(AlphaShadow, IsExactAtTheEdgeOfABlendedPane) {
  World world;
  add_quad(world, {0.1f, -5, 1}, {10, 0, 0}, {0, 10, 0}, see_through(0.25f));
  ShadowFixture fixture(std::move(world), panel());
  const Polygon3 pane = {{0.1f, -5, 1}, {10.1f, -5, 1}, {10.1f, 5, 1}, {0.1f, 5, 1}};
  for (int i = 0; i < 50; ++i) {
    const Receiver receiver = facing_up(-0.5f + 0.02f * static_cast<float>(i), 0.0f);
    const double all = form_of(corners_of(panel()), receiver);
    const double hidden =
        form_of(hidden_part(corners_of(panel()), pane, receiver.position), receiver);
    EXPECT_NEAR(fixture.visibility(receiver), 1.0 - 0.25 * hidden / all, 1e-4) << i;
  }
}

// The lamp's own quad is between the receiver and its light.
TEST(AlphaShadow, IgnoresTheLightsOwnPart) {
  for (Light light : {panel(), bulb()}) {
    for (const std::int32_t own : {-1, 0, 1}) {
      World world;
      add_quad(world, {-5, -5, 1.9f}, {5.1f, 0, 0}, {0, 10, 0}, matte({1, 1, 1}));
      add_quad(world, {3, 3, 0.5f}, {1, 0, 0}, {0, 1, 0}, matte({1, 1, 1}));
      light.own_part = own;
      ShadowFixture fixture(std::move(world), light);
      const double share = fixture.visibility(facing_up(0.0f, 0.0f));
      if (own == 0) {
        EXPECT_EQ(share, 1.0);
      } else {
        EXPECT_LT(share, 0.8);
      }
    }
  }
}

}  // namespace
}  // namespace asos::test::alpha_shadow_test
