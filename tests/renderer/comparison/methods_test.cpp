#include "renderer/comparison/method.h"
#include "renderer/samples/sample_block.h"
#include "renderer/sampling/random.h"
#include "renderer/shading/environment.h"
#include "tests/support/make_settings.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace asos::methods_test {
namespace {

/// A white half-plane left of the line x = 0.3 + 0.2 y in front of the grey background, for an
/// orthographic camera with pixels of 1 x 1. The line crosses pixel (4, 4) of 8 x 8.
std::shared_ptr<const RenderScene> half_plane() {
  World world;
  test::add_part(world,
                 {{{0.3f + 0.2f * 20, 20, 0}, {0, 0, 1}, {}},
                  {{-50, 20, 0}, {0, 0, 1}, {}},
                  {{-50, -20, 0}, {0, 0, 1}, {}},
                  {{0.3f - 0.2f * 20, -20, 0}, {0, 0, 1}, {}}},
                 {{0, 1, 2}, {0, 2, 3}}, test::unlit({1, 1, 1}));
  return test::make_render_scene(std::move(world));
}

constexpr PixelRect block{0, 0, 8, 8};

float pixel(const BlockResult& result, int x, int y) {
  return result.tile.radiance[static_cast<std::size_t>(8 * y + x)].r;
}

/// Pixel (4, 4) is 0..1 by -1..0 in the world: the mean of 0.3 + 0.2 y there is 0.2.
constexpr float expected_pixel = 0.2f + 0.8f * sky_radiance;

RenderSettings small_settings(Method method, int spp) {
  return test::make_settings(8, 8, method, spp);
}

// The other methods take the same samples for any curve, so it is applied for display only.
TEST(Methods, ThoseThatAdaptJudgeByTheCurveThatIsShown) {
  for (const MethodRow& row : method_table()) {
    const bool adapts = row.value == Method::asos || row.value == Method::sobol_adaptive ||
                        row.value == Method::whitted || row.value == Method::mitchell;
    EXPECT_EQ(row.judges_display, adapts) << row.name;
    RenderSettings settings = small_settings(row.value, 4);
    settings.judged_tone = ToneCurve::neutral;
    EXPECT_EQ(judged_by(settings, ToneCurve::agx).judged_tone,
              adapts ? ToneCurve::agx : ToneCurve::none)
        << row.name;
  }
}

/// A new method needs only its function and its row in the table.
BlockResult render_block_checkered(const BlockJob& job) {
  BlockResult result{.tile = {.rect = job.block}};
  for (int y = job.block.y; y < job.block.y + job.block.height; ++y) {
    for (int x = job.block.x; x < job.block.x + job.block.width; ++x) {
      result.tile.radiance.emplace_back((x + y) % 2 == 0 ? 0.0f : 1.0f);
      result.tile.split_level.push_back(0);
      ++result.statistics.eye_rays;
    }
  }
  return result;
}

TEST(MethodTable, AnotherMethodIsAFunctionAndARow) {
  std::vector<MethodRow> methods(method_table().begin(), method_table().end());
  const auto checkered = static_cast<Method>(methods.size());
  methods.push_back({.value = checkered,
                     .name = "checkered",
                     .render = render_block_checkered,
                     .block_side = [](const RenderSettings&) { return block_size; }});
  const auto scene = half_plane();
  const View view(test::orthographic(8.0), 8, 8);
  const RenderSettings settings = small_settings(checkered, 1);
  const BlockResult r = render_block({*scene, view, settings, block}, methods);
  ASSERT_EQ(r.tile.radiance.size(), 64u);
  EXPECT_EQ(pixel(r, 2, 4), 0.0f);
  EXPECT_EQ(pixel(r, 3, 4), 1.0f);
  EXPECT_EQ(r.tile.cause, std::vector<SplitCause>(64, SplitCause::none));
  EXPECT_EQ(r.tile.rays, std::vector<float>(64, 1.0f));
  // The built-in methods are unchanged.
  const RenderSettings uniform = small_settings(Method::uniform, 16);
  EXPECT_EQ(render_block({*scene, view, uniform, block}, methods).tile.radiance,
            render_block(*scene, view, uniform, block).tile.radiance);
}

TEST(MethodTable, HasARowForEachMethod) {
  ASSERT_EQ(method_table().size(), static_cast<std::size_t>(last_method) + 1);
  std::set<std::string> names, titles;
  for (const MethodRow& row : method_table()) {
    EXPECT_EQ(&row_of(row.value), &row);
    EXPECT_NE(row.about, std::string()) << row.name;
    EXPECT_NE(row.render, nullptr) << row.name;
    names.insert(row.name);
    titles.insert(row.title);
    RenderSettings settings{.method = row.value};
    EXPECT_TRUE(validated(settings).has_value()) << row.name;
    EXPECT_EQ(block_side(settings) % block_size, 0) << row.name;
  }
  EXPECT_EQ(names.size(), method_table().size());
  EXPECT_EQ(titles.size(), method_table().size());
  EXPECT_TRUE(in_object_space(Method::asos_published));
  EXPECT_FALSE(in_object_space(Method::beam));
}

TEST(Uniform, ConvergesOnTheCoverageOfAHalfPlane) {
  const auto scene = half_plane();
  const View view(test::orthographic(8.0), 8, 8);
  for (const int spp : {16, 256, 4096}) {
    const BlockResult r = render_block(*scene, view, small_settings(Method::uniform, spp), block);
    // Each of the n rows rounds its coverage to a multiple of 1 / n: an error of at most half a
    // column.
    const double bound = (1.0 - sky_radiance) * 0.5 / std::sqrt(spp) + 1e-5;
    EXPECT_NEAR(pixel(r, 4, 4), expected_pixel, bound) << spp;
    EXPECT_FLOAT_EQ(pixel(r, 0, 0), 1.0f);
    EXPECT_FLOAT_EQ(pixel(r, 7, 7), sky_radiance);
    EXPECT_EQ(r.statistics.eye_rays, 64u * static_cast<unsigned>(spp));
  }
}

TEST(Stochastic, ConvergesOnTheCoverageOfAHalfPlane) {
  const auto scene = half_plane();
  const View view(test::orthographic(8.0), 8, 8);
  for (const int spp : {16, 256, 4096}) {
    const BlockResult r =
        render_block(*scene, view, small_settings(Method::stochastic, spp), block);
    // The line crosses about 1.2 n strata, each with a variance of at most 1/4. Allows five
    // standard deviations.
    const double n = std::sqrt(spp);
    const double bound = 5.0 * (1.0 - sky_radiance) * std::sqrt(1.3 * n * 0.25) / (n * n);
    EXPECT_NEAR(pixel(r, 4, 4), expected_pixel, bound) << spp;
  }
}

TEST(GridSide, IsTheFirstSquareOfAtLeastThatMany) {
  EXPECT_EQ(grid_side(1), 1);
  EXPECT_EQ(grid_side(2), 2);
  EXPECT_EQ(grid_side(4), 2);
  EXPECT_EQ(grid_side(5), 3);
  EXPECT_EQ(grid_side(65536), 256);
}

TEST(Stochastic, SamplesBelongToThePixelAndNotToTheBlock) {
  const auto scene = test::make_render_scene(test::still_life());
  const View view(test::look_at({2, 2, 5}, {0, 0.7, 0}, 0.7), 20, 13);
  RenderSettings settings = small_settings(Method::stochastic, 9);
  settings.width = 20;
  settings.height = 13;
  const PixelRect clipped{16, 8, 4, 5};
  const BlockResult once = render_block(*scene, view, settings, clipped);
  const BlockResult again = render_block(*scene, view, settings, clipped);
  EXPECT_EQ(once.tile.radiance, again.tile.radiance);
  EXPECT_EQ(once.tile.rect, clipped);
  EXPECT_EQ(once.tile.radiance.size(), 20u);
  EXPECT_EQ(once.tile.split_level.size(), 20u);
}

TEST(SampleBlock, DropsAndCountsWhatIsNotFinite) {
  // A NaN in a vertex colour affects only the lower right triangle.
  World world;
  test::add_quad(world, {-4, -4, 0}, {8, 0, 0}, {0, 8, 0}, test::unlit({1, 1, 1}));
  world.colors.assign(4, glm::vec4(1));
  world.colors[1].r = std::numeric_limits<float>::quiet_NaN();
  const auto scene = test::make_render_scene(std::move(world));
  const View view(test::orthographic(8.0), 8, 8);
  const BlockResult r = render_block(*scene, view, small_settings(Method::uniform, 16), block);
  std::uint64_t black = 0;
  for (const glm::vec3& c : r.tile.radiance) {
    ASSERT_TRUE(std::isfinite(c.r));
    EXPECT_TRUE(c == glm::vec3(1) || c == glm::vec3(0)) << c.r;
    black += c == glm::vec3(0) ? 1 : 0;
  }
  // 28 pixels are completely below the diagonal; those on it keep their upper samples.
  EXPECT_EQ(black, 28u);
  EXPECT_GE(r.statistics.rejected_samples, 28u * 16u + 8u * 6u);
  EXPECT_LE(r.statistics.rejected_samples, 28u * 16u + 8u * 10u);
}

TEST(SampleBlock, StopsWhenAsked) {
  const auto scene = test::make_render_scene(test::still_life());
  const View view(test::look_at({2, 2, 5}, {0, 0.7, 0}, 0.7), 8, 8);
  std::stop_source stop;
  stop.request_stop();
  const BlockResult r = render_block(*scene, view, small_settings(Method::stochastic, 65536), block,
                                     stop.get_token());
  EXPECT_LT(r.statistics.eye_rays, 1000u);
}

TEST(Random, IsAFunctionOfItsKeysAndEven) {
  EXPECT_EQ(pixel_random(3, 5, 7), pixel_random(3, 5, 7));
  std::set<std::uint64_t> seen;
  double u = 0.0;
  double v = 0.0;
  double uv = 0.0;
  constexpr int n = 64;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      const std::uint64_t bits = pixel_random(x, y, static_cast<std::uint32_t>(x ^ y));
      seen.insert(bits);
      const RandomPair p = unit_pair(bits);
      ASSERT_GE(p.u, 0.0);
      ASSERT_LT(p.u, 1.0);
      u += p.u;
      v += p.v;
      uv += (p.u - 0.5) * (p.v - 0.5);
    }
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(n * n));
  // Allows five standard deviations of means of 4096 uniform numbers and of their product.
  EXPECT_NEAR(u / (n * n), 0.5, 5.0 * std::sqrt(1.0 / 12.0) / n);
  EXPECT_NEAR(v / (n * n), 0.5, 5.0 * std::sqrt(1.0 / 12.0) / n);
  EXPECT_NEAR(uv / (n * n), 0.0, 5.0 / 12.0 / n);
}

