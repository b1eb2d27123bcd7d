// How leaves get their estimator and are shaded, part by part: LeafChooser, LeafShader,
// SingleSamples, SelectedLights.

#include "renderer/asos/leaf_chooser.h"
#include "renderer/asos/leaf_shader.h"
#include "renderer/asos/single_samples.h"
#include "tests/support/eye_block.h"
#include "tests/support/make_light.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace asos::test::leaves_test {
namespace {

Material glows(glm::vec3 color) {
  Material material = matte(color);
  material.unlit = true;
  return material;
}

/// A wall of this material that fills the picture of 16 x 16 pixels and units, seen along -Z.
World wall(const Material& material) {
  World world;
  add_quad(world, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0}, material);
  return world;
}

Light sun(float intensity = 1.0f) {
  return make_sun({0, -0.6, -0.8}, intensity);
}

Light bulb(glm::dvec3 position, float intensity) {
  return make_bulb(position, intensity);
}

EyeBlock block_of(World world, std::vector<Light> lights, RenderSettings settings = {}) {
  return EyeBlock(make_render_scene(std::move(world), std::move(lights)), orthographic(16.0),
                  settings);
}

RenderSettings at_max(int max_level) {
  return {.asos = {.max_level = max_level}};
}

PyrayLeaf pixel_leaf(const EyeBlock& block, int x, int y, double weight = 1.0) {
  const auto number = static_cast<std::uint32_t>(y * EyeBlock::side + x);
  return {number, number, weight, block.leaf(x, y).region};
}

TEST(LeafChooser, ChoosesCentreForEvenLight) {
  EyeBlock block = block_of(wall(matte({0.8f, 0.8f, 0.8f})), {sun()});
  LeafChooser chooser(block.eye(), block.samples(), block.selected_lights(), block.shadows());
  chooser.learn_normals(EyeBlock::side);
  const PyrayLeaf leaf = pixel_leaf(block, 1, 1);
  const LeafDecision decision = chooser.decide(leaf, true);
  EXPECT_EQ(decision.estimator, Estimator::centre);
  EXPECT_EQ(decision.cause, LeafVariation::none);
  EXPECT_EQ(chooser.even_around(leaf), nullptr);
}

// A bulb 0.1 units in front of a wall, with pixels of 1 unit: its light falls off within a pixel.
TEST(LeafChooser, SplitsOrSamplesUnevenLight) {
  EyeBlock block = block_of(wall(matte({0.8f, 0.8f, 0.8f})), {bulb({0.5, 0.5, 0.1}, 0.01f)});
  LeafChooser chooser(block.eye(), block.samples(), block.selected_lights(), block.shadows());
  chooser.learn_normals(EyeBlock::side);
  // Pixel (2, 1) of the block covers x and y from 0 to 1.
  const LeafDecision decision = chooser.decide(pixel_leaf(block, 2, 1), true);
  EXPECT_NE(decision.estimator, Estimator::centre);
  EXPECT_EQ(decision.cause, LeafVariation::shading);
  const LeafDecision last = chooser.decide(pixel_leaf(block, 2, 1), false);
  EXPECT_NE(last.estimator, Estimator::split) << "it may not";
}

TEST(LeafChooser, ChoosesCentreAtMax0) {
  EyeBlock block =
      block_of(wall(matte({0.8f, 0.8f, 0.8f})), {bulb({0.5, 0.5, 0.1}, 0.01f)}, at_max(0));
  LeafChooser chooser(block.eye(), block.samples(), block.selected_lights(), block.shadows());
  const LeafDecision decision = chooser.decide(pixel_leaf(block, 2, 1), true);
  EXPECT_EQ(decision.estimator, Estimator::centre);
  EXPECT_EQ(decision.cause, LeafVariation::none);
}

