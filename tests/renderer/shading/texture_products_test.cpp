#include "renderer/shading/texture_products.h"

#include "renderer/shading/environment.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace asos::test::texture_products_test {
namespace {

std::uint8_t byte(bool full) {
  return full ? 255 : 0;
}

RenderFeatures with_textures() {
  return {.textures = true};
}

/// Four texels wide stripes, in 64 texels.
bool striped(int x) {
  return x / 4 % 2 == 0;
}

/// A surface that shows 32 x 32 texels of its textures.
class Surface {
 public:
  Material material = matte(glm::vec3(1.0f));

  int add(const Image& image) { return add_texture(world_, image, Wrap::repeat, Filter::nearest); }
  int colours() {
    return add(make_image(64, 64, [](int x, int) {
      const std::uint8_t c = byte(striped(x));
      return Texel{c, c, c, 255};
    }));
  }
  /// Roughness of the stripes and of the gaps in green, metallic of both in blue.
  int gloss(std::uint8_t stripes, std::uint8_t between, bool metal_between, bool metal_stripes) {
    return add(make_image(64, 64, [=](int x, int) {
      return striped(x) ? Texel{0, stripes, byte(metal_stripes), 255}
                        : Texel{0, between, byte(metal_between), 255};
    }));
  }
  [[nodiscard]] float error() { return errors().shading; }
  [[nodiscard]] MipChains mips() const { return {world_, find_render_features(world_)}; }
  [[nodiscard]] ProductError errors(const ViewedFrom& from = {}) {
    add_quad(world_, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, material);
    const RenderFeatures render_features = find_render_features(world_);
    Hit hit{.triangle = 0};
    hit.b1 = hit.b2 = 0.25f;
    Footprint footprint{.right = footprint_on(world_, hit, {{0.5f, 0, 0}, {0, 0.5f, 0}}).right,
                        .down = footprint_on(world_, hit, {{0.5f, 0, 0}, {0, 0.5f, 0}}).down};
    return product_error(world_, render_features, hit, footprint, from);
  }

