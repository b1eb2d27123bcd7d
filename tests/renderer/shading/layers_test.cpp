#include "renderer/shading/brdf.h"
#include "renderer/shading/sheen.h"
#include "tests/renderer/shading/seen_floor.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// KHR_materials_clearcoat and KHR_materials_sheen in shading, against the extensions' formulas.

namespace asos::test::layers_test {
namespace {

constexpr double angles[] = {0.0, 0.5, 1.0, 1.3, 1.45};

Reflector coated(double metallic, double factor, double roughness) {
  return {{0.9, 0.6, 0.3}, metallic, 0.6, factor, roughness};
}
Reflector sheeny(glm::dvec3 color, double roughness) {
  return {{0.3, 0.5, 0.1}, 0.0, 0.7, 0.0, 0.0, color, roughness};
}
std::vector<Reflector> reflectors() {
  Reflector both = sheeny({0.7, 0.2, 0.9}, 0.5);
  both.coat = 0.8;
  both.coat_roughness = 0.3;
  return {coated(0.0, 1.0, 0.3),        coated(1.0, 0.5, 0.45), sheeny({1, 0.5, 0.25}, 0.3),
          sheeny({0.2, 0.9, 0.4}, 0.7), sheeny({1, 1, 1}, 1.0), both};
}

TEST(Layers, OfALightAreTheExtensionsFormulas) {
  for (const Reflector& reflector : reflectors()) {
    SCOPED_TRACE(reflector.coat);
    expect_formula_under_suns(reflector, angles);
  }
}

// The base alone may reflect more than it receives at grazing angles (brdf.h): layers are compared
// with the same integral.
TEST(Layers, UnderASkyOfRadianceOneReturnTheirAlbedo) {
  for (const Reflector& reflector : reflectors()) {
    SCOPED_TRACE(reflector.coat);
    expect_albedo_under_white_sky(reflector, angles);
  }
}

// In ambient light no layer adds light, for any base and view direction.
TEST(Layers, NeverReturnMoreThanTheyGet) {
  const Sky white(glm::vec3(1.0f));
  for (const double roughness : {0.0, 0.1, 0.2, 0.5, 1.0}) {
    for (const double metallic : {0.0, 1.0}) {
      Reflector r{{1, 1, 1}, metallic, roughness, 1.0, roughness, {1, 1, 1}, roughness};
      for (const double coat : {0.0, 0.5, 1.0}) {
        r.coat = coat;
        const SeenFloor floor(material_of(r));
        for (double angle = 0.0; angle < 1.57; angle += 0.05) {
          const glm::vec3 found = floor.look(angle, white);
          EXPECT_LE(std::max({found.x, found.y, found.z}), 1.0f + 1e-5f) << angle;
          EXPECT_GE(std::min({found.x, found.y, found.z}), 0.0f);
        }
      }
    }
  }
}

TEST(Layers, HideWhatShinesBelowThem) {
  const Sky dark(glm::vec3(0.0f));
  Material m = matte(glm::vec3(0.0f));
  m.emissive = {3.0f, 2.0f, 1.0f};
  m.coat.factor = 0.5f;
  for (const double angle : angles) {
    const double fresnel = 0.04 + 0.96 * std::pow(1.0 - std::cos(angle), 5.0);
    const glm::vec3 found = SeenFloor(m).look(angle, dark);
    EXPECT_NEAR(found.r, 3.0 * (1.0 - 0.5 * fresnel), 1e-5);
    EXPECT_NEAR(found.b, 1.0 - 0.5 * fresnel, 1e-5);
  }
}

// The coat has its own normals; without a map these are the surface's.
TEST(Layers, CoatsHaveTheirOwnNormals) {
  const auto tilted = [](World& world) {
    return add_texture(world,
                       make_image(1, 1,
                                  [](int, int) {
                                    return Texel{204, 128, 230, 255};
                                  }),
                       Wrap::repeat, Filter::linear);
  };
  const auto normals = [&](bool of_base, bool of_coat) {
    World world;
    const int map = tilted(world);
    Material m = matte(glm::vec3(0.5f));
    m.coat.factor = 1.0f;
    if (of_base) m.normal_texture.texture = map;
    if (of_coat) m.coat.normal_texture.texture = map;
    add_quad(world, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, m);
    Hit hit{.t = 1.0f};
    hit.b1 = hit.b2 = 0.25f;
    hit.triangle = 0;
    const RenderFeatures render_features = find_render_features(world);
    const SurfacePoint point = surface_point(world, render_features, hit, {0, 1, 0});
    return std::pair(point.shading_normal,
                     coat_point(world, render_features, hit, nullptr, point).shading_normal);
  };
  const glm::vec3 up(0, 1, 0);
  const glm::vec3 right = glm::normalize(glm::vec3(0.6f, 0.8f, 0.0f));
  EXPECT_LT(glm::distance(normals(true, false).first, right), 0.01f);
  EXPECT_EQ(normals(true, false).second, up);
  EXPECT_EQ(normals(false, true).first, up);
  EXPECT_LT(glm::distance(normals(false, true).second, right), 0.01f);
  EXPECT_EQ(normals(true, true).first, normals(true, true).second);
}

TEST(Layers, TexturesScaleTheirFactors) {
  World world;
  const int map = add_texture(world,
                              make_image(1, 1,
                                         [](int, int) {
                                           return Texel{51, 102, 188, 204};
                                         }),
                              Wrap::repeat, Filter::linear);
  Material m = matte(glm::vec3(0.5f));
  m.coat.factor = 0.5f;
  m.coat.roughness = 0.5f;
  m.coat.texture.texture = m.coat.roughness_texture.texture = map;
  m.sheen.color = {0.5f, 1.0f, 1.0f};
  m.sheen.roughness = 0.5f;
  m.sheen.color_texture.texture = m.sheen.roughness_texture.texture = map;
  add_quad(world, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, m);
  Hit hit{.t = 1.0f};
  hit.b1 = hit.b2 = 0.25f;
  hit.triangle = 0;
  const SurfaceMaterial seen = surface_material(world, find_render_features(world), hit);
  EXPECT_NEAR(seen.coat.factor, 0.1f, 1e-6f) << "red";
  EXPECT_NEAR(seen.coat.roughness, 0.2f, 1e-6f) << "green";
  EXPECT_NEAR(seen.sheen.color.r, 0.5 * 0.0331, 1e-4) << "sRGB";
  EXPECT_NEAR(seen.sheen.color.b, 0.5029, 1e-4);
  EXPECT_NEAR(seen.sheen.roughness, 0.4f, 1e-6f) << "alpha";
}

TEST(Sheen, AlbedoIsTheIntegralOfItsLobe) {
  for (const double roughness : {0.1, 0.13, 0.2, 0.33, 0.5, 0.71, 1.0}) {
    for (const double n_dot_v : {0.02, 0.05, 0.11, 0.3, 0.52, 0.8, 0.99}) {
      const SeenPoint at = seen_at(std::acos(n_dot_v));
      const double expected =
          over_hemisphere(at, 60, [&](glm::dvec3 l) { return sheen_reference(roughness, at, l); });
      const float found = sheen_albedo(static_cast<float>(n_dot_v), static_cast<float>(roughness));
      EXPECT_NEAR(found, expected, 1e-2) << roughness << ' ' << n_dot_v;
    }
  }
  EXPECT_TRUE(std::isnan(sheen_albedo(std::nanf(""), 0.5f)));
  EXPECT_TRUE(std::isnan(sheen_albedo(0.5f, std::nanf(""))));
  EXPECT_EQ(sheen_albedo(2.0f, 0.5f), sheen_albedo(1.0f, 0.5f));
}

}  // namespace
}  // namespace asos::test::layers_test