// A plane under a sun has a radiance of albedo / pi times intensity times cosine.
TEST(LeafShader, AddsALeafByItsWeight) {
  EyeBlock block = block_of(wall(matte({0.8f, 0.4f, 0.2f})), {sun(2.0f)});
  LeafChooser chooser(block.eye(), block.samples(), block.selected_lights(), block.shadows());
  std::vector<RootSum> sums(EyeBlock::side * EyeBlock::side);
  BlurredSum blurred;
  LeafShader shader(block.eye(), block.samples(), chooser, block.selected_lights(), block.shadows(),
                    sums, blurred, nullptr);
  const PyrayLeaf leaf = pixel_leaf(block, 1, 1, 0.25);
  shader.shade(std::span(&leaf, 1));
  shader.finish();
  EXPECT_DOUBLE_EQ(sums[leaf.root].weight, 0.25);
  const glm::vec3 mean = sums[leaf.root].mean();
  const float expected = 2.0f * 0.8f / std::numbers::pi_v<float>;
  // The environment adds a uniform contribution.
  EXPECT_NEAR(mean.r / mean.g, 2.0f, 0.05f);
  EXPECT_GE(mean.r, 0.8f * expected - 1e-4f);
  EXPECT_TRUE(shader.take_open().parts.empty()) << "nothing was sampled";
}

// A few samples cannot determine the brightness near a bulb, so the region stays open. Open regions
// are in no sum.
TEST(LeafShader, LeavesRegionsOpen) {
  RenderSettings settings = at_max(6);
  settings.asos.eps = 1.0 / 2048.0;
  EyeBlock block =
      block_of(wall(matte({0.8f, 0.8f, 0.8f})), {bulb({0.5, 0.5, 0.1}, 0.01f)}, settings);
  LeafChooser chooser(block.eye(), block.samples(), block.selected_lights(), block.shadows());
  std::vector<RootSum> sums(EyeBlock::side * EyeBlock::side);
  BlurredSum blurred;
  LeafShader shader(block.eye(), block.samples(), chooser, block.selected_lights(), block.shadows(),
                    sums, blurred, nullptr);
  PyrayLeaf leaf = pixel_leaf(block, 2, 1);
  leaf.decision = {Estimator::samples, LeafVariation::shading};
  shader.shade(std::span(&leaf, 1));
  shader.finish();
  const OpenRegions open = shader.take_open();
  ASSERT_EQ(open.parts.size(), 1u);
  EXPECT_EQ(open.parts[0].leaf.root, leaf.root);
  EXPECT_EQ(open.parts[0].leaf.weight, 1.0);
  EXPECT_GT(open.parts[0].so_far.cost, 0.0);
  EXPECT_GT(open.parts[0].so_far.error, 0.0);
  EXPECT_EQ(sums[leaf.root].weight, 0.0);
  EXPECT_TRUE(shader.take_open().parts.empty()) << "open regions are returned once";
}

/// The border of a strip along a pixel's diagonal that is so thin that no sample meets it. The
/// pixel's centre lies in it.
std::array<BorderEdge, 4> hair_of(const Square& pixel) {
  const auto at = [&](float u, float v) {
    return glm::vec2(pixel.u, pixel.v) + pixel.side * glm::vec2(u, v);
  };
  constexpr float half = 1e-6f;
  const std::array corners{at(0.0f, half), at(0.0f, -half), at(1.0f, 1.0f - half),
                           at(1.0f, 1.0f + half)};
  std::array<BorderEdge, 4> border;
  for (std::size_t i = 0; i < 4; ++i) border[i] = {corners[i], corners[(i + 1) % 4]};
  return border;
}

