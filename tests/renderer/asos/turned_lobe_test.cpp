#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/picture_difference.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

// KHR_materials_anisotropy with a texture that rotates the lobe per texel: a pixel shows the mean
// of the texels' highlights, not a highlight in their mean direction.

namespace asos::test::turned_lobe_test {
namespace {

TEST(TurnedLobe, AveragesTheTexelsHighlights) {
  constexpr int side = 40;
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> any(0.0, 6.283185307179586);
  World world;
  Material metal = matte(glm::vec3(0.9f));
  metal.metallic = 1.0f;
  metal.roughness = 0.25f;
  metal.anisotropy.strength = 0.9f;
  metal.anisotropy.texture.texture =
      add_texture(world,
                  make_image(96, 96,
                             [&](int, int) {
                               const double angle = any(rng);
                               const auto byte = [](double x) {
                                 return static_cast<std::uint8_t>(std::lround(127.5 + 127.0 * x));
                               };
                               return Texel{byte(std::cos(angle)), byte(std::sin(angle)), 255, 255};
                             }),
                  Wrap::repeat, Filter::linear);
  add_quad(world, glm::vec3(-2, 0, 2), glm::vec3(4, 0, 0), glm::vec3(0, 0, -4), metal);
  const Light light = make_panel({0, 3, -3}, {0, -0.7071067811865476, 0.7071067811865476},
                                 {1.5, 0, 0}, {0, 0.3, 0.3}, 4.0f);
  const auto scene = make_render_scene(std::move(world), {light});
  const Camera camera = look_at({0, 3, 3}, {0, 0, 0}, 0.6);
  RenderSettings settings = make_settings(side, side);
  const Picture found = render_picture(*scene, camera, settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 1024;
  settings.texture.filter = TextureFilter::point;
  const Picture truth = render_picture(*scene, camera, settings);
  const Difference off = difference(found, truth);
  EXPECT_GT(off.mean, 0.1);
  EXPECT_LT(off.rmse, 0.02 * off.mean);
}

}  // namespace
}  // namespace asos::test::turned_lobe_test
