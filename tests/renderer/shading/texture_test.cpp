#include "renderer/shading/texture.h"

#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asos {
namespace {

/// A row of texels of these grey bytes.
World row_texture(const std::vector<std::uint8_t>& greys, Wrap wrap, Filter filter) {
  World world;
  Image image{.width = static_cast<int>(greys.size()), .height = 1};
  for (const std::uint8_t g : greys) image.rgba.own().insert(image.rgba.own().end(), {g, g, g, g});
  test::add_texture(world, image, wrap, filter);
  return world;
}

float lookup(const World& world, float u, Encoding encoding = Encoding::linear) {
  return sample_texture(world, 0, {u, 0.5f}, encoding).r;
}

TEST(Texture, DecodesTheSrgbCurve) {
  EXPECT_EQ(srgb_byte_to_linear(0), 0.0f);
  EXPECT_EQ(srgb_byte_to_linear(255), 1.0f);
  EXPECT_NEAR(srgb_byte_to_linear(10), 10.0 / 255.0 / 12.92, 1e-8);
  EXPECT_NEAR(srgb_byte_to_linear(128), std::pow((128.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-7);
}

TEST(Texture, MixesLinearLightNotBytes) {
  const World world = row_texture({0, 255}, Wrap::clamp_to_edge, Filter::linear);
  // Halfway between black and white is half the light, whose byte would be 188 and not 128.
  EXPECT_FLOAT_EQ(lookup(world, 0.5f, Encoding::srgb), 0.5f);
  EXPECT_FLOAT_EQ(lookup(world, 0.375f, Encoding::srgb), 0.25f);
  const World grey = row_texture({128, 128}, Wrap::clamp_to_edge, Filter::linear);
  EXPECT_FLOAT_EQ(lookup(grey, 0.4f, Encoding::srgb), srgb_byte_to_linear(128));
  // Alpha is linear in both encodings.
  EXPECT_FLOAT_EQ(sample_texture(grey, 0, {0.4f, 0.5f}, Encoding::srgb).a, 128.0f / 255.0f);
}

TEST(Texture, BilinearInBothDirections) {
  World world;
  Image image;
  image.width = image.height = 2;
  for (const int g : {0, 51, 102, 255}) {
    for (int k = 0; k < 4; ++k) image.rgba.own().push_back(static_cast<std::uint8_t>(g));
  }
  test::add_texture(world, image, Wrap::clamp_to_edge, Filter::linear);
  for (const float fx : {0.0f, 0.25f, 0.7f, 1.0f}) {
    for (const float fy : {0.0f, 0.4f, 1.0f}) {
      const float expected =
          (1 - fx) * (1 - fy) * 0.0f + fx * (1 - fy) * 0.2f + (1 - fx) * fy * 0.4f + fx * fy * 1.0f;
      const glm::vec2 uv(0.25f + 0.5f * fx, 0.25f + 0.5f * fy);
      EXPECT_NEAR(sample_texture(world, 0, uv, Encoding::linear).g, expected, 1e-6f)
          << fx << " " << fy;
    }
  }
}

TEST(Texture, WrapsAsItsSamplerSays) {
  const std::vector<std::uint8_t> bytes{0, 51, 102, 255};
  const World repeat = row_texture(bytes, Wrap::repeat, Filter::nearest);
  const World mirror = row_texture(bytes, Wrap::mirrored_repeat, Filter::nearest);
  const World clamp = row_texture(bytes, Wrap::clamp_to_edge, Filter::nearest);
  const auto texel = [&](int i) {
    return static_cast<float>(bytes[static_cast<std::size_t>(i)]) / 255.0f;
  };
  for (int i = -9; i < 13; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / 4.0f;
    const int period = ((i % 8) + 8) % 8;
    EXPECT_FLOAT_EQ(lookup(repeat, u), texel(period % 4)) << i;
    EXPECT_FLOAT_EQ(lookup(mirror, u), texel(period < 4 ? period : 7 - period)) << i;
    EXPECT_FLOAT_EQ(lookup(clamp, u), texel(i < 0 ? 0 : (i > 3 ? 3 : i))) << i;
  }
}

TEST(Texture, BilinearNeighboursWrapToo) {
  // At u = 0 a repeated texture is halfway between its last and its first texel.
  EXPECT_FLOAT_EQ(lookup(row_texture({0, 255}, Wrap::repeat, Filter::linear), 0.0f), 0.5f);
  EXPECT_FLOAT_EQ(lookup(row_texture({0, 255}, Wrap::repeat, Filter::linear), 1.0f), 0.5f);
  EXPECT_FLOAT_EQ(lookup(row_texture({0, 255}, Wrap::mirrored_repeat, Filter::linear), 0.0f), 0.0f);
  EXPECT_FLOAT_EQ(lookup(row_texture({0, 255}, Wrap::clamp_to_edge, Filter::linear), 1.0f), 1.0f);
}

TEST(Texture, AnyCoordinateIsSafe) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
    for (const Filter filter : {Filter::nearest, Filter::linear}) {
      const World world = row_texture({10, 20, 30}, wrap, filter);
      for (const float u : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 3e38f,
                            -3e38f, 1e10f, -1e-30f, 0x1.fffffep-1f, -0x1p-25f}) {
        const glm::vec4 c = sample_texture(world, 0, {u, u}, Encoding::linear);
        EXPECT_GE(c.r, 10.0f / 255.0f - 1e-6f) << u;
        EXPECT_LE(c.r, 30.0f / 255.0f + 1e-6f) << u;
      }
    }
  }
}

TEST(Texture, MissingOrEmptyImagesAreWhite) {
  World world;
  EXPECT_EQ(sample_texture(world, 0, {0, 0}, Encoding::srgb), glm::vec4(1));
  EXPECT_EQ(sample_texture(world, -1, {0, 0}, Encoding::srgb), glm::vec4(1));
  test::add_texture(world, Image{}, Wrap::repeat, Filter::linear);
  EXPECT_EQ(sample_texture(world, 0, {0, 0}, Encoding::srgb), glm::vec4(1));
}

TEST(Texture, UseAppliesItsTransform) {
  World world = row_texture({0, 51, 102, 255}, Wrap::repeat, Filter::nearest);
  test::add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, Material{});
  TextureUse use{.texture = 0};
  // Half the size, shifted by a quarter: u' = 0.5 u + 0.25.
  use.uv_transform = glm::mat3(0.5f, 0, 0, 0, 1, 0, 0.25f, 0, 1);
  EXPECT_FLOAT_EQ(sample_texture(world, use, 0, 0.1f, 0.0f, Encoding::linear).r, 0.2f);
  EXPECT_FLOAT_EQ(sample_texture(world, use, 0, 0.9f, 0.0f, Encoding::linear).r, 0.4f);
  use.texcoord = 1;  // a set of coordinates that the world lacks
  EXPECT_FLOAT_EQ(sample_texture(world, use, 0, 0.9f, 0.0f, Encoding::linear).r, 0.2f);
}

}  // namespace
}  // namespace asos
