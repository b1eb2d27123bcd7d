#include "renderer/asos/error_terms.h"

#include "tests/support/eye_block.h"
#include "tests/support/make_light.h"
#include "tests/support/sample_lights.h"
#include "tests/support/textured_scene.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

// Each error term alone: zero without its cause, growing with the leaf's size, and close to the
// error against a finer leaf.

namespace asos::test::error_terms_test {
namespace {

constexpr double eps = 1.0 / 256.0;

Material metal(float roughness) {
  return {
      .base_color = glm::vec4(0.9f, 0.9f, 0.9f, 1.0f), .metallic = 1.0f, .roughness = roughness};
}

/// A wall of this material that fills the view along -Z, which is 16 units high.
World wall(const Material& material) {
  World world;
  add_quad(world, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, material);
  return world;
}

Light panel(glm::dvec3 position, double half) {
  Light light = make_panel(position, {0, 0, -1}, {half, 0, 0}, {0, half, 0}, 4.0f);
  light.two_sided = true;
  return light;
}

EyeBlock block_of(World world, std::vector<Light> lights, RenderSettings settings = {}) {
  return EyeBlock(make_render_scene(std::move(world), std::move(lights)), orthographic(16.0),
                  settings);
}

TEST(ErrorTerms, AreZeroOnAPlaneUnderASun) {
  const Light sun = make_sun({0, -0.6, -0.8});
  const EyeBlock block = block_of(wall(matte({0.8f, 0.8f, 0.8f})), {sun});
  Leaf leaf = block.leaf(1, 2);
  ASSERT_TRUE(leaf.is_lit());
  const ErrorBound sum = block.terms().shading(leaf);
  EXPECT_EQ(sum.error, 0.0);
  EXPECT_FALSE(sum.unbounded);
  EXPECT_EQ(block.terms().penumbra(leaf).error, 0.0);
  EXPECT_TRUE(leaf.behind_detail.empty());
}

TEST(ErrorTerms, LeafHoldsWhatItsSampleShows) {
  const EyeBlock block = block_of(wall(matte({0.5f, 0.25f, 0.0f})), {});
  const Leaf whole = block.leaf(0, 0), part = block.leaf(0, 0, 0.5f);
  EXPECT_EQ(whole.albedo(), 0.5f);
  EXPECT_NEAR(glm::length(whole.square.right), 1.0f, 1e-4f) << "a pixel is a unit wide";
  EXPECT_NEAR(glm::length(part.square.right), 0.5f, 1e-4f);
  EXPECT_NEAR(glm::length(part.around.down), 0.5f, 1e-4f);
  EXPECT_EQ(part.weight, 0.25);
  EXPECT_NEAR(whole.point.position.z, 0.0f, 1e-5f);
}

// Inverse square falloff near a small light: an error proportional to the area.
TEST(ErrorTerms, BendFallsWithTheAreaOfTheLeaf) {
  const Light bulb = make_bulb({0.5, 0.5, 2.0}, 4.0f);
  const EyeBlock block = block_of(wall(matte({0.8f, 0.8f, 0.8f})), {bulb});
  const double whole = block.terms().bend(block.leaf(2, 1)).error;
  const double part = block.terms().bend(block.leaf(2, 1, 0.5f)).error;
  EXPECT_GT(whole, 0.01);
  EXPECT_NEAR(part, 0.25 * whole, 0.01 * whole);
}

TEST(ErrorTerms, FalloffIsThatOfLightsOfSomeSize) {
  const EyeBlock near = block_of(wall(matte({0.8f, 0.8f, 0.8f})), {panel({0.5, 0.5, 1.0}, 0.3)});
  const EyeBlock far = block_of(wall(matte({0.8f, 0.8f, 0.8f})), {panel({0.5, 0.5, 90.0}, 0.3)});
  const double whole = near.terms().falloff(near.leaf(2, 1)).error;
  EXPECT_GT(whole, eps);
  EXPECT_LT(near.terms().falloff(near.leaf(2, 1, 0.25f)).error, 0.25 * whole);
  EXPECT_EQ(far.terms().falloff(far.leaf(2, 1)).error, 0.0);
}

// A panel's highlight on a smooth sphere is narrower than a pixel and brighter than white.
TEST(ErrorTerms, GlossHasTheContrastOfHighlights) {
  const auto ball = [](float roughness) {
    World world;
    add_sphere(world, {0, 0, -13}, 12.0f, 24, metal(roughness));
    return block_of(std::move(world), {panel({0, 0, 60}, 1.0)});
  };
  const EyeBlock shiny = ball(0.1f), rough = ball(1.0f);
  double contrast = 0.0;
  for (int i = 0; i < EyeBlock::side * EyeBlock::side; ++i)
    contrast = std::max(
        contrast, shiny.terms().gloss(shiny.leaf(i % EyeBlock::side, i / EyeBlock::side)).contrast);
  EXPECT_GT(contrast, 0.0);
  EXPECT_EQ(rough.terms().gloss(rough.leaf(1, 1)).contrast, 0.0);
}

// A quarter of the area reflects half the angle, with a quarter of the excess error.
TEST(ErrorTerms, MirrorSpreadsWithItsCurvature) {
  World curved, flat = wall(metal(0.0f));
  add_sphere(curved, {0, 0, 0}, 5.0f, 24, metal(0.0f));
  const EyeBlock ball = block_of(std::move(curved), {}), plane = block_of(std::move(flat), {});
  const double whole = ball.terms().mirror(ball.leaf(1, 1)).error;
  EXPECT_GT(whole, 4.0 * eps);
  EXPECT_LT(ball.terms().mirror(ball.leaf(1, 1, 0.5f)).error, 0.3 * whole);
  EXPECT_EQ(plane.terms().mirror(plane.leaf(1, 1)).error, 0.0);
  RenderSettings none{.mirror = {.bounces = 0}};
  World again;
  add_sphere(again, {0, 0, 0}, 5.0f, 24, metal(0.0f));
  const EyeBlock blind = block_of(std::move(again), {}, none);
  EXPECT_EQ(blind.terms().mirror(blind.leaf(1, 1)).error, 0.0) << "reflections are off";
}

// A plate in front of a panel: the edge of its shadow crosses the first block, but not the second
// one.
TEST(ErrorTerms, PenumbraIsFoundWhereItLies) {
  const auto shaded = [](float edge) {
    World world = wall(matte({0.8f, 0.8f, 0.8f}));
    add_quad(world, {edge, -30, 0.3f}, {30, 0, 0}, {0, 60, 0}, matte({0.5f, 0.5f, 0.5f}));
    Light bright = panel({0, 0, 20}, 2.0);
    bright.intensity = 100.0f;
    // The camera is between the plate and the wall.
    return EyeBlock(make_render_scene(std::move(world), {bright}),
                    look_at({0, 0, 0.2}, {0, 0, 0}, 2.2));
  };
  const EyeBlock crossed = shaded(0.0f), beside = shaded(25.0f);
  double found = 0.0, none = 0.0;
  for (int i = 0; i < EyeBlock::side * EyeBlock::side; ++i) {
    const int x = i % EyeBlock::side, y = i / EyeBlock::side;
    Leaf shaded_leaf = crossed.leaf(x, y), lit_leaf = beside.leaf(x, y);
    found = std::max(found, crossed.terms().penumbra(shaded_leaf).error);
    none = std::max(none, beside.terms().penumbra(lit_leaf).error);
  }
  EXPECT_GT(found, 0.0);
  EXPECT_EQ(none, 0.0);
}

// Alpha below and above the cutoff, without a known outline.
TEST(ErrorTerms, LayersAreUnboundedWhereTheyAreCutOutWithoutOutlines) {
  const auto card = [](AlphaMode mode) {
    World world;
    Material m = unlit({0.8f, 0.8f, 0.8f}, 0.5f);
    m.alpha_mode = mode;
    const Image alphas = make_image(64, 64, [](int x, int y) {
      return Texel{255, 255, 255, static_cast<std::uint8_t>((x / 2 + y / 2) % 2 ? 255 : 0)};
    });
    m.base_color_texture.texture = add_texture(world, alphas, Wrap::repeat, Filter::nearest);
    add_quad(world, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, m);
    add_quad(world, {-20, -20, -1}, {40, 0, 0}, {0, 40, 0}, m);
    add_quad(world, {-20, -20, -2}, {40, 0, 0}, {0, 40, 0}, unlit({0.1f, 0.1f, 0.1f}));
    return EyeBlock(make_textured_scene(std::move(world)), orthographic(16.0));
  };
  const EyeBlock blended = card(AlphaMode::blend), opaque = card(AlphaMode::opaque);
  EXPECT_TRUE(blended.terms().layers(blended.leaf(1, 1)).unbounded);
  EXPECT_FALSE(opaque.terms().layers(opaque.leaf(1, 1)).unbounded);
}

// A lid seen from the side, so that its far end appears smaller than its near one.
TEST(ErrorTerms, TexturesAreUnboundedWhereTheyRecede) {
  World world;
  const Image halves = make_image(64, 64, [](int, int y) {
    const std::uint8_t c = y < 32 ? 255 : 0;
    return Texel{c, c, c, 255};
  });
  Material m = unlit(glm::vec3(1.0f));
  m.double_sided = true;
  m.base_color_texture.texture = add_texture(world, halves, Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, {-9, 0, 1}, {18, 0, 0}, {0, 0, -6}, m);
  World flat = world;
  const EyeBlock lid(make_textured_scene(std::move(world)),
                     look_at({0.0, 0.3, 3.0}, {0.0, 0.3, 0.0}, 0.9));
  const EyeBlock above(make_textured_scene(std::move(flat)),
                       look_at({0.0, 30.0, -1.99}, {0.0, 0.0, -2.0}, 0.1));
  int unbounded = 0, shown = 0;
  for (int i = 0; i < EyeBlock::side * EyeBlock::side; ++i) {
    const Leaf leaf = lid.leaf(i % EyeBlock::side, i / EyeBlock::side);
    if (!leaf.shows_surface()) continue;
    ++shown;
    unbounded += lid.terms().textures(leaf).unbounded;
  }
  ASSERT_GT(shown, 0);
  EXPECT_GT(unbounded, 0);
  const Leaf leaf = above.leaf(1, 1);
  ASSERT_TRUE(leaf.shows_surface());
  EXPECT_FALSE(above.terms().textures(leaf).unbounded);
}

// A curved mesh lit by a panel: its triangles' normals differ from the leaf's.
TEST(ErrorTerms, BumpsAreUnboundedUnderAPanelOnly) {
  const auto ball = [](const Light& light) {
    World world;
    add_sphere(world, {0, 0, -13}, 12.0f, 24, matte({0.8f, 0.8f, 0.8f}));
    return block_of(std::move(world), {light});
  };
  const Light sun = make_sun({0, 0, -1});
  const EyeBlock soft = ball(panel({0, 0, 60}, 1.0)), hard = ball(sun);
  EXPECT_TRUE(soft.terms().bumps(soft.leaf(1, 1)).unbounded);
  EXPECT_FALSE(hard.terms().bumps(hard.leaf(1, 1)).unbounded);
  const EyeBlock flat = block_of(wall(matte({0.8f, 0.8f, 0.8f})), {panel({0, 0, 60}, 1.0)});
  EXPECT_FALSE(flat.terms().bumps(flat.leaf(1, 1)).unbounded);
}

// A bright highlight inside one triangle is looked for by a ray, once for all terms.
TEST(ErrorTerms, CastTheRaysToHighlightsOnce) {
  World world;
  add_sphere(world, {0, 0, -60}, 59.0f, 8, metal(0.1f));
  EyeBlock ball = block_of(std::move(world), {panel({0, 0, 60}, 1.0)});
  std::uint64_t once = 0;
  for (int i = 0; i < EyeBlock::side * EyeBlock::side; ++i) {
    const Leaf leaf = ball.leaf(i % EyeBlock::side, i / EyeBlock::side, 0.25f);
    const std::uint64_t before = ball.counts().shadow_rays;
    (void)ball.terms().gloss(leaf);
    const std::uint64_t of_gloss = ball.counts().shadow_rays - before;
    (void)ball.terms().shading(leaf);
    EXPECT_LE(ball.counts().shadow_rays - before, 2 * of_gloss) << i;
    once += of_gloss;
  }
  EXPECT_GT(once, 0u);
}

}  // namespace
}  // namespace asos::test::error_terms_test
