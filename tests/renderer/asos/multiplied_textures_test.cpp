#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

// Textures that are finer than pixels, of which one tells what another does.

namespace asos::test::multiplied_textures_test {
namespace {

constexpr int side = 16;

/// Of a sheet of dark metal with bright paint on it, which is rough: what is seen of both is
/// neither what a half metal shows nor what is half as rough.
Film painted_metal(Method method) {
  World world;
  const auto painted = [](int x, int y) { return (x / 3 + y / 5) % 2 == 0; };
  Material m = matte(glm::vec3(1.0f));
  m.metallic = m.roughness = 1.0f;
  m.base_color_texture.texture = add_texture(world,
                                             make_image(120, 120,
                                                        [&](int x, int y) {
                                                          const std::uint8_t c =
                                                              painted(x, y) ? 255 : 80;
                                                          return Texel{c, c, c, 255};
                                                        }),
                                             Wrap::repeat, Filter::nearest);
  m.metallic_roughness_texture.texture = add_texture(
      world,
      make_image(120, 120,
                 [&](int x, int y) {
                   return painted(x, y) ? Texel{0, 255, 0, 255} : Texel{0, 160, 255, 255};
                 }),
      Wrap::repeat, Filter::nearest);
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, m);
  auto geometry = build_geometry(std::move(world), {}, {}, nullptr).value();
  Lighting lighting = prepare_lighting(geometry->world, {});
  const auto scene = unedited_scene(std::move(geometry), std::move(lighting));
  RenderSettings settings;
  settings.width = settings.height = side;
  settings.method = method;
  settings.sampling.spp = 1024;
  settings.sky = std::make_shared<const Sky>(glm::vec3(1.0f));
  return render_picture(*scene, orthographic(2.0), settings).film;
}

TEST(MultipliedTextures, AreSeenAsSamplesFindThem) {
  const Film asos = painted_metal(Method::asos), truth = painted_metal(Method::sobol);
  double sum = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < truth.radiance.size(); ++i) {
    const auto d = static_cast<double>(asos.radiance[i].x - truth.radiance[i].x);
    sum += d * d;
    mean += d;
  }
  const auto pixels = static_cast<double>(truth.radiance.size());
  EXPECT_LT(std::abs(mean / pixels), 0.002);
  EXPECT_LT(std::sqrt(sum / pixels), 0.004);
}

}  // namespace
}  // namespace asos::test::multiplied_textures_test
