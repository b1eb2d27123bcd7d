#include "renderer/shading/material_layers.h"

#include <gtest/gtest.h>

#include <vector>

namespace asos::test::material_layers_test {
namespace {

std::vector<MaterialLayer> list(const MaterialLayers& layers) {
  return {layers.begin(), layers.end()};
}

TEST(MaterialLayers, AreThoseInUseFromTheTopDown) {
  using enum MaterialLayer;
  SurfaceMaterial material;
  EXPECT_EQ(list(MaterialLayers(material)), (std::vector{base}));
  material.diffuse_transmission = 0.5f;
  material.coat.factor = 1.0f;
  EXPECT_EQ(list(MaterialLayers(material)), (std::vector{coat, base, behind}));
  material.sheen.color = {0.0f, 0.1f, 0.0f};
  const MaterialLayers all(material);
  EXPECT_EQ(list(all), (std::vector{coat, sheen, base, behind}));
  EXPECT_EQ(all[all.base()], base);
}

// Each layer takes its reflection from the light for those below.
TEST(MaterialLayers, TransmittedLightPassesEveryLayer) {
  constexpr float cosine = 0.6f;
  SurfaceMaterial glass{.transmission = 1.0f, .roughness = 0.3f};
  const float bare = transmitted_share(glass, cosine);
  EXPECT_NEAR(bare, 1.0f - viewed(glass, cosine).specular.x, 1e-6f);
  SurfaceMaterial coated = glass;
  coated.coat = {0.5f, 0.2f};
  const float reflected = viewed(coated.coat, cosine).lobe.f0.x;
  EXPECT_GT(reflected, 0.01f);
  EXPECT_NEAR(transmitted_share(coated, cosine), (1.0f - reflected) * bare, 1e-6f);
  coated.sheen = {{0.2f, 0.9f, 0.4f}, 0.5f};
  const float fibres = viewed(coated.sheen, cosine).ambient.y;
  EXPECT_GT(fibres, 0.05f);
  EXPECT_NEAR(transmitted_share(coated, cosine), (1.0f - reflected) * (1.0f - fibres) * bare,
              1e-6f);
  coated.unlit = true;
  EXPECT_EQ(transmitted_share(coated, cosine), 1.0f);
}

}  // namespace
}  // namespace asos::test::material_layers_test