 private:
  World world_;
};

// White dielectric stripes and black metal, all of it rough: half of the surface is white, the
// other half 0.04 of the remaining sky. The means would be a grey half metal.
TEST(TextureProducts, ErrorForMetalBetweenColouredStripes) {
  Surface s;
  s.material.metallic = s.material.roughness = 1.0f;
  s.material.base_color_texture.texture = s.colours();
  s.material.metallic_roughness_texture.texture = s.gloss(255, 255, true, false);
  const float seen = 0.5f * (1.0f + 0.04f * sky_visibility);
  const float of_means = 0.25f + (0.02f + 0.25f) * sky_visibility;
  EXPECT_NEAR(s.error(), 0.5f * (seen - of_means), 1e-3f);
}

// Metal too rough for a mirror shows a fraction of the sky. The mean roughness is that of a mirror
// in one case, and not in the other.
TEST(TextureProducts, ErrorForMirrorsBetweenRoughStripes) {
  const float mirror = 26.0f / 255.0f;
  for (const int rough_byte : {120, 255}) {
    Surface s;
    s.material.metallic = s.material.roughness = 1.0f;
    s.material.metallic_roughness_texture.texture =
        s.gloss(static_cast<std::uint8_t>(rough_byte), 26, true, true);
    const float rough = static_cast<float>(rough_byte) / 255.0f;
    const float mean = 0.5f * (rough + mirror);
    const float seen = 0.5f * (1.0f + mirrored_visibility(rough));
    const float of_mean = rough_byte == 120 ? 1.0f : mirrored_visibility(mean);
    EXPECT_NEAR(s.error(), 0.5f * std::abs(seen - of_mean), 1e-3f) << rough_byte;
  }
}

// Half of the metal is a perfect mirror, which is traced; the mean is a lobe, whose directions are
// sampled. Half of the reflection would be lost.
TEST(TextureProducts, ErrorForMirrorsBetweenLobes) {
  Surface s;
  s.material.metallic = s.material.roughness = 1.0f;
  s.material.metallic_roughness_texture.texture = s.gloss(20, 0, true, true);
  ViewedFrom from;
  EXPECT_EQ(s.errors(from).reflections, 0.0f) << "none is followed";
  const MipChains mips = s.mips();
  from.reflections = &mips;
  EXPECT_NEAR(s.errors(from).reflections, 0.5f * 0.5f, 1e-3f);
}

// White below a coat, black between: the coat takes its light from white only.
TEST(TextureProducts, ErrorForACoatOnColouredStripes) {
  Surface s;
  s.material.specular = 0.0f;
  s.material.base_color_texture.texture = s.colours();
  s.material.coat.factor = 1.0f;
  s.material.coat.texture.texture = s.colours();
  EXPECT_TRUE(multiplies_textures(s.material, with_textures()));
  const float seen = 0.5f * (0.04f + 0.96f), of_means = 0.02f + 0.98f * 0.5f;
  EXPECT_NEAR(s.error(), 0.5f * std::abs(seen - of_means), 1e-4f);
}

// Sheen or transmission between stripes of another colour: half of the surface is what the means
// take for a mixture.
TEST(TextureProducts, ErrorForOtherFactorsOfColouredStripes) {
  Surface transmits;
  transmits.material.specular = 0.0f;
  transmits.material.base_color_texture.texture = transmits.colours();
  transmits.material.diffuse_transmission.factor = 1.0f;
  transmits.material.diffuse_transmission.color = glm::vec3(0.0f);
  transmits.material.diffuse_transmission.texture.texture =
      transmits.add(make_image(64, 64, [](int x, int) {
        return Texel{255, 255, 255, byte(!striped(x))};
      }));
  EXPECT_TRUE(multiplies_textures(transmits.material, with_textures()));
  EXPECT_NEAR(transmits.error(), 0.5f * (0.5f - 0.25f), 1e-3f);

  Surface velvet;
  velvet.material.specular = 0.0f;
  velvet.material.base_color_texture.texture = velvet.colours();
  velvet.material.sheen.color = glm::vec3(1.0f);
  velvet.material.sheen.roughness = 0.5f;
  velvet.material.sheen.color_texture.texture = velvet.colours();
  EXPECT_TRUE(multiplies_textures(velvet.material, with_textures()));
  EXPECT_GT(velvet.error(), 0.003f);
}

// White glass between black paint: the means would transmit half of a grey light. Light from the
// front alone would hide that, since paint and glass together reflect as much as they transmit.
TEST(TextureProducts, ErrorForGlassBetweenColouredStripes) {
  Surface s;
  s.material.specular = 0.0f;
  s.material.base_color_texture.texture = s.colours();
  s.material.transmission = 1.0f;
  s.material.transmission_texture.texture = s.colours();
  EXPECT_NEAR(s.error(), 0.5f * (0.5f - 0.25f), 1e-3f);
}

// A lamp in the mirrored direction: smooth stripes show its highlight, rough ones nearly none of
// it. A dielectric is enough.
TEST(TextureProducts, ErrorForHighlightsOfRoughStripes) {
  Light lamp{.type = Light::Type::point};
  lamp.position = {0.5, 0.25, 4.0};  // above the hit
  lamp.intensity = 16.0f;
  const std::vector<PreparedLight> lights{prepare_light(lamp)};
  Surface s;
  s.material.roughness = 1.0f;
  s.material.metallic = 0.0f;
  s.material.metallic_roughness_texture.texture = s.gloss(51, 204, false, false);
  ViewedFrom from;
  EXPECT_EQ(s.errors(from).highlights, 0.0f);
  from.lights = lights;
  // The peak of D V F is 0.04 / (4 pi alpha^2): 1.989 and 0.008 for the stripes, and 0.051 for
  // their mean roughness of 0.5.
  EXPECT_NEAR(s.errors(from).highlights, 0.9986f - 0.0509f, 0.005f);
}

// For a single texture the mean is correct, as for two textures that are independent.
TEST(TextureProducts, NoErrorForASingleTexture) {
  Surface coloured;
  coloured.material.base_color_texture.texture = coloured.colours();
  EXPECT_FALSE(multiplies_textures(coloured.material, {}));
  coloured.material.metallic = 1.0f;
  coloured.material.metallic_roughness_texture.texture = coloured.gloss(128, 128, false, false);
  EXPECT_EQ(coloured.error(), 0.0f);

  Surface rough;
  rough.material.metallic = 0.0f;
  rough.material.roughness = 1.0f;
  rough.material.metallic_roughness_texture.texture = rough.gloss(255, 26, true, true);
  EXPECT_EQ(rough.error(), 0.0f) << "a dielectric reflects too little";
}

}  // namespace
}  // namespace asos::test::texture_products_test
