#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/picture_difference.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

// Unevenly shaded leaves are sampled if that is cheaper than splitting.

namespace asos::test::sampled_leaves_test {
namespace {

constexpr int side = 24;

/// The penumbra of a post's edge under a sphere light, on a plane, seen from above.
auto penumbra() {
  World world;
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, matte(glm::vec3(0.6f)));
  add_quad(world, {-4.3f, -3, 0.6f}, {4.0f, 0.1f, 0}, {0, 6, 0}, matte(glm::vec3(0.3f)));
  const Light ball = make_bulb({-2.0, 0.4, 3.0}, 12.0f, 0.15);
  return make_render_scene(std::move(world), {ball});
}

Picture picture_of(const RenderScene& scene, int max_level, double eps, double height = 4.0) {
  RenderSettings settings = make_settings(side, side);
  settings.asos.max_level = max_level;
  settings.asos.eps = eps;
  return render_picture(scene, orthographic(height), settings);
}

TEST(SampledLeaves, PenumbraIsWithinEps) {
  const auto scene = penumbra();
  const Picture sampled = picture_of(*scene, 3, 1.0 / 256.0);
  const Picture exact = picture_of(*scene, 6, 0.0);
  EXPECT_EQ(sampled.statistics.pyrays_by_level[1], 0u) << "none is split for its penumbra";
  EXPECT_GT(exact.statistics.pyrays_by_level[1], 0u) << "a smaller EPS splits them";
  double squares = 0.0, off = 0.0;
  std::size_t uneven = 0;
  for (std::size_t i = 0; i < sampled.film.radiance.size(); ++i) {
    if (sampled.film.cause[i] != SplitCause::shadow) continue;
    ++uneven;
    EXPECT_EQ(sampled.film.split_level[i], 0) << "samples are no split";
    EXPECT_GE(sampled.film.samples[i], 4) << "they have a number of their own";
    const auto d = static_cast<double>(sampled.film.radiance[i].x - exact.film.radiance[i].x);
    squares += d * d;
    off += d;
  }
  ASSERT_GT(uneven, 20u);
  EXPECT_EQ(uneven, sampled.statistics.uneven_pixels);
  const auto count = static_cast<double>(uneven);
  EXPECT_LT(std::sqrt(squares / count), 0.5 / 256.0) << "half of the tolerance";
  EXPECT_LT(std::abs(off / count), 0.5 / 256.0 / std::sqrt(count) * 3.0) << "and without bias";
}

/// The triangles of a grid of cells x cells squares, with corners stored by row.
std::vector<glm::uvec3> grid_of(std::uint32_t cells) {
  std::vector<glm::uvec3> triangles;
  for (std::uint32_t y = 0; y < cells; ++y) {
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t a = y * (cells + 1) + x, b = a + cells + 1;
      triangles.emplace_back(a, a + 1, b);
      triangles.emplace_back(a + 1, b + 1, b);
    }
  }
  return triangles;
}

/// An unlit crumpled sheet across the view, with about two triangles per pixel. Each triangle has
/// its own scale of a texture of random squares.
auto rumpled() {
  constexpr int cells = 40;
  constexpr float width = 5.0f;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> off(-0.3f, 0.3f);
  World world;
  Material material = unlit(glm::vec3(1.0f));
  material.double_sided = true;
  material.base_color_texture.texture =
      add_texture(world,
                  make_image(32, 32,
                             [&](int, int) {
                               const auto grey = static_cast<std::uint8_t>(random() % 2 ? 255 : 0);
                               return Texel{grey, grey, grey, 255};
                             }),
                  Wrap::repeat, Filter::linear);
  std::vector<TinyVertex> vertices;
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) {
      const glm::vec2 at(x, y);
      const glm::vec2 uv = (at + glm::vec2(off(random), off(random))) / 16.0f;
      const glm::vec2 place = width * (at / float{cells} - 0.5f);
      vertices.push_back({{place.x, place.y, 0.1f * off(random)}, {0, 0, 1}, uv});
    }
  }
  const std::vector<glm::uvec3> triangles = grid_of(cells);
  add_part(world, vertices, triangles, material);
  return make_render_scene(std::move(world));
}

// The texture mapping of one triangle says nothing about its neighbours'.
TEST(SampledLeaves, TexturesOnSmallTrianglesAreWithinEps) {
  const auto scene = rumpled();
  const Picture sampled = picture_of(*scene, 3, 1.0 / 256.0);
  const RenderSettings settings = make_settings(side, side, Method::sobol, 1024);
  const Picture truth = render_picture(*scene, orthographic(4.0), settings);
  double squares = 0.0, spread = 0.0;
  for (std::size_t i = 0; i < truth.film.radiance.size(); ++i) {
    const auto d = static_cast<double>(sampled.film.radiance[i].x - truth.film.radiance[i].x);
    const auto contrast = static_cast<double>(truth.film.radiance[i].x) - 0.5;
    squares += d * d / (side * side);
    spread += contrast * contrast / (side * side);
  }
  EXPECT_GT(std::sqrt(spread), 0.1) << "there is something to see";
  EXPECT_LT(std::sqrt(squares), 1.0 / 256.0);
}

/// A rough metal sheet lit by a panel, with about ninety triangles per pixel.
auto rough_metal() {
  constexpr int cells = 160;
  constexpr float width = 4.0f, step = width / cells;
  std::mt19937 random(5);
  std::uniform_real_distribution<float> off(-0.25f * step, 0.25f * step);
  std::vector<TinyVertex> vertices;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x)
      vertices.push_back(
          {{static_cast<float>(x) * step - 2.0f, static_cast<float>(y) * step - 2.0f, off(random)},
           glm::vec3(0.0f),
           {}});
  const std::vector<glm::uvec3> triangles = grid_of(cells);
  for (const glm::uvec3& t : triangles) {
    const glm::vec3 a = vertices[t.x].position;
    const glm::vec3 n = glm::cross(vertices[t.y].position - a, vertices[t.z].position - a);
    for (int k = 0; k < 3; ++k) vertices[t[k]].normal += n;
  }
  for (TinyVertex& v : vertices) v.normal = glm::normalize(v.normal);
  World world;
  Material metal = matte(glm::vec3(0.8f));
  metal.metallic = 1.0f;
  metal.roughness = 0.4f;
  add_part(world, vertices, triangles, metal);
  const Light panel = make_panel({0.5, 0.3, 4.0}, {0, 0, -1}, {1.0, 0, 0}, {0, 0.6, 0}, 2.0f);
  return make_render_scene(std::move(world), {panel});
}

// The curvature of one triangle says nothing about the ninety in the pixel.
TEST(SampledLeaves, ShowTheHighlightsOfAFineMesh) {
  const auto scene = rough_metal();
  const RenderSettings settings = make_settings(side, side, Method::sobol, 1024);
  const Picture truth = render_picture(*scene, orthographic(3.5), settings);
  const Picture found = picture_of(*scene, 3, 1.0 / 256.0, 3.5);
  const Difference off = difference(found, truth);
  EXPECT_GT(off.mean, 0.1);
  EXPECT_LT(off.rmse, 0.003);
  const auto count = static_cast<double>(found.film.radiance.size());
  const double samples = static_cast<double>(found.statistics.eye_rays) / count;
  EXPECT_LT(samples, 256.0) << "the number of samples per pixel is limited";
}

}  // namespace
}  // namespace asos::test::sampled_leaves_test