// The engine's borders are gone once it has passed on its leaves.
TEST(LeafChooser, KeepsTheLeafOfItsDecisionWithItsBorder) {
  EyeBlock block = block_of(wall(matte({0.8f, 0.8f, 0.8f})), {sun()});
  LeafChooser chooser(block.eye(), block.samples(), block.selected_lights(), block.shadows());
  PyrayLeaf part = pixel_leaf(block, 1, 1);
  const auto sides = hair_of(part.region.square);
  auto border = sides;
  part.region.border = border;
  part.decision = chooser.decide(part, false);
  ASSERT_GT(part.decision.record, 0u);
  border.fill({});
  part.region.border = {};
  const Leaf& leaf = chooser.leaf(part);
  ASSERT_EQ(leaf.region.border.size(), sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
    EXPECT_EQ(leaf.region.border[i].from, sides[i].from) << i;
  EXPECT_EQ(leaf.point.position, block.samples().point(part.sample).position);
  (void)chooser.leaf(pixel_leaf(block, 2, 2));
  EXPECT_EQ(&chooser.leaf(part), &leaf) << "it is made once";
}

Material metal(glm::vec3 color, float roughness) {
  return {.base_color = glm::vec4(color, 1.0f), .metallic = 1.0f, .roughness = roughness};
}

// A hair of shiny metal lies below a half hidden panel. Its highlight is unsure, so it is sampled.
// If no sample meets it, its own sample counts, once.
TEST(LeafShader, ShadesAnUnsureHighlightThatNoSampleMeets) {
  const Light panel = make_panel({0, 0, 20}, {0, 0, -1}, {4, 0, 0}, {0, 4, 0}, 400.0f);
  World world = wall(metal(glm::vec3(0.9f), 0.25f));
  // The camera is between the plate and the wall.
  add_quad(world, {0.1f, -30, 10}, {30, 0, 0}, {0, 60, 0}, matte(glm::vec3(0.5f)));
  RenderSettings settings = at_max(6);
  settings.asos.eps = 1.0 / 2048.0;
  EyeBlock block(make_render_scene(std::move(world), {panel}), look_at({0, 0, 5}, {0, 0, 0}, 0.4),
                 settings);
  LeafChooser chooser(block.eye(), block.samples(), block.selected_lights(), block.shadows());
  std::vector<RootSum> sums(EyeBlock::side * EyeBlock::side);
  BlurredSum blurred;
  LeafShader shader(block.eye(), block.samples(), chooser, block.selected_lights(), block.shadows(),
                    sums, blurred, nullptr);
  PyrayLeaf leaf = pixel_leaf(block, 1, 1, 1.0 / 64.0);
  const auto border = hair_of(leaf.region.square);
  leaf.region.border = border;
  shader.shade(std::span(&leaf, 1));
  ASSERT_EQ(sums[leaf.root].weight, 0.0) << "its highlight is unsure, so that it waits";
  shader.finish();
  EXPECT_EQ(sums[leaf.root].weight, leaf.weight);
  EXPECT_GT(sums[leaf.root].mean().r, 0.0f);
  OpenRegions open = shader.take_open();
  EXPECT_TRUE(open.parts.empty());
  EXPECT_TRUE(open.samples.empty()) << "every open region belongs to a part";
}

// Rough metal below a white sky, black below the pixel's diagonal. A hair of the white half shows
// the reflection in its own surface, although no sample meets it.
TEST(LeafShader, LobesOfAHairAreThoseOfItsOwnSurface) {
  World world = wall(metal(glm::vec3(0.0f), 0.3f));
  add_triangle(world, {-20, 20, 0.01f}, {19.99f, -20, 0.01f}, {20, 20, 0.01f},
               metal(glm::vec3(0.9f), 0.3f));
  RenderSettings settings = at_max(3);
  settings.sky = std::make_shared<const Sky>(glm::vec3(1.0f));
  for (const Estimator estimator : {Estimator::centre, Estimator::samples}) {
    EyeBlock block = block_of(world, {}, settings);
    LeafChooser chooser(block.eye(), block.samples(), block.selected_lights(), block.shadows());
    std::vector<RootSum> sums(EyeBlock::side * EyeBlock::side);
    BlurredSum blurred;
    LeafShader shader(block.eye(), block.samples(), chooser, block.selected_lights(),
                      block.shadows(), sums, blurred, nullptr);
    PyrayLeaf leaf = pixel_leaf(block, 1, 1, 1.0 / 16.0);
    const auto border = hair_of(leaf.region.square);
    leaf.region.border = border;
    leaf.decision.estimator = estimator;
    shader.shade(std::span(&leaf, 1));
    shader.finish();
    EXPECT_EQ(sums[leaf.root].weight, leaf.weight);
    EXPECT_NEAR(sums[leaf.root].mean().r, 0.88f, 0.05f) << static_cast<int>(estimator);
  }
}

// A mirror's viewer does not see the mirror; a viewer outside of glass does not see its inner side.
TEST(EyeSamples, LookWhereTheyProbe) {
  World world;
  Material sheet = matte(glm::vec3(0.5f));
  sheet.double_sided = true;
  add_quad(world, {-20, 20, 0}, {40, 0, 0}, {0, -40, 0}, sheet);
  add_quad(world, {-20, -20, -5}, {40, 0, 0}, {0, 40, 0}, matte(glm::vec3(0.5f)));
  for (const bool glass : {false, true}) {
    EyeBlock block = block_of(world, {});
    EyeContext eye = block.eye();
    if (glass) {
      eye.viewer.passage.part = 0;
    } else {
      eye.viewer.mirror = MirrorPlane{HalfSpace::through({0, 0, 0}, {0, 0, 1}), 1e-3};
    }
    EyeSamples samples(eye);
    const std::array places{glm::vec2(0.3f, 0.4f), glm::vec2(0.8f, 0.1f)};
    const SampleId first = samples.probe(places);
    std::vector<SurfacePoint> seen;
    samples.look(places, seen, block.counts());
    ASSERT_EQ(seen.size(), places.size());
    for (SampleId i = 0; i < places.size(); ++i) {
      EXPECT_NEAR(samples.point(first + i).position.z, -5.0f, 1e-4f);
      EXPECT_EQ(seen[i].position, samples.point(first + i).position)
          << (glass ? "glass" : "mirror");
    }
  }
}

TEST(SingleSamples, ShadeByOneSampleEach) {
  EyeBlock block = block_of(wall(glows({0.25f, 0.5f, 1.0f})), {}, at_max(0));
  SingleSamples samples(block.eye(), block.samples());
  EXPECT_TRUE(samples.run().empty());
  samples.add(pixel_leaf(block, 0, 0, 1.0));
  samples.add(pixel_leaf(block, 3, 2, 0.25));
  const auto found = samples.run();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].leaf->root, 0u);
  EXPECT_EQ(found[1].leaf->root, 11u);
  EXPECT_EQ(found[1].leaf->weight, 0.25);
  for (const Contribution& one : found) {
    EXPECT_FALSE(one.dropped);
    EXPECT_NEAR(one.radiance.r, 0.25 * one.leaf->weight, 1e-6);
    EXPECT_NEAR(one.radiance.g, 0.5 * one.leaf->weight, 1e-6);
    EXPECT_NEAR(one.radiance.b, 1.0 * one.leaf->weight, 1e-6);
  }
  EXPECT_TRUE(samples.run().empty()) << "none waits";
}

