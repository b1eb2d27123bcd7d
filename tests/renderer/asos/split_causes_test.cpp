#include "renderer/asos/split_causes.h"

#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Causes of splits, in scenes with a known cause for each pixel.

namespace asos::test::split_causes_test {
namespace {

constexpr int size = 16;  // pixels; the camera sees 8 x 8 units from z = 10

Picture render(FlattenedScene scene, const RenderSettings& settings = make_settings(size, size)) {
  return render_picture(*make_render_scene(std::move(scene)), orthographic(8.0), settings);
}

SplitCause cause_at(const Picture& picture, int x, int y) {
  return picture.film.cause[picture.film.index(x, y)];
}

std::uint64_t pixels_with(const Picture& picture, SplitCause cause) {
  return picture.statistics.pixels_by_cause[static_cast<std::size_t>(cause)];
}

/// The statistics agree with the map, and only split pixels have a cause.
void expect_consistent(const Picture& picture) {
  for (std::size_t i = 1; i < split_cause_count; ++i) {
    const auto cause = static_cast<SplitCause>(i);
    EXPECT_EQ(pixels_with(picture, cause),
              static_cast<std::uint64_t>(
                  std::count(picture.film.cause.begin(), picture.film.cause.end(), cause)))
        << name_of(cause);
  }
  EXPECT_EQ(pixels_with(picture, SplitCause::none), 0u);
  std::uint64_t split = 0;
  for (std::size_t i = 0; i < picture.film.cause.size(); ++i) {
    const bool has_cause = picture.film.cause[i] != SplitCause::none;
    split += has_cause;
    EXPECT_TRUE(has_cause || picture.film.split_level[i] == 0) << i;
  }
  EXPECT_EQ(picture.statistics.split_pixels, split);
}

/// Expects split pixels, all of them with this cause.
void expect_only(const Picture& picture, SplitCause expected) {
  expect_consistent(picture);
  EXPECT_GT(pixels_with(picture, expected), 0u);
  for (const SplitCause cause : picture.film.cause)
    EXPECT_TRUE(cause == SplitCause::none || cause == expected) << name_of(cause);
}

void add_wall(World& world) {
  add_quad(world, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, matte(glm::vec3(0.5f)));
}

Light sun_from_the_right() {
  return make_sun(glm::normalize(glm::dvec3(-1, 0, -1)), 3.0f);
}

PixelFindings split_pixel() {
  return {.outcome = {.deepest = 1}};
}

TEST(CauseOf, WhatWasNotSplitHasNone) {
  PixelFindings pixel;
  EXPECT_EQ(cause_of(pixel), SplitCause::none);
  pixel.outcome.at_limit = true;  // at MAX 0
  EXPECT_EQ(cause_of(pixel), SplitCause::none);
  pixel.shadow_cut = true;
  EXPECT_EQ(cause_of(pixel), SplitCause::shadow);
}

// Each cause added later takes precedence over all before it.
TEST(CauseOf, FollowsTheOrderOfItsRule) {
  PixelFindings pixel = split_pixel();
  pixel.shadow_cut = true;
  pixel.outcome.uneven_shading = true;
  EXPECT_EQ(cause_of(pixel), SplitCause::shading);
  pixel.outcome.uneven_shadow = true;
  EXPECT_EQ(cause_of(pixel), SplitCause::shadow);
  pixel.outcome.boundaries.add(FeatureKind::seam);
  EXPECT_EQ(cause_of(pixel), SplitCause::crease);
  pixel.outcome.boundaries.add(FeatureKind::intersection);
  EXPECT_EQ(cause_of(pixel), SplitCause::intersection);
  pixel.outcome.boundaries.add(FeatureKind::silhouette);
  EXPECT_EQ(cause_of(pixel), SplitCause::outline);
  pixel.outcome.at_limit = true;
  EXPECT_EQ(cause_of(pixel), SplitCause::depth_limit);
  pixel.outcome.saturated = true;
  EXPECT_EQ(cause_of(pixel), SplitCause::saturation);
  pixel.by_samples = true;
  EXPECT_EQ(cause_of(pixel), SplitCause::cut_out);
}

TEST(CauseOf, EveryKindOfBoundaryHasOne) {
  for (const auto& [kind, cause] : {std::pair{FeatureKind::open, SplitCause::outline},
                                    {FeatureKind::silhouette, SplitCause::outline},
                                    {FeatureKind::cut_out, SplitCause::outline},
                                    {FeatureKind::crease, SplitCause::crease},
                                    {FeatureKind::seam, SplitCause::crease},
                                    {FeatureKind::intersection, SplitCause::intersection}}) {
    PixelFindings pixel = split_pixel();
    pixel.outcome.boundaries.add(kind);
    EXPECT_EQ(cause_of(pixel), cause);
  }
  EXPECT_EQ(cause_of(split_pixel()), SplitCause::outline);
}

// A card one unit in front of a wall; its shadow is shifted one unit to the left.
TEST(SplitCauses, AnOutlineAndTheEdgeOfItsHardShadow) {
  World world;
  add_wall(world);
  const double x0 = 1.13, x1 = 2.13, y1 = 1.1;
  add_quad(world, {x0, -y1, 1}, {x1 - x0, 0, 0}, {0, 2 * y1, 0}, matte(glm::vec3(0.8f)));
  const Picture picture = render({std::move(world), {sun_from_the_right()}});
  expect_consistent(picture);
  // Whether a border of the rectangle from a to b crosses a pixel.
  const auto on_border = [](glm::dvec2 a, glm::dvec2 b, int x, int y) {
    const glm::dvec2 lo(-4.0 + 0.5 * x, 3.5 - 0.5 * y), hi = lo + 0.5;
    const bool meets = lo.x < b.x && hi.x > a.x && lo.y < b.y && hi.y > a.y;
    const bool inside = lo.x > a.x && hi.x < b.x && lo.y > a.y && hi.y < b.y;
    return meets && !inside;
  };
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      SplitCause expected = SplitCause::none;
      if (on_border({x0 - 1.0, -y1}, {x1 - 1.0, y1}, x, y) && -4.0 + 0.5 * x < x0)
        expected = SplitCause::shadow;
      if (on_border({x0, -y1}, {x1, y1}, x, y)) expected = SplitCause::outline;
      EXPECT_EQ(cause_at(picture, x, y), expected)
          << name_of(cause_at(picture, x, y)) << " at " << x << ", " << y;
    }
  }
}

