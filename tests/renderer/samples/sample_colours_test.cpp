#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

// Colours of samples on textures finer than a sample's footprint.

namespace asos::test::sample_colours_test {
namespace {

constexpr int side = 24;

/// Thin white lines on black, 8 texels apart; a pixel covers 21 texels.
std::shared_ptr<const RenderScene> lines() {
  World world;
  Material m = unlit(glm::vec3(1));
  const Image image = make_image(128, 128, [](int x, int y) {
    const std::uint8_t c = x % 8 == 0 || y % 8 == 0 ? 255 : 0;
    return Texel{c, c, c, 255};
  });
  m.base_color_texture.texture = add_texture(world, image, Wrap::repeat, Filter::linear);
  add_quad(world, {-2, -2, 0}, {4, 0.3f, 0}, {-0.2f, 4, 0}, m);
  for (glm::vec2& uv : world.texcoords[0]) uv *= 8.0f;
  auto geometry = build_geometry(std::move(world), {}, {}, nullptr).value();
  Lighting lighting = prepare_lighting(geometry->world, {});
  return unedited_scene(std::move(geometry), std::move(lighting));
}

/// RMS difference between the pixels and their means of 4096 point samples.
double error_of(const RenderScene& scene, int spp) {
  RenderSettings settings = make_settings(side, side, Method::sobol, 4096);
  settings.texture.filter = TextureFilter::point;
  const Film truth = render_picture(scene, orthographic(2.0), settings).film;
  settings.sampling.spp = spp;
  settings.texture.filter = TextureFilter::footprint;
  const Film found = render_picture(scene, orthographic(2.0), settings).film;
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.radiance.size(); ++i) {
    const double off = static_cast<double>(found.radiance[i].x - truth.radiance[i].x);
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(truth.radiance.size()));
}

// With footprints of half the square the errors are 0.028 and 0.012, with three quarters 0.020 and
// 0.0083.
TEST(SampleColours, AverageOverMostOfTheFootprint) {
  const auto scene = lines();
  EXPECT_LT(error_of(*scene, 16), 0.024);
  EXPECT_LT(error_of(*scene, 64), 0.010);
}

}  // namespace
}  // namespace asos::test::sample_colours_test
