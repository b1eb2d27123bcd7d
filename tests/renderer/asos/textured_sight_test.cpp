#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/textured_scene.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

// Pixels whose colour is not the mean of a texture over their patch.

namespace asos::test::textured_sight_test {
namespace {

constexpr int side = 16;

struct Difference {
  double mean = 0.0, rms = 0.0;
};

/// Difference of ASOS's picture from one with 1024 samples.
Difference difference_from_samples(World world, const Camera& camera) {
  const auto scene = make_textured_scene(std::move(world));
  RenderSettings settings = make_settings(side, side);
  settings.sky = std::make_shared<const Sky>(glm::vec3(1.0f));
  const Film found = render_picture(*scene, camera, settings).film;
  settings.method = Method::sobol;
  settings.sampling.spp = 1024;
  const Film truth = render_picture(*scene, camera, settings).film;
  Difference difference;
  for (std::size_t i = 0; i < truth.radiance.size(); ++i) {
    const auto d = static_cast<double>(found.radiance[i].x - truth.radiance[i].x);
    difference.mean += d / (side * side);
    difference.rms += d * d / (side * side);
  }
  difference.rms = std::sqrt(difference.rms);
  return difference;
}

Texel grey(int value) {
  const auto byte = static_cast<std::uint8_t>(value);
  return {byte, byte, byte, 255};
}

// Expects a metal card with textures of its colour and roughness to be as sampled.
void expect_like_samples(const Image& colours, const Image& gloss, Filter filter) {
  World world;
  Material m = matte(glm::vec3(1.0f));
  m.metallic = m.roughness = 1.0f;
  m.base_color_texture.texture = add_texture(world, colours, Wrap::repeat, filter);
  m.metallic_roughness_texture.texture = add_texture(world, gloss, Wrap::repeat, filter);
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, m);
  const Difference d = difference_from_samples(std::move(world), orthographic(2.0));
  EXPECT_LT(std::abs(d.mean), 0.002);
  EXPECT_LT(d.rms, 0.004);
}

// A flat sheet of cells x cells squares; `vertex(at)` makes its corners.
template <typename Vertex>
std::size_t add_sheet(World& world, std::uint32_t cells, float step, const Material& material,
                      const Vertex& vertex) {
  std::vector<TinyVertex> corners;
  std::vector<glm::uvec3> triangles;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) {
      corners.push_back(vertex(step * glm::vec2(i, j) - 1.2f));
      const std::uint32_t k = j * (cells + 1) + i;
      if (i == cells || j == cells) continue;
      triangles.emplace_back(k, k + 1, k + cells + 2);
      triangles.emplace_back(k, k + cells + 2, k + cells + 1);
    }
  }
  return add_part(world, corners, triangles, material);
}

// Dark metal with bright and rougher paint on it, both finer than pixels. The pixel's value differs
// from that of a material with mean properties, by 0.058.
TEST(TexturedSight, AveragesProductsOfTextures) {
  const auto painted = [](int x, int y) { return (x / 3 + y / 5) % 2 == 0; };
  expect_like_samples(
      make_image(120, 120, [&](int x, int y) { return grey(painted(x, y) ? 255 : 80); }),
      make_image(120, 120,
                 [&](int x, int y) {
                   return painted(x, y) ? Texel{0, 255, 0, 255} : Texel{0, 160, 255, 255};
                 }),
      Filter::nearest);
}

// Mirrors with spots of slightly rough, darker metal. A mirror's reflection is traced, and that of
// a lobe is sampled. Pixels with both were up to 0.4 too dark, whatever MAX and EPS.
TEST(TexturedSight, ReflectsByMirrorsBetweenLobes) {
  const auto spot = [](int x, int y) { return x / 5 % 4 == 0 && y / 7 % 3 == 0; };
  expect_like_samples(
      make_image(120, 120, [&](int x, int y) { return grey(spot(x, y) ? 60 : 230); }),
      make_image(120, 120,
                 [&](int x, int y) {
                   return spot(x, y) ? Texel{0, 20, 40, 255} : Texel{0, 0, 190, 255};
                 }),
      Filter::linear);
}