TEST(SplitCauses, AKinkAndALineWhereWallsPassThroughEachOther) {
  World roof;
  add_quad(roof, {-9, -9, -2}, {9.125f, 0, 2}, {0, 18, 0}, matte(glm::vec3(0.5f)));
  add_quad(roof, {0.125f, -9, 0}, {9, 0, -2}, {0, 18, 0}, matte(glm::vec3(0.5f)));
  const Picture kinked = render({std::move(roof), {}});
  expect_only(kinked, SplitCause::crease);
  World crossing;
  add_wall(crossing);
  add_quad(crossing, {-9, -9, -1}, {18.3f, 0, 2}, {0, 18, 0}, matte(glm::vec3(0.5f)));
  const Picture crossed = render({std::move(crossing), {}});
  expect_only(crossed, SplitCause::intersection);
  for (const Picture* picture : {&kinked, &crossed}) {
    EXPECT_EQ(picture->statistics.split_pixels, static_cast<std::uint64_t>(size))
        << "one pixel a row";
    EXPECT_EQ(std::count(picture->film.split_level.begin(), picture->film.split_level.end(), 0),
              size * size)
        << "one line cuts each pixel exactly, without a split";
  }
}

TEST(SplitCauses, ALightCloseToAWallIsShading) {
  World world;
  add_wall(world);
  const Light light = make_bulb({0.1, 0.2, 0.7}, 0.5f);
  expect_only(render({std::move(world), {light}}), SplitCause::shading);
}

TEST(SplitCauses, TheShadowOfASmallLightOfSomeSizeIsSplit) {
  World world;
  add_wall(world);
  add_quad(world, {0.13f, -9, 0.4f}, {9, 0, 0}, {0, 18, 0}, matte(glm::vec3(0.8f)));
  Light light{.radius = 0.05};
  light.intensity = 120.0f;  // so bright that it needs more than a few rays
  light.position = {-6, 0, 3};
  const Picture hidden = render({world, {light}});
  EXPECT_GT(pixels_with(hidden, SplitCause::outline), 0u);
  EXPECT_EQ(pixels_with(hidden, SplitCause::shadow), 0u) << "the card hides its shadow";
  light.position = {6, 0, 3};
  const Picture picture = render({std::move(world), {light}});
  expect_consistent(picture);
  std::uint64_t split_for_shadow = 0;
  for (std::size_t i = 0; i < picture.film.cause.size(); ++i)
    split_for_shadow += picture.film.cause[i] == SplitCause::shadow && picture.film.samples[i] > 0;
  EXPECT_GT(split_for_shadow, 0u);
}

