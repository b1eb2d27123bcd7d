#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/textured_scene.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Surfaces with two textures whose details are smaller than a pixel and lie in the same places. The
// pixel's value is the mean of what the textures show together, not what their means would show.

namespace asos::test::texture_pairs_test {
namespace {

constexpr int side = 8;

struct Images {
  int values;   ///< all channels are high in spots, and low in between
  int inverse;  ///< the other way round
  int normals;  ///< leaning to the right in spots, and to the left in between
};

struct Property {
  const char* name;
  std::function<void(Material& m, const Images& images)> texture;
};

const std::vector<Property>& properties() {
  static const std::vector<Property> all{
      {"BaseColour", [](Material& m, const Images& i) { m.base_color_texture.texture = i.values; }},
      {"Alpha",
       [](Material& m, const Images& i) {
         m.alpha_mode = AlphaMode::blend;
         m.base_color_texture.texture = i.values;
       }},
      {"Roughness",
       [](Material& m, const Images& i) {
         m.metallic_roughness_texture.texture = i.inverse;
         m.metallic = std::max(m.metallic, 0.0f);
       }},
      {"Metallic",
       [](Material& m, const Images& i) {
         m.metallic_roughness_texture.texture = i.values;
         m.metallic = 1.0f;
       }},
      {"Specular", [](Material& m, const Images& i) { m.specular_texture.texture = i.values; }},
      {"SpecularColour",
       [](Material& m, const Images& i) { m.specular_color_texture.texture = i.values; }},
      {"Coat",
       [](Material& m, const Images& i) {
         m.coat.factor = 1.0f;
         m.coat.texture.texture = i.values;
       }},
      {"CoatRoughness",
       [](Material& m, const Images& i) {
         m.coat.factor = m.coat.roughness = 1.0f;
         m.coat.roughness_texture.texture = i.inverse;
       }},
      {"SheenColour",
       [](Material& m, const Images& i) {
         m.sheen.color = glm::vec3(1.0f);
         m.sheen.roughness = 0.5f;
         m.sheen.color_texture.texture = i.values;
       }},
      {"SheenRoughness",
       [](Material& m, const Images& i) {
         m.sheen.color = glm::vec3(1.0f);
         m.sheen.roughness = 1.0f;
         m.sheen.roughness_texture.texture = i.inverse;
       }},
      {"Film",
       [](Material& m, const Images& i) {
         m.film.factor = 1.0f;
         m.film.texture.texture = i.values;
       }},
      {"FilmThickness",
       [](Material& m, const Images& i) {
         m.film.factor = 1.0f;
         m.film.thickness_texture.texture = i.values;
       }},
      {"Anisotropy",
       [](Material& m, const Images& i) {
         m.anisotropy.strength = 1.0f;
         m.anisotropy.texture.texture = i.values;
       }},
      {"Transmission",
       [](Material& m, const Images& i) {
         m.transmission = 1.0f;
         m.transmission_texture.texture = i.values;
       }},
      {"DiffuseTransmission",
       [](Material& m, const Images& i) {
         m.diffuse_transmission.factor = 1.0f;
         m.diffuse_transmission.texture.texture = i.values;
       }},
      {"Emission",
       [](Material& m, const Images& i) {
         m.emissive = glm::vec3(0.5f);
         m.emissive_texture.texture = i.values;
       }},
      {"Normal", [](Material& m, const Images& i) { m.normal_texture.texture = i.normals; }},
  };
  return all;
}

Images add_images(World& world) {
  const auto spot = [](int x, int y) { return x / 5 % 4 == 0 || y / 7 % 3 == 0; };
  const auto of = [&](Texel in_spots, Texel between) {
    return add_texture(
        world, make_image(120, 120, [&](int x, int y) { return spot(x, y) ? in_spots : between; }),
        Wrap::repeat, Filter::linear);
  };
  const Texel high{230, 230, 230, 230}, low{60, 60, 60, 60};
  return {of(high, low), of(low, high), of({178, 128, 245, 255}, {78, 128, 245, 255})};
}

/// Root mean square of the differences between ASOS's picture and one by 512 samples.
double error_of(const Property& first, const Property& second) {
  World world;
  const Images images = add_images(world);
  Material m = matte(glm::vec3(1.0f));
  m.roughness = 1.0f;
  m.specular = 1.0f;
  first.texture(m, images);
  second.texture(m, images);
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, m);
  add_quad(world, {-4, -4, -3}, {8, 0, 0}, {0, 8, 0}, matte(glm::vec3(0.5f)));
  const auto scene = make_textured_scene(std::move(world));
  RenderSettings settings = make_settings(side, side);
  const Film found = render_picture(*scene, orthographic(2.0), settings).film;
  settings.method = Method::sobol;
  settings.sampling.spp = 512;
  const Film truth = render_picture(*scene, orthographic(2.0), settings).film;
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.radiance.size(); ++i) {
    const glm::dvec3 d(found.radiance[i] - truth.radiance[i]);
    squares += glm::dot(d, d) / 3.0;
  }
  return std::sqrt(squares / (side * side));
}

class PairsOfTextures : public testing::TestWithParam<std::size_t> {};

TEST_P(PairsOfTextures, AreShadedTogether) {
  const Property& first = properties()[GetParam()];
  for (std::size_t i = GetParam(); i < properties().size(); ++i) {
    const Property& second = properties()[i];
    EXPECT_LT(error_of(first, second), 0.006) << first.name << " and " << second.name;
  }
}

INSTANTIATE_TEST_SUITE_P(With, PairsOfTextures, testing::Range(std::size_t{0}, properties().size()),
                         [](const auto& p) { return std::string(properties()[p.param].name); });

}  // namespace
}  // namespace asos::test::texture_pairs_test