// One important bulb, and many unimportant ones that deserve few rays together.
TEST(SelectedLights, AreTheDimLights) {
  std::vector<Light> lights{bulb({0, 0, 4}, 100.0f)};
  for (int i = 0; i < 20; ++i) lights.push_back(bulb({0.3 * i - 3.0, 1.0, 4.0}, 0.01f));
  EyeBlock many = block_of(wall(matte({0.8f, 0.8f, 0.8f})), lights);
  many.selected_lights().find(EyeBlock::side);
  EXPECT_FALSE(many.selected_lights().holds(0));
  for (std::size_t i = 1; i < lights.size(); ++i) EXPECT_TRUE(many.selected_lights().holds(i)) << i;

  lights.resize(LightSelection::few_lights);
  EyeBlock few = block_of(wall(matte({0.8f, 0.8f, 0.8f})), lights);
  few.selected_lights().find(EyeBlock::side);
  EXPECT_TRUE(few.selected_lights().lights().empty()) << "so few lights are tested individually";
  few.selected_lights().take_all();
  EXPECT_TRUE(few.selected_lights().lights().empty());
}

// Callers that send a single ray select from all lights.
TEST(SelectedLights, IncludeAllLightsOnDemand) {
  std::vector<Light> lights{bulb({0, 0, 4}, 100.0f)};
  for (int i = 0; i < 20; ++i) lights.push_back(bulb({0.3 * i - 3.0, 1.0, 4.0}, 0.01f));
  EyeBlock many = block_of(wall(matte({0.8f, 0.8f, 0.8f})), lights);
  many.selected_lights().take_all();
  for (std::size_t i = 0; i < lights.size(); ++i) EXPECT_TRUE(many.selected_lights().holds(i)) << i;
}

}  // namespace
}  // namespace asos::test::leaves_test