World wall_behind_a_cut_out() {
  World world;
  add_wall(world);
  Image image{.width = 2, .height = 1, .rgba = {255, 255, 255, 0, 255, 255, 255, 255}};
  Material material = unlit(glm::vec3(1.0f));
  material.alpha_mode = AlphaMode::mask;
  material.base_color_texture.texture =
      add_texture(world, image, Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, {-8.2f, -9, 1}, {18, 0, 0}, {0, 18, 0}, material);
  return world;
}

TEST(SplitCauses, TheOutlineOfACutOutIsABoundary) {
  expect_only(render({wall_behind_a_cut_out(), {}}), SplitCause::outline);
}

TEST(SplitCauses, WhereItIsNotKnownSamplesFindIt) {
  World world = wall_behind_a_cut_out();
  leave_cut_outs_to_samples(world);
  expect_only(render({std::move(world), {}}), SplitCause::cut_out);
}

// So many edges in one pixel that it is sampled, and a fan of edges that is not.
TEST(SplitCauses, SaturationAndTheDepthLimit) {
  World world;
  add_wall(world);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.02f, 0.48f);
  for (int i = 0; i < 400; ++i) {
    const auto corner = [&] {
      return glm::vec3(unit(random), unit(random), 1.0f + 0.001f * static_cast<float>(i));
    };
    const glm::vec3 a = corner(), b = corner(), c = corner();
    add_triangle(world, a, b, c, matte(glm::vec3(0.5f)));
  }
  const Picture thicket = render({std::move(world), {}});
  expect_only(thicket, SplitCause::saturation);
  EXPECT_EQ(cause_at(thicket, 8, 7), SplitCause::saturation);

  World card;
  add_wall(card);
  add_quad(card, {-1.1f, -1.3f, 1}, {3, 0, 0}, {0, 2, 0}, matte(glm::vec3(0.8f)));
  RenderSettings settings = make_settings(size, size);
  settings.asos.leaf = LeafKind::point;
  settings.asos.eps = 0.0;
  expect_only(render({std::move(card), {}}, settings), SplitCause::depth_limit);
}

TEST(SplitCauses, OtherMethodsTellNone) {
  for (const Method method :
       {Method::uniform, Method::stochastic, Method::sobol, Method::sobol_adaptive, Method::beam}) {
    RenderSettings settings = make_settings(size, size, method);
    settings.sampling.spp = 4;
    const Picture picture = render(still_life(), settings);
    ASSERT_EQ(picture.film.cause.size(), static_cast<std::size_t>(size * size));
    for (const SplitCause cause : picture.film.cause) EXPECT_EQ(cause, SplitCause::none);
    for (const std::uint64_t pixels : picture.statistics.pixels_by_cause) EXPECT_EQ(pixels, 0u);
  }
}

TEST(LightCounts, AddUpToAllShadowRaysForEveryMethod) {
  FlattenedScene still = still_life();
  const Light ball = make_bulb({1, 3, 2}, 10.0f, 0.2);
  still.lights.push_back(ball);
  Light unshadowed = ball;
  unshadowed.casts_shadows = false;
  still.lights.push_back(unshadowed);
  const auto scene = make_render_scene(std::move(still));
  for (const Method method :
       {Method::asos, Method::asos_published, Method::uniform, Method::stochastic, Method::sobol,
        Method::sobol_adaptive, Method::beam}) {
    RenderSettings settings = make_settings(size, size, method);
    settings.sampling.spp = 4;
    const Picture picture = render_picture(*scene, look_at({2, 2, 5}, {0, 0.7, 0}, 0.7), settings);
    const RenderStatistics& counts = picture.statistics;
    std::uint64_t rays = 0, pyrays = 0;
    for (const LightStatistics& light : counts.lights) {
      rays += light.shadow_rays;
      pyrays += light.shadow_pyrays;
    }
    SCOPED_TRACE(static_cast<int>(method));
    EXPECT_EQ(rays, counts.shadow_rays);
    EXPECT_EQ(pyrays, counts.shadow_pyrays);
    EXPECT_GT(counts.of_light(0).shadow_rays, 0u);
    EXPECT_GT(counts.of_light(1).shadow_rays, 0u);
    EXPECT_EQ(counts.of_light(2).shadow_rays, 0u);
  }
}

}  // namespace
}  // namespace asos::test::split_causes_test