TEST(Settings, DefaultsAndEdgesAreValid) {
  EXPECT_TRUE(validated(RenderSettings{}).has_value());
  RenderSettings s{.crop = {1270, 0, 10, 720}, .asos = {.max_level = 8, .eps = 0.0}};
  ASSERT_TRUE(validated(s).has_value());
  EXPECT_EQ(*validated(s), s);
  EXPECT_EQ(s.visible(), s.crop);
  EXPECT_EQ(RenderSettings{}.visible(), (PixelRect{0, 0, 1280, 720}));
}

TEST(Settings, EachMistakeIsNamed) {
  const auto refused = [](auto change, const std::string& subject) {
    RenderSettings s;
    change(s);
    const auto result = validated(s);
    ASSERT_FALSE(result.has_value()) << subject;
    EXPECT_EQ(result.error().subject, subject);
    EXPECT_FALSE(result.error().reason.empty());
  };
  constexpr int most = std::numeric_limits<int>::max();
  refused([](RenderSettings& s) { s.width = 0; }, "width");
  refused([](RenderSettings& s) { s.width = 32769; }, "width");
  refused([](RenderSettings& s) { s.height = -3; }, "height");
  refused([](RenderSettings& s) { s.asos.max_level = 9; }, "max");
  refused([](RenderSettings& s) { s.asos.max_level = -1; }, "max");
  refused([](RenderSettings& s) { s.asos.eps = std::numeric_limits<double>::quiet_NaN(); }, "eps");
  refused([](RenderSettings& s) { s.asos.eps = 1.5; }, "eps");
  refused([](RenderSettings& s) { s.sampling.spp = 0; }, "spp");
  refused([](RenderSettings& s) { s.sampling.spp = most; }, "spp");
  refused([](RenderSettings& s) { s.threads = -1; }, "threads");
  refused([](RenderSettings& s) { s.crop = {10, 10, 0, 5}; }, "crop");
  refused([](RenderSettings& s) { s.crop = {-1, 0, 5, 5}; }, "crop");
  refused([](RenderSettings& s) { s.crop = {1275, 0, 6, 5}; }, "crop");
  refused([](RenderSettings& s) { s.crop = {most, most, most, most}; }, "crop");
  refused([](RenderSettings& s) { s.method = static_cast<Method>(99); }, "method");
}

