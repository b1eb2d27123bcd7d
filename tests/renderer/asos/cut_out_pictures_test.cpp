#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

// Whole pictures of a floor under a large masked card, whose outline is nowhere near the picture.
// Place: tests/renderer/asos/cut_out_pictures_test.cpp.

namespace asos::test::cut_out_pictures_test {
namespace {

Picture picture_of(const Light& light, Method method, int max_level, int spp) {
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
  RenderSettings settings;
  settings.width = 48;
  settings.height = 32;
  settings.cull = false;
  settings.method = method;
  settings.asos.max_level = max_level;
  settings.sampling.spp = spp;
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

// Each level halves the cells' side: the error falls by 2^1.5.
void expect_error_falls(const Light& light, Method judge, int judge_spp) {
  const Picture truth = picture_of(light, judge, 3, judge_spp);
  double before = 0.0;
  for (int max_level = 1; max_level <= 4; ++max_level) {
    const double error = rms(picture_of(light, Method::asos, max_level, 1), truth);
    if (max_level == 3) {
      EXPECT_LT(error, 0.5 * before) << light.name;
    }
    if (max_level == 1) before = error;
  }
}

TEST(CutOutPictures, UnderHardLightsGetExacterWithEveryLevel) {
  for (Light light : {point_light(), spot_light(), distant_light()}) {
    light.position.y = 4;
    light.range = 1e9;
    if (light.type != Light::Type::directional) light.intensity = 20;
    expect_error_falls(light, Method::uniform, 1024);
  }
}

TEST(CutOutPictures, UnderSmallAreaLightsGetExacterWithEveryLevel) {
  for (Light light : {rectangle_light(), ball_light(0.02)}) {
    light.position.y = 4;
    light.half_u = {0.02, 0, 0};
    light.half_v = {0, 0, -0.02};
    light.intensity = light.type == Light::Type::point ? 20.0f : 12500.0f;
    expect_error_falls(light, Method::sobol, 1024);
  }
}

}  // namespace
}  // namespace asos::test::cut_out_pictures_test
