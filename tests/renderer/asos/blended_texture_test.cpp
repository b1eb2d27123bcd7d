#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/textured_scene.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace asos::test::blended_texture_test {
namespace {

constexpr int side = 24;

/// White labels of 13 texels on transparent black; the first `faint` columns have alpha 0.4.
Image labels(int faint) {
  return make_image(128, 128, [faint](int x, int y) {
    const bool label = x % 32 < 13 && y % 32 < 13;
    const std::uint8_t c = label ? 255 : 0;
    return Texel{c, c, c, static_cast<std::uint8_t>(label ? (x % 32 < faint ? 102 : 255) : 0)};
  });
}

/// A sheet of labels in front of a grey wall; a pixel is 11 texels wide.
std::shared_ptr<const RenderScene> sheet(AlphaMode mode, float cutoff) {
  World world;
  add_quad(world, {-2, -2, -1}, {4, 0, 0}, {0, 4, 0}, unlit(glm::vec3(0.5f)));
  Material m = unlit(glm::vec3(1));
  m.alpha_mode = mode;
  m.alpha_cutoff = cutoff;
  m.double_sided = true;
  m.base_color_texture.texture = add_texture(world, labels(3), Wrap::repeat, Filter::linear);
  add_quad(world, {-2, -2, 0}, {4, 0.3f, 0}, {-0.2f, 4, 0}, m);
  for (glm::vec2& uv : world.texcoords[0]) uv *= 4.1f;
  return make_textured_scene(std::move(world));
}

double rmse(const Film& a, const Film& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    const glm::vec3 d = a.radiance[i] - b.radiance[i];
    sum += static_cast<double>(glm::dot(d, d)) / 3.0;
  }
  return std::sqrt(sum / static_cast<double>(a.radiance.size()));
}

double error_of_asos(AlphaMode mode, float cutoff) {
  const auto scene = sheet(mode, cutoff);
  RenderSettings settings = make_settings(side, side);
  const Film asos = render_picture(*scene, orthographic(2.0), settings).film;
  settings.method = Method::sobol;
  settings.sampling.spp = 1024;
  const Film truth = render_picture(*scene, orthographic(2.0), settings).film;
  return rmse(asos, truth);
}

// Transparent black texels do not darken the labels. The error was 0.09 when colours and alpha were
// averaged separately.
TEST(BlendedTexture, BlendedLabelsAreAsBrightAsSampled) {
  EXPECT_LT(error_of_asos(AlphaMode::blend, 0.5f), 0.001);
}

TEST(BlendedTexture, MaskedLabelsAreAsBrightAsSampled) {
  for (const float cutoff : {0.2f, 0.5f})
    EXPECT_LT(error_of_asos(AlphaMode::mask, cutoff), 0.001) << cutoff;
}

/// Black labels in front of a white wall, on one sheet per entry of `moved`, each shifted by that
/// amount.
Film labels_before_wall(const std::vector<glm::vec2>& moved, Method method) {
  World world;
  add_quad(world, {-2, -2, -1}, {4, 0, 0}, {0, 4, 0}, unlit(glm::vec3(1.0f)));
  Material m = unlit(glm::vec3(0));
  m.alpha_mode = AlphaMode::blend;
  m.double_sided = true;
  m.base_color_texture.texture = add_texture(world, labels(0), Wrap::repeat, Filter::nearest);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const float z = 0.1f * static_cast<float>(i);
    add_quad(world, {-2, -2, z}, {4, 0, 0}, {0, 4, 0}, m);
    const std::size_t first = world.texcoords[0].size() - 4;
    for (std::size_t k = first; k < first + 4; ++k)
      world.texcoords[0][k] = 4.0f * world.texcoords[0][k] + moved[i];
  }
  const auto scene = make_textured_scene(std::move(world));
  const RenderSettings settings = make_settings(side, side, method, 1024);
  return render_picture(*scene, orthographic(2.0), settings).film;
}

/// Labels with emission 0.5. `own`: the emissive texture is the label's own; otherwise an equal
/// copy.
double mean_of_shining_labels(bool own, Method method) {
  World world;
  Material m = matte(glm::vec3(0));
  m.alpha_mode = AlphaMode::blend;
  m.emissive = glm::vec3(0.5f);
  m.base_color_texture.texture = add_texture(world, labels(0), Wrap::repeat, Filter::nearest);
  m.emissive_texture = m.base_color_texture;
  if (!own)
    m.emissive_texture.texture = add_texture(world, labels(0), Wrap::repeat, Filter::nearest);
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, m);
  for (glm::vec2& uv : world.texcoords[0]) uv *= 4.0f;
  const auto scene = make_textured_scene(std::move(world));
  RenderSettings settings = make_settings(side, side, method);
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  const Film film = render_picture(*scene, orthographic(2.0), settings).film;
  double sum = 0.0;
  for (const glm::vec3 pixel : film.radiance) sum += static_cast<double>(pixel.x);
  return sum / static_cast<double>(film.radiance.size());
}

// The emission of labels is proportional to their coverage, not to its square.
TEST(BlendedTexture, EmissionIsWeightedByCoverageOnce) {
  constexpr double labelled = 13.0 * 13.0 / (32.0 * 32.0);
  for (const Method method : {Method::asos, Method::sobol})
    EXPECT_NEAR(mean_of_shining_labels(true, method), 0.5 * labelled, 0.001)
        << static_cast<int>(method);
  // With a copy, samples are needed: each takes two texture averages.
  EXPECT_NEAR(mean_of_shining_labels(false, Method::asos), 0.5 * labelled, 0.005);
}

// The transmission of two sheets is not the product of their averages. Coincident labels hide as
// much as one of them, and adjacent labels hide as much as both.
TEST(BlendedTexture, CoincidentLayersHideOnce) {
  const Film once = labels_before_wall({{0, 0}}, Method::asos);
  const Film twice = labels_before_wall({{0, 0}, {0, 0}}, Method::asos);
  EXPECT_LT(rmse(once, twice), 0.003);
  // There is no edge; the cause in the map shows that visibility was sampled.
  const auto by_samples = [](const Film& film) {
    return std::count(film.cause.begin(), film.cause.end(), SplitCause::cut_out);
  };
  EXPECT_EQ(by_samples(once), 0);
  EXPECT_GT(by_samples(twice), side * side / 8);
}

TEST(BlendedTexture, DisjointLayersAddUp) {
  const std::vector<glm::vec2> beside{{0, 0}, {13.0f / 128.0f, 0}};
  const Film asos = labels_before_wall(beside, Method::asos);
  EXPECT_LT(rmse(asos, labels_before_wall(beside, Method::sobol)), 0.003);
  double mean = 0.0;
  for (const glm::vec3 pixel : asos.radiance)
    mean += static_cast<double>(pixel.x) / static_cast<double>(asos.radiance.size());
  EXPECT_NEAR(mean, 1.0 - 2.0 * 13.0 * 13.0 / (32.0 * 32.0), 0.001);
}

}  // namespace
}  // namespace asos::test::blended_texture_test
