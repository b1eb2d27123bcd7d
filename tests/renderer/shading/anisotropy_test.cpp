#include "renderer/shading/anisotropy.h"

#include "renderer/shading/light_quadrature.h"
#include "tests/renderer/shading/seen_floor.h"
#include "tests/support/make_light.h"
#include "tests/support/tiny_image.h"
#include "tests/support/white_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// KHR_materials_anisotropy in shading, against the extension's formulas.

namespace asos::test::anisotropy_test {
namespace {

constexpr double angles[] = {0.0, 0.5, 1.0, 1.3};

Reflector brushed(double metallic, double roughness, double strength, double turn) {
  Reflector r{{0.9, 0.6, 0.3}, metallic, roughness};
  r.anisotropy = strength;
  r.tangent = {std::cos(turn), 0.0, std::sin(turn)};
  return r;
}

std::vector<Reflector> reflectors() {
  return {brushed(1.0, 0.4, 0.3, 0.0), brushed(1.0, 0.45, 0.8, 0.6), brushed(0.0, 0.5, 0.6, 1.3),
          brushed(1.0, 0.6, 1.0, 2.5)};
}

/// The reflector as a white metal: its lobe alone.
Reflector white(Reflector r) {
  r.base = glm::dvec3(1.0);
  r.metallic = 1.0;
  return r;
}

TEST(Anisotropy, MatchesTheExtensionsFormula) {
  for (const Reflector& reflector : reflectors()) {
    SCOPED_TRACE(reflector.anisotropy);
    expect_formula_under_suns(reflector, angles);
  }
}

// White furnace: the sky's samples give the integral of the formula, at most 1.
TEST(Anisotropy, UnderASkyOfRadianceOneReturnsItsAlbedo) {
  for (const Reflector& reflector : reflectors()) {
    SCOPED_TRACE(reflector.anisotropy);
    expect_albedo_under_white_sky(reflector, angles, 1.0f);
  }
}

TEST(Anisotropy, InTheAmbientLightNeverReturnsMoreThanItGets) {
  const Sky white(glm::vec3(1.0f));
  for (const double roughness : {0.0, 0.2, 0.5, 1.0}) {
    for (const double strength : {0.2, 0.6, 1.0}) {
      for (const double metallic : {0.0, 1.0}) {
        Reflector r = brushed(metallic, roughness, strength, 0.3);
        r.base = glm::dvec3(1.0);
        const SeenFloor floor(material_of(r));
        for (double angle = 0.0; angle < 1.57; angle += 0.1) {
          const glm::vec3 found = floor.look(glm::vec3(seen_at(angle).to_viewer), white);
          EXPECT_LE(found.x, 1.0f + 1e-5f) << angle << ' ' << roughness << ' ' << strength;
          EXPECT_GE(found.x, 0.0f);
        }
      }
    }
  }
}

TEST(Anisotropy, NormsAreTheIntegralsOfTheLobe) {
  for (const double roughness : {0.35, 0.5, 0.8}) {
    for (const double strength : {0.25, 0.5, 0.8, 1.0}) {
      for (const double turn : {0.0, 0.4, 1.0, 1.5}) {
        for (const double angle : {0.0, 0.7, 1.2, 1.4}) {
          const Reflector r = brushed(1.0, roughness, strength, turn);
          const SeenPoint at = seen_at(angle);
          const double lobe = over_hemisphere(
              at, 150, [&](glm::dvec3 l) { return anisotropic_reference(r, at, l); });
          const double fresnel = over_hemisphere(at, 150, [&](glm::dvec3 l) {
            const double v_dot_h = glm::length(0.5 * (l + at.to_viewer));
            return std::pow(1.0 - v_dot_h, 5.0) * anisotropic_reference(r, at, l);
          });
          const double alpha = roughness * roughness;
          const LobeNorms found = stretched_lobe_norms(
              static_cast<float>(std::cos(angle)), static_cast<float>(roughness),
              static_cast<float>(glm::mix(alpha, 1.0, strength * strength)),
              static_cast<float>(std::cos(turn) * std::cos(turn)));
          EXPECT_NEAR(found.lobe, lobe, 1e-2)
              << roughness << ' ' << strength << ' ' << turn << ' ' << angle;
          EXPECT_NEAR(found.fresnel, fresnel, 5e-3);
        }
      }
    }
  }
  EXPECT_TRUE(std::isnan(stretched_lobe_norms(std::nanf(""), 0.5f, 0.5f, 0.5f).lobe));
}

TEST(Anisotropy, SumsOverLightsWithASizeAreTheirIntegrals) {
  const glm::dvec3 up(0, 1, 0);
  const Receiver receiver{glm::dvec3(0.0), up, up};
  for (const Reflector& r : reflectors()) {
    for (const double angle : angles) {
      const SeenPoint at = seen_at(angle);
      for (const glm::dvec3 middle : {glm::dvec3(-0.8, 1.0, 0.1), {0.3, 0.8, -0.6}, {-2, 1, 1}}) {
        const Light lamp = make_panel(middle, {0, -1, 0}, {0.3, 0, 0}, {0, 0, 0.2});
        const PreparedLight light = prepare_light(lamp);
        const PatchQuadrature truth(white(r), at, 4.0);
        const glm::dvec3 expected = truth(
            flat_patch(middle - lamp.half_u - lamp.half_v, 2.0 * lamp.half_u, 2.0 * lamp.half_v));
        const double alpha = r.roughness * r.roughness;
        const double along = glm::mix(alpha, 1.0, r.anisotropy * r.anisotropy);
        Lobe lobe = white_lobe(r.roughness);
        lobe.stretch.along = glm::vec3(std::sqrt(along * along - alpha * alpha) * r.tangent);
        LightQuadrature sum(receiver, at.to_viewer, lobe);
        EXPECT_NEAR(sum(light).lobe, expected.x, 5e-3 * expected.x + 1e-5)
            << angle << ' ' << middle.x << ' ' << r.anisotropy;
      }
    }
  }
}

/// Radiance of a floor with a lobe stretched along x or z, for a light reflected off to one side.
double seen_of(const Material& material, glm::vec3 to_viewer, glm::dvec3 to_light) {
  const Light sun = make_sun(-glm::normalize(to_light));
  const Sky dark(glm::vec3(0.0f));
  return static_cast<double>(SeenFloor(material, {sun}).look(glm::normalize(to_viewer), dark).x);
}

TEST(Anisotropy, IsTurnedByItsRotationAndItsTexture) {
  Material m = matte(glm::vec3(1.0f));
  m.metallic = 1.0f;
  m.roughness = 0.3f;
  m.anisotropy.strength = 0.8f;
  const glm::dvec3 beside_x(0.5, 1, 0), beside_z(0, 1, 0.5);
  const glm::vec3 up(0, 1, 0);
  EXPECT_GT(seen_of(m, up, beside_x), 5.0 * seen_of(m, up, beside_z)) << "along u";
  m.anisotropy.rotation_rad = 1.5707963f;
  EXPECT_GT(seen_of(m, up, beside_z), 5.0 * seen_of(m, up, beside_x)) << "against v";
  m.anisotropy.rotation_rad = 0.7853982f;
  EXPECT_GT(seen_of(m, up, {0.4, 1, 0.4}), 5.0 * seen_of(m, up, {0.4, 1, -0.4})) << "between";
  // Red and green encode 45 degrees, added to the rotation of 45 degrees, and blue half of the
  // strength.
  const SurfaceAnisotropy by_texel = anisotropy_of(m.anisotropy, {1.0f, 1.0f, 0.5f});
  EXPECT_NEAR(by_texel.direction.x, 0.0f, 1e-6f);
  EXPECT_NEAR(by_texel.direction.y, 1.0f, 1e-6f);
  EXPECT_EQ(by_texel.strength, 0.4f);
  EXPECT_EQ(anisotropy_of(m.anisotropy, {128.0f / 255.0f, 128.0f / 255.0f, 1.0f}).direction,
            anisotropy_of(m.anisotropy).direction)
      << "a texel without a direction";
}

TEST(Anisotropy, TexturesAreLookedUp) {
  World world;
  const int map = add_texture(world,
                              make_image(1, 1,
                                         [](int, int) {
                                           return Texel{128, 255, 51, 255};
                                         }),
                              Wrap::repeat, Filter::linear);
  Material m = matte(glm::vec3(0.5f));
  m.anisotropy.strength = 0.5f;
  m.anisotropy.texture.texture = map;
  add_quad(world, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, m);
  Hit hit;
  hit.t = 1.0f;
  hit.b1 = hit.b2 = 0.25f;
  hit.triangle = 0;
  const SurfaceMaterial seen = surface_material(world, find_render_features(world), hit);
  EXPECT_NEAR(seen.anisotropy.strength, 0.1f, 1e-6f);
  EXPECT_EQ(seen.anisotropy.direction, glm::vec2(0.0f, 1.0f));
  const LobeStretch front =
      lobe_stretch(world, hit, seen.anisotropy, 0.5f, {0, 1, 0}, glm::vec3(0, 1, 0));
  EXPECT_GT(std::abs(front.along.z), 0.0f);
  EXPECT_EQ(front.along.x, 0.0f);
}

TEST(Anisotropy, TurnsAsTheMeshesTangentsDo) {
  World world;
  Material m = matte(glm::vec3(0.5f));
  m.anisotropy.strength = 0.5f;
  add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, m);
  constexpr float angle = 0.1f;
  world.tangents = {{1, 0, 0, 1}, {std::cos(angle), 0, -std::sin(angle), 1}, {1, 0, 0, 1}};
  const Hit hit{.triangle = 0, .t = 1.0f};
  const Patch patch{{0.5f, 0, 0}, {0, 0, -0.25f}};
  const glm::vec2 turn = tangent_turn(world, hit, patch, {0, 1, 0});
  EXPECT_NEAR(turn.x, 0.5f * std::sin(angle), 1e-6f) << "half of the edge";
  EXPECT_NEAR(turn.y, 0.0f, 1e-6f);
  world.tangents.clear();
  EXPECT_EQ(tangent_turn(world, hit, patch, {0, 1, 0}), glm::vec2(0.0f));
}

// Without tangents and coordinates there is no direction, and lobes are isotropic.
TEST(Anisotropy, IsOffWithoutADirection) {
  World world;
  Material m = matte(glm::vec3(0.5f));
  m.anisotropy.strength = 0.5f;
  add_quad(world, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, m);
  for (glm::vec2& uv : world.texcoords[0]) uv = glm::vec2(0.5f);
  const Hit hit{.triangle = 0, .t = 1.0f};
  EXPECT_TRUE(lobe_stretch(world, hit, {0.5f}, 0.5f, {0, 1, 0}, {0, 1, 0}).none());
}

}  // namespace
}  // namespace asos::test::anisotropy_test
