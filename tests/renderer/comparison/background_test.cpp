#include "renderer/shading/sky.h"
#include "tests/renderer/comparison/rival_scenes.h"
#include "tests/support/polygon.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

// The background behind surfaces, and the coverage of pixels by surfaces.

namespace asos {
namespace {

constexpr double tilt = 0.37;   // slope of a half-plane's border
constexpr double cross = 3.21;  // its intersection with the picture's left border, in pixels

/// The half-plane below the line y = cross + tilt x, in pixels.
World half_plane(const Material& material) {
  World world;
  const auto at = [](double x, double y) { return glm::vec3(glm::dvec3(x - 4.0, 4.0 - y, 0.0)); };
  test::add_triangle(world, at(-90.0, cross - 90.0 * tilt), at(0.0, 300.0),
                     at(90.0, cross + 90.0 * tilt), material);
  return world;
}

/// The fraction of pixel (x, y) that the half-plane covers.
double covered(int x, int y) {
  const test::Polygon below = test::clip({{x, y}, {x + 1.0, y}, {x + 1.0, y + 1.0}, {x, y + 1.0}},
                                         [](glm::dvec2 p) { return p.y - cross - tilt * p.x; });
  return below.size() < 3 ? 0.0 : test::area(below);
}

RenderSettings clear(Method method, int spp = 16) {
  RenderSettings settings = test::settings_for(method, spp);
  settings.background.kind = BackgroundKind::transparent;
  return settings;
}

/// The largest error of pixels' coverage, for an emissive surface of this colour. Its radiance has
/// to be proportional to the coverage.
double most_off(const RenderSettings& settings) {
  const glm::vec3 colour(0.25f, 0.5f, 1.0f);
  const auto scene = test::make_render_scene(half_plane(test::unlit(colour)));
  const BlockResult result = test::render_small(*scene, settings);
  double most = 0.0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto i = static_cast<std::size_t>(8 * y + x);
      const float alpha = result.tile.coverage.at(i);
      most = std::max(most, std::abs(static_cast<double>(alpha) - covered(x, y)));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(result.tile.radiance[i][c], alpha * colour[c], 1e-6) << x << ", " << y;
    }
  }
  return most;
}

TEST(Background, AsosCoverageOfAHalfPlaneIsExact) {
  EXPECT_LT(most_off(clear(Method::asos)), 2e-6);
  EXPECT_LT(most_off(clear(Method::beam)), 2e-6);
}

// The error is less than the area of the strata that the line crosses: 2 / n for n strata per side.
TEST(Background, SamplersEstimateCoverage) {
  for (const Method method : {Method::uniform, Method::stochastic, Method::sobol}) {
    const double off = most_off(clear(method, 256));
    EXPECT_LT(off, 2.0 / 16.0) << static_cast<int>(method);
    EXPECT_GT(off, 1e-5) << "they estimate it only";
  }
  // Adaptive methods take coverage into account: a black surface has edges, too.
  RenderSettings settings = clear(Method::sobol_adaptive);
  settings.asos.eps = 0.0;
  EXPECT_LT(most_off(settings), 0.1);
  settings = clear(Method::whitted);
  settings.sampling.depth = 6;
  EXPECT_LT(most_off(settings), 0.05);
}

TEST(Background, ADiskCoversItsArea) {
  World world;
  const glm::dmat4 facing{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0.3, -0.2, 0, 1}};
  Material white = test::unlit(glm::vec3(1.0f));
  white.double_sided = true;
  test::add_shape(world, test::disk(2.5), facing, white);
  const auto scene = test::make_render_scene(std::move(world));
  double all = 0.0;
  for (const float alpha : test::render_small(*scene, clear(Method::asos)).tile.coverage)
    all += static_cast<double>(alpha);
  EXPECT_NEAR(all, std::numbers::pi * 2.5 * 2.5, 1e-3);
}

// Pixels are mixed by coverage for every kind of background, so edges are equally exact.
TEST(Background, IsBlendedByCoverage) {
  const auto scene = test::make_render_scene(half_plane(test::matte(glm::vec3(0.7f, 0.2f, 0.1f))));
  for (const Method method : {Method::asos, Method::sobol, Method::beam}) {
    const BlockResult alone = test::render_small(*scene, clear(method));
    RenderSettings settings = test::settings_for(method);
    settings.background = {BackgroundKind::colours, {2.0f, 0.5f, 0.0f}, {2.0f, 0.5f, 0.0f}};
    const BlockResult before = test::render_small(*scene, settings);
    EXPECT_TRUE(before.tile.coverage.empty());
    for (std::size_t i = 0; i < 64; ++i) {
      const glm::vec3 mixed =
          alone.tile.radiance[i] + (1.0f - alone.tile.coverage[i]) * settings.background.top;
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(before.tile.radiance[i][c], mixed[c], 1e-5)
            << static_cast<int>(method) << ": pixel " << i;
    }
  }
}