TEST(Prepare, LightsASceneWithoutLights) {
  Scene scene{.source = "test"};
  Mesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}};
  scene.meshes.push_back(mesh);
  Instance instance{.mesh = 0};
  scene.instances.push_back(instance);
  const auto prepared = prepare(scene);
  ASSERT_TRUE(prepared.has_value()) << prepared.error().message();
  EXPECT_TRUE((*prepared)->lighting->default_lights_added);
  EXPECT_FALSE((*prepared)->lights().empty());
  EXPECT_GT((*prepared)->geometry->memory_mb(), 0.0);
  EXPECT_EQ((*prepared)->geometry->source, "test");

  scene.lights.emplace_back();
  const auto lit = prepare(scene);
  ASSERT_TRUE(lit.has_value());
  EXPECT_FALSE((*lit)->lighting->default_lights_added);
  EXPECT_EQ((*lit)->lights().size(), 1u);
}

TEST(Prepare, AnEmptySceneRendersTheBackground) {
  const auto prepared = prepare(Scene{});
  ASSERT_TRUE(prepared.has_value()) << prepared.error().message();
  const View view(test::orthographic(8.0), 8, 8);
  for (const Method method : {Method::asos, Method::uniform, Method::stochastic}) {
    const BlockResult r = render_block(**prepared, view, small_settings(method, 4), block);
    ASSERT_EQ(r.tile.radiance.size(), 64u);
    for (const glm::vec3& c : r.tile.radiance) EXPECT_EQ(c, background_radiance);
  }
}

}  // namespace
}  // namespace asos::methods_test
