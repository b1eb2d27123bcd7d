#include "renderer/shading/brdf.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/surface.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

// KHR_materials_specular and KHR_materials_ior in shading.

namespace asos {
namespace {

SurfaceMaterial shaded(const Material& material) {
  World world;
  test::add_quad(world, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, material);
  Hit hit{.t = 1.0f};
  hit.b1 = hit.b2 = 0.25f;
  hit.triangle = 0;
  return surface_material(world, find_render_features(world), hit);
}

Material glass(float ior, float specular, glm::vec3 color) {
  Material m = test::matte(glm::vec3(0.5f));
  m.ior = ior;
  m.specular = specular;
  m.specular_color = color;
  return m;
}

TEST(Specular, IsTheExtensionsFormula) {
  const SurfaceMaterial plain = shaded(glass(1.5f, 1.0f, glm::vec3(1)));
  EXPECT_FLOAT_EQ(plain.f0.g, 0.04f);
  EXPECT_EQ(plain.f90, 1.0f);
  const SurfaceMaterial tinted = shaded(glass(1.5f, 0.5f, {2, 1, 0.25f}));
  EXPECT_FLOAT_EQ(tinted.f0.r, 0.04f);
  EXPECT_FLOAT_EQ(tinted.f0.g, 0.02f);
  EXPECT_FLOAT_EQ(tinted.f0.b, 0.005f);
  EXPECT_EQ(tinted.f90, 0.5f);
  const SurfaceMaterial limited = shaded(glass(1.5f, 0.5f, glm::vec3(1000)));
  EXPECT_EQ(limited.f0, glm::vec3(0.5f)) << "the colour's part is at most 1";
}

// sRGB 188 is 0.5029 linear; alpha is linear.
TEST(Specular, TexturesScaleTheFactors) {
  World world;
  Material m = glass(1.5f, 0.5f, {2, 1, 1});
  m.transmission = 0.8f;
  m.specular_texture.texture = test::add_texture(world,
                                                 test::make_image(1, 1,
                                                                  [](int, int) {
                                                                    return test::Texel{0, 0, 0, 51};
                                                                  }),
                                                 Wrap::repeat, Filter::linear);
  m.specular_color_texture.texture =
      test::add_texture(world,
                        test::make_image(1, 1,
                                         [](int, int) {
                                           return test::Texel{188, 255, 0, 7};
                                         }),
                        Wrap::repeat, Filter::linear);
  m.transmission_texture.texture =
      test::add_texture(world,
                        test::make_image(1, 1,
                                         [](int, int) {
                                           return test::Texel{51, 0, 9, 7};
                                         }),
                        Wrap::repeat, Filter::linear);
  test::add_quad(world, {-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, m);
  Hit hit{.t = 1.0f};
  hit.b1 = hit.b2 = 0.25f;
  hit.triangle = 0;
  const SurfaceMaterial seen = surface_material(world, find_render_features(world), hit);
  EXPECT_NEAR(seen.f90, 0.1f, 1e-6f);
  EXPECT_NEAR(seen.f0.r, 0.04f * 2.0f * 0.5029f * 0.1f, 1e-6f);
  EXPECT_NEAR(seen.f0.g, 0.004f, 1e-6f);
  EXPECT_EQ(seen.f0.b, 0.0f);
  EXPECT_NEAR(seen.transmission, 0.16f, 1e-6f);
  // Shadow rays use the same transmission.
  EXPECT_NEAR(alpha_at(world, 0, 0.25f, 0.25f), 0.84f, 1e-6f);
  EXPECT_EQ(opacity_at(world, 0, 0.25f, 0.25f), 1.0f);
}

TEST(Specular, AnIndexOfZeroReflectsAll) {
  Material mirror = glass(0.0f, 1.0f, glm::vec3(1));
  mirror.roughness = 0.0f;
  const SurfaceMaterial all = shaded(mirror);
  EXPECT_EQ(all.f0, glm::vec3(1.0f));
  const ViewedMaterial seen = viewed(all, 0.7f);
  EXPECT_EQ(seen.specular, glm::vec3(1.0f));
  EXPECT_EQ(seen.diffuse, glm::vec3(0.0f));
}

TEST(Specular, MetalsAreNotConcerned) {
  Material metal = glass(1.5f, 0.0f, glm::vec3(0));
  metal.metallic = 1.0f;
  const SurfaceMaterial all = shaded(metal);
  EXPECT_EQ(all.f0, glm::vec3(0.5f));
  EXPECT_EQ(all.f90, 1.0f);
  metal.metallic = 0.25f;
  const SurfaceMaterial part = shaded(metal);
  EXPECT_FLOAT_EQ(part.f0.r, 0.125f);
  EXPECT_FLOAT_EQ(part.f90, 0.25f);
}

TEST(Specular, AFactorOfZeroLeavesLambert) {
  const SurfaceMaterial none = shaded(glass(1.5f, 0.0f, glm::vec3(1)));
  for (const float cosine : {0.05f, 0.5f, 1.0f}) {
    const ViewedMaterial seen = viewed(none, cosine);
    EXPECT_EQ(seen.specular, glm::vec3(0.0f));
    EXPECT_EQ(seen.diffuse, glm::vec3(0.5f));
    const BrdfAngles angles{0.3f, cosine, 0.9f, 0.2f};
    EXPECT_EQ(brdf(seen, angles), diffuse_brdf(seen, 0.0f)) << "no lobe, grazing or not";
  }
}

}  // namespace
}  // namespace asos