// A gradient over the picture's height, for any camera: a pixel is the gradient's mean over it.
TEST(Background, AGradientRunsDownThePicture) {
  const auto scene = test::make_render_scene(half_plane(test::unlit(glm::vec3(1.0f))));
  RenderSettings settings = test::settings_for(Method::asos);
  settings.background = {BackgroundKind::colours, {0.0f, 1.0f, 0.5f}, {4.0f, 0.0f, 0.5f}};
  Camera perspective = test::orthographic(8.0);
  perspective.type = Camera::Type::perspective;
  perspective.fov_y_rad = 1.9;
  for (const Camera& camera : {test::orthographic(8.0), perspective}) {
    const BlockResult result =
        render_block(*scene, View(camera, 8, 8), settings, test::small_block);
    for (int y = 0; y < 3; ++y) {
      const glm::vec3 seen = result.tile.radiance[static_cast<std::size_t>(8 * y + 7)];
      EXPECT_NEAR(seen.x, 4.0 * (y + 0.5) / 8.0, 1e-5);
      EXPECT_NEAR(seen.y, 1.0 - (y + 0.5) / 8.0, 1e-5);
      EXPECT_NEAR(seen.z, 0.5, 1e-6);
    }
  }
}

TEST(Background, ABlurredSkyIsItsMeanAroundADirection) {
  World world = half_plane(test::unlit(glm::vec3(1.0f)));
  const auto scene = test::make_render_scene(std::move(world));
  RenderSettings settings = test::settings_for(Method::asos);
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f), glm::vec3(1.0f));
  Camera up = test::orthographic(8.0);  // straight up, where the sky is darkest
  up.world_from_camera = {{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 9, 0, 1}};
  const auto seen = [&](BackgroundKind kind) {
    settings.background.kind = kind;
    return render_block(*scene, View(up, 8, 8), settings, test::small_block).tile.radiance[9].x;
  };
  EXPECT_NEAR(seen(BackgroundKind::environment), 0.0f, 1e-6f);
  // Mean of 1 - 1 / sqrt(1 + x^2 + y^2) over a square of 0.95.
  double mean = 0.0;
  constexpr int n = 400;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = 0.95 * ((i + 0.5) / n - 0.5), y = 0.95 * ((j + 0.5) / n - 0.5);
      mean += (1.0 - 1.0 / std::sqrt(1.0 + x * x + y * y)) / (n * n);
    }
  EXPECT_NEAR(seen(BackgroundKind::blurred), mean, 0.005);
}

// A mirror in front of the camera reflects the sky behind it, not the background.
TEST(Background, MirrorsSeeTheEnvironment) {
  Material mirror{.base_color = glm::vec4(1.0f), .metallic = 1.0f, .roughness = 0.0f};
  const auto scene = test::make_render_scene(half_plane(mirror));
  for (const Method method : {Method::asos, Method::sobol}) {
    RenderSettings settings = test::settings_for(method);
    settings.sky = std::make_shared<const Sky>(glm::vec3(0.2f, 0.4f, 0.6f));
    const BlockResult as_usual = test::render_small(*scene, settings);
    settings.background = {BackgroundKind::colours, {9.0f, 9.0f, 9.0f}, {9.0f, 9.0f, 9.0f}};
    const BlockResult other = test::render_small(*scene, settings);
    EXPECT_EQ(other.tile.radiance[63], as_usual.tile.radiance[63]);
    EXPECT_NEAR(other.tile.radiance[63].y, 0.4f, 1e-3f);
    EXPECT_EQ(other.tile.radiance[0], glm::vec3(9.0f));
  }
}

TEST(Background, BlendedSurfacesLetItThroughByTheirOpacity) {
  const auto scene =
      test::make_render_scene(half_plane(test::unlit(glm::vec3(0.5f, 1.0f, 0.0f), 0.25f)));
  for (const Method method : {Method::asos, Method::sobol}) {
    const BlockResult result = test::render_small(*scene, clear(method));
    EXPECT_NEAR(result.tile.coverage[63], 0.25f, 1e-6f);
    EXPECT_NEAR(result.tile.radiance[63].y, 0.25f, 1e-6f);
  }
}

TEST(Background, IsCheckedLikeAllSettings) {
  RenderSettings settings{.background = {.kind = BackgroundKind::colours}};
  EXPECT_TRUE(validated(settings));
  for (const float bad : {-0.1f, 2e6f, NAN, INFINITY}) {
    settings.background.bottom.y = bad;
    ASSERT_FALSE(validated(settings)) << bad;
    EXPECT_EQ(validated(settings).error().subject, "background");
  }
}

}  // namespace
}  // namespace asos