// A lid seen nearly from the side, within two rows of pixels, half black and half white: its far
// half is foreshortened. The error was 0.008 without refinement.
TEST(TexturedSight, WeightsForeshortenedTextures) {
  World world;
  const Image halves = make_image(64, 64, [](int, int y) { return grey(y < 32 ? 255 : 0); });
  Material m = unlit(glm::vec3(1.0f));
  m.double_sided = true;
  m.base_color_texture.texture = add_texture(world, halves, Wrap::clamp_to_edge, Filter::nearest);
  add_quad(world, {-9, 0, 1}, {18, 0, 0}, {0, 0, -6}, m);
  const Camera camera = look_at({0.0, 0.3, 3.0}, {0.0, 0.3, 0.0}, 0.9);
  EXPECT_LT(difference_from_samples(std::move(world), camera).rms, 0.004);
}

// A flat sheet whose corners have random coordinates in a texture of broad stripes: a triangle's
// mapping must not be extrapolated beyond its edges. With extrapolation the error was 0.099; a few
// samples with their own footprints have 0.013.
TEST(TexturedSight, DoesNotExtrapolateOneTriangle) {
  World world;
  const Image stripes =
      make_image(256, 256, [](int x, int) { return grey(x / 32 % 2 == 0 ? 255 : 0); });
  Material m = unlit(glm::vec3(1.0f));
  m.base_color_texture.texture = add_texture(world, stripes, Wrap::repeat, Filter::linear);
  std::mt19937 random(11);
  std::uniform_real_distribution<float> place(0.0f, 1.0f);
  add_sheet(world, 6, 0.4f, m, [&](glm::vec2 at) {
    const float u = place(random);
    return TinyVertex{{at.x, at.y, 0}, {0, 0, 1}, {u, place(random)}};
  });
  EXPECT_LT(difference_from_samples(std::move(world), orthographic(2.0)).rms, 0.02);
}

// A flat sheet with black and white corners: edges between its triangles are no edges for ASOS, but
// the colour gradient changes there. With extrapolation of one triangle the error was 0.093.
TEST(TexturedSight, InterpolatesVertexColoursPerTriangle) {
  World world;
  std::mt19937 random(5);
  const std::size_t sheet = add_sheet(world, 20, 0.12f, unlit(glm::vec3(1.0f)), [&](glm::vec2 at) {
    world.colors.emplace_back(glm::vec3(random() % 2 == 0 ? 0.0f : 1.0f), 1.0f);
    return TinyVertex{{at.x, at.y, 0}, {0, 0, 1}, {0, 0}};
  });
  world.parts[sheet].coloured = true;
  EXPECT_LT(difference_from_samples(std::move(world), orthographic(2.0)).rms, 0.008);
}

// A card with a black rim a tenth of a pixel wide, made of a strip of triangles along its edge.
// With extrapolation of the card the error was 0.023.
TEST(TexturedSight, ShowsNarrowRims) {
  World world;
  const Image rim = make_image(2, 2, [](int, int y) { return grey(y == 0 ? 255 : 0); });
  Material m = unlit(glm::vec3(1.0f));
  m.base_color_texture.texture = add_texture(world, rim, Wrap::clamp_to_edge, Filter::nearest);
  constexpr float top = 0.1f, width = 0.0125f, slope = 0.3f;
  std::vector<TinyVertex> corners;
  for (const auto& [y, v] : {std::pair{-9.0f, 0.0f}, {top, 0.499f}, {top + width, 1.0f}})
    for (const float x : {-2.0f, 2.0f})
      corners.push_back({{x, y + slope * x, 0}, {0, 0, 1}, {0.5f, v}});
  add_part(world, corners, {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}}, m);
  EXPECT_LT(difference_from_samples(std::move(world), orthographic(2.0)).rms, 0.005);
}

}  // namespace
}  // namespace asos::test::textured_sight_test
