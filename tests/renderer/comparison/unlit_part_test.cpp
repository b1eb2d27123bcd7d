#include "tests/renderer/comparison/rival_scenes.h"
#include "tests/support/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

// The fraction of pixels that shows unlit surfaces, next to lit ones.

namespace asos {
namespace {

constexpr double slope = 0.37;     // slope of the half-plane's border
constexpr double crossing = 3.21;  // its intersection with the picture's left border, in pixels
const glm::vec3 unlit_orange(1.0f, 0.5f, 0.25f);
const glm::vec3 glow(2.0f, 0.5f, 0.0f);

/// The half-plane below the line y = crossing + slope x, in pixels, in front of an emissive wall.
World unlit_before_glow(const Material& material) {
  World world;
  const auto at = [](double x, double y) { return glm::vec3(glm::dvec3(x - 4.0, 4.0 - y, 0.0)); };
  test::add_triangle(world, at(-90.0, crossing - 90.0 * slope), at(0.0, 300.0),
                     at(90.0, crossing + 90.0 * slope), material);
  Material wall = test::matte(glm::vec3(0.0f));
  wall.specular = 0.0f;
  wall.emissive = glow;
  test::add_card(world, {-9, -9}, {17, 17}, wall, -1.0f);
  return world;
}

/// The area of pixel (x, y) that the half-plane covers.
double unlit_area(int x, int y) {
  const test::Polygon below = test::clip({{x, y}, {x + 1.0, y}, {x + 1.0, y + 1.0}, {x, y + 1.0}},
                                         [](glm::dvec2 p) { return p.y - crossing - slope * p.x; });
  return below.size() < 3 ? 0.0 : test::area(below);
}

BlockResult render_apart(const RenderScene& scene, const RenderSettings& settings) {
  const View view(test::orthographic(8.0), 8, 8);
  const BlockJob job{scene, view, settings, test::small_block};
  BlockResult result = render_block(job);
  add_unlit(job, result);
  return result;
}

/// The largest error of the fractions. The unlit colour has to be proportional to the fraction, and
/// together with the lit rest it has to give the radiance, within `rest`.
double share_error(const RenderSettings& settings, double rest) {
  const auto scene = test::make_render_scene(unlit_before_glow(test::unlit(unlit_orange)));
  const BlockResult result = render_apart(*scene, settings);
  double most = 0.0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto i = static_cast<std::size_t>(8 * y + x);
      const glm::vec4 part = result.tile.unlit.at(i);
      most = std::max(most, std::abs(static_cast<double>(part.w) - unlit_area(x, y)));
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(part[c], part.w * unlit_orange[c], rest) << x << ", " << y;
        EXPECT_NEAR(result.tile.radiance[i][c] - part[c], (1.0f - part.w) * glow[c], rest)
            << x << ", " << y;
      }
    }
  }
  return most;
}

TEST(UnlitPart, AsosAndBeamFindItsAreaExactly) {
  EXPECT_LT(share_error(test::settings_for(Method::asos), 1e-5), 2e-6);
  EXPECT_LT(share_error(test::settings_for(Method::beam), 1e-5), 2e-6);
}

TEST(UnlitPart, SamplersCountItInTheSamplesOfThePicture) {
  for (const Method method :
       {Method::uniform, Method::stochastic, Method::sobol, Method::ray_bound}) {
    const double error = share_error(test::settings_for(method, 256), 1e-5);
    EXPECT_LT(error, 2.0 / 16.0) << static_cast<int>(method);
    EXPECT_GT(error, 1e-5) << "the samples do not hit the area exactly";
  }
}

// The two passes stop separately, so their sample counts differ.
TEST(UnlitPart, AdaptiveMethodsFindItWithinTheirError) {
  RenderSettings settings = test::settings_for(Method::sobol_adaptive);
  settings.asos.eps = 1.0 / 256.0;
  EXPECT_LT(share_error(settings, 0.05), 0.05);
  settings = test::settings_for(Method::whitted);
  settings.sampling.depth = 6;
  EXPECT_LT(share_error(settings, 0.1), 0.05);
}

TEST(UnlitPart, OfABlendedSurfaceIsItsOpacity) {
  const auto scene = test::make_render_scene(unlit_before_glow(test::unlit(unlit_orange, 0.25f)));
  for (const Method method : {Method::asos, Method::sobol, Method::average}) {
    const BlockResult result = render_apart(*scene, test::settings_for(method));
    const glm::vec4 part = result.tile.unlit.at(63);
    EXPECT_NEAR(part.w, 0.25f, 1e-6f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(part[c], 0.25f * unlit_orange[c], 1e-6f);
    EXPECT_NEAR(result.tile.radiance[63].x, 0.25f * unlit_orange.x + 0.75f * glow.x, 1e-5f);
  }
}

// A block that an unlit surface fills needs no second pass: its unlit part is its radiance.
TEST(UnlitPart, OfASurfaceThatFillsTheBlockIsAll) {
  World world;
  test::add_card(world, {-9, -9}, {17, 17}, test::unlit(unlit_orange));
  const auto scene = test::make_render_scene(std::move(world));
  for (const Method method : {Method::asos, Method::sobol}) {
    const BlockResult result = render_apart(*scene, test::settings_for(method));
    EXPECT_FALSE(needs_unlit_colour(result.tile));
    for (std::size_t i = 0; i < 64; ++i)
      EXPECT_EQ(result.tile.unlit.at(i), glm::vec4(result.tile.radiance[i], 1.0f));
  }
}

// Reflections of unlit surfaces count as lit.
TEST(UnlitPart, IsNotSeenInMirrors) {
  Material mirror{.base_color = glm::vec4(1.0f), .metallic = 1.0f, .roughness = 0.0f};
  World world;
  test::add_card(world, {-9, -9}, {17, 17}, mirror);
  test::add_quad(world, {-90, 90, 20}, {180, 0, 0}, {0, -180, 0}, test::unlit(unlit_orange));
  Camera before = test::orthographic(8.0);
  before.world_from_camera[3].z = 10.0;
  const auto scene = test::make_render_scene(std::move(world));
  EXPECT_TRUE(has_unlit(scene->world()));
  const View view(before, 8, 8);
  for (const Method method : {Method::asos, Method::sobol}) {
    const RenderSettings settings = test::settings_for(method);
    const BlockJob job{*scene, view, settings, test::small_block};
    BlockResult result = render_block(job);
    EXPECT_NEAR(result.tile.radiance[9].y, unlit_orange.y, 1e-3f) << "the mirror shows it";
    add_unlit(job, result);
    EXPECT_TRUE(result.tile.unlit.empty());
  }
}

TEST(UnlitPart, IsEmptyWithoutUnlitSurfaces) {
  World world;
  test::add_card(world, {-9, -9}, {17, 17}, test::matte(glm::vec3(0.5f)));
  world.materials.push_back(test::unlit(unlit_orange));
  EXPECT_FALSE(has_unlit(world)) << "no surface has that material";
  const auto scene = test::make_render_scene(std::move(world));
  EXPECT_TRUE(render_apart(*scene, test::settings_for(Method::asos)).tile.unlit.empty());
}

}  // namespace
}  // namespace asos
