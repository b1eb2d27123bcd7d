#include "renderer/gltf/load.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Pictures of a floor under a large masked card whose outline is outside the view.

namespace asos::test::cut_out_pictures_test {
namespace {

Picture picture_of(const Light& light, Method method, int max_level, int spp, bool outlined = true,
                   double eps = 1.0 / 256.0) {
  World world;
  add_quad(world, {-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, matte({0.6f, 0.6f, 0.6f}));
  Material card = matte({1, 1, 1});
  card.alpha_mode = AlphaMode::mask;
  card.base_color_texture.texture = add_texture(
      world,
      make_image(96, 96,
                 [](int x, int y) -> Texel {
                   return {255, 255, 255, static_cast<std::uint8_t>((x + y) % 2 ? 255 : 0)};
                 }),
      Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, {-6, 2.6f, 6}, {12, 0, 0}, {0, 0, -12}, card);
  if (!outlined) leave_cut_outs_to_samples(world);
  RenderSettings settings = make_settings(48, 32, method, spp);
  settings.cull = false;
  settings.asos.max_level = max_level;
  settings.asos.eps = eps;
  const Camera camera = look_at({1.5, 2.0, 3.0}, {0.2, 0, 0.3}, 0.8);
  return render_picture(*make_render_scene(std::move(world), {light}), camera, settings);
}

double rms(const Picture& a, const Picture& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.film.radiance.size(); ++i) {
    const glm::dvec3 off = glm::dvec3(a.film.radiance[i]) - glm::dvec3(b.film.radiance[i]);
    sum += glm::dot(off, off) / 3.0;
  }
  return std::sqrt(sum / static_cast<double>(a.film.radiance.size()));
}

// Each level halves the side of cells, which divides the error by 2^1.5. EPS, the tolerance of
// shadow rays at any MAX, is reduced with the level.
void expect_error_falls(const Light& light, Method judge, int judge_spp) {
  const Picture truth = picture_of(light, judge, 3, judge_spp);
  double before = 0.0;
  for (int max_level = 1; max_level <= 4; ++max_level) {
    const double eps = std::ldexp(1.0, -2 * (max_level + 1));
    const double error = rms(picture_of(light, Method::asos, max_level, 1, false, eps), truth);
    if (max_level == 3) {
      EXPECT_LT(error, 0.5 * before) << light.name;
    }
    if (max_level == 1) before = error;
  }
}

std::vector<Light> hard_lights() {
  std::vector<Light> lights{point_light(), spot_light(), distant_light()};
  for (Light& light : lights) {
    light.position.y = 4;
    light.range = 1e9;
    if (light.type != Light::Type::directional) light.intensity = 20;
  }
  return lights;
}

std::vector<Light> small_area_lights() {
  std::vector<Light> lights{rectangle_light(), ball_light(0.02)};
  for (Light& light : lights) {
    light.position.y = 4;
    light.half_u = {0.02, 0, 0};
    light.half_v = {0, 0, -0.02};
    light.intensity = light.type == Light::Type::point ? 20.0f : 12500.0f;
  }
  return lights;
}

// The error is within the reference's noise, except under a light from above for far pixels that
// show hundreds of texels. At any MAX, outlines give a smaller error than samples only, with less
// than half the rays.
TEST(CutOutPictures, AreExactUnderHardLightsForFewTexels) {
  for (const Light& light : hard_lights()) {
    const Picture truth = picture_of(light, Method::uniform, 3, 1024);
    for (int max_level = 3; max_level <= 4; ++max_level) {
      const Picture cut = picture_of(light, Method::asos, max_level, 1);
      const Picture sampled = picture_of(light, Method::asos, max_level, 1, false);
      EXPECT_EQ(cut.statistics.missed_splits, 0u);
      EXPECT_LT(rms(cut, truth), rms(sampled, truth)) << light.name << ' ' << max_level;
      EXPECT_LT(2 * cut.statistics.rays(), sampled.statistics.rays());
      const bool far_texels = light.type == Light::Type::directional && max_level < 4;
      EXPECT_LT(rms(cut, truth), far_texels ? 3e-3 : 1.4e-3) << light.name << ' ' << max_level;
    }
  }
}

TEST(CutOutPictures, SampledErrorFallsWithMaxUnderHardLights) {
  for (const Light& light : hard_lights()) expect_error_falls(light, Method::uniform, 1024);
}

TEST(CutOutPictures, SampledErrorFallsWithMaxUnderSmallAreaLights) {
  for (const Light& light : small_area_lights()) expect_error_falls(light, Method::sobol, 1024);
}

// A lattice without known outlines before a dark board and the bright background. Pixels with the
// board's border took the parts that show the background as all of it, and lost the lattice.
TEST(CutOutPictures, WithoutOutlinesKeepTheLatticeBeforeTheBackground) {
  World world;
  add_quad(world, {-1.03f, -1.02f, -1}, {1.5f, 0.3f, 0}, {-0.2f, 1.3f, 0}, unlit(glm::vec3(0.1f)));
  Material lattice = unlit(glm::vec3(0.3f));
  lattice.alpha_mode = AlphaMode::mask;
  lattice.base_color_texture.texture = add_texture(
      world,
      make_image(96, 96,
                 [](int x, int y) -> Texel {
                   return {255, 255, 255, static_cast<std::uint8_t>(x % 3 && y % 4 ? 0 : 255)};
                 }),
      Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, lattice);
  leave_cut_outs_to_samples(world);
  const auto scene = make_render_scene(std::move(world), {});
  EXPECT_TRUE(scene->features().cut_outs_unbounded());
  RenderSettings settings = make_settings(16, 16);
  settings.background.kind = BackgroundKind::colours;
  settings.background.top = settings.background.bottom = glm::vec3(0.9f);
  const Picture found = render_picture(*scene, orthographic(2.0), settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 1024;
  EXPECT_LT(rms(found, render_picture(*scene, orthographic(2.0), settings)), 0.006);
}

// Leaves in front of leaves, iron in front of its own shadow: many outlines per pixel.
TEST(CutOutPictures, BuiltInScenesMatchManySamples) {
  for (const char* source : {"builtin:railing", "builtin:foliage"}) {
    const auto loaded = load_scene(source);
    ASSERT_TRUE(loaded);
    const auto scene = prepare(*loaded);
    ASSERT_TRUE(scene);
    EXPECT_FALSE((*scene)->features().cut_outs_unbounded());
    RenderSettings settings = make_settings(96, 54);
    const Camera camera = first_camera((*scene)->world(), 16.0 / 9.0);
    settings.method = Method::sobol;
    settings.sampling.spp = 1024;
    const Picture truth = render_picture(**scene, camera, settings);
    settings.method = Method::asos;
    for (const int max_level : {3, 4}) {
      settings.asos.max_level = max_level;
      const Picture cut = render_picture(**scene, camera, settings);
      EXPECT_LT(rms(cut, truth), 1e-3) << source << ' ' << max_level;
      RecordProperty(source + std::to_string(max_level), std::to_string(rms(cut, truth)));
    }
  }
}

/// A card that stands on a mirror, seen directly and reflected; or, without the mirror, the card
/// and its mirror image as two cards. The alpha texture has 10 x 10 texels and an outline.
Picture upon_mirror(bool mirrored) {
  World world;
  Material floor = matte({1, 1, 1});
  floor.metallic = 1.0f;
  floor.roughness = 0.0f;
  if (mirrored) add_quad(world, {-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, floor);
  add_quad(world, {-400, -400, -30}, {800, 0, 0}, {0, 800, 0}, unlit({0.1f, 0.1f, 0.1f}));
  Material card = unlit({0.9f, 0.9f, 0.9f});
  card.alpha_mode = AlphaMode::mask;
  card.double_sided = true;
  card.base_color_texture.texture = add_texture(
      world,
      make_image(
          10, 10,
          [](int x, int y) -> Texel {
            return {255, 255, 255, static_cast<std::uint8_t>((x * 83 + y * 59 + x * y) % 256)};
          }),
      Wrap::clamp_to_edge, Filter::linear);
  add_quad(world, {-1, 0.3f, 0}, {2, 0, 0}, {0, 2, 0}, card);
  // The card's mirror image.
  if (!mirrored) add_quad(world, {-1, -0.3f, 0}, {2, 0, 0}, {0, -2, 0}, card);
  RenderSettings settings = make_settings(48, 48);
  settings.cull = false;
  return render_picture(*make_render_scene(std::move(world)),
                        look_at({0.3, 2.5, 7}, {0, 0, 0}, 0.6), settings);
}

TEST(CutOutPictures, AreEquallyExactInMirrors) {
  const Picture seen = upon_mirror(true), built = upon_mirror(false);
  EXPECT_EQ(seen.statistics.missed_splits, 0u);
  EXPECT_LT(rms(seen, built), 2e-3);
}

}  // namespace
}  // namespace asos::test::cut_out_pictures_test
