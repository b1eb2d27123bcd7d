#include "renderer/shading/mip_chain.h"

#include "renderer/shading/texture.h"
#include "renderer/tasks.h"
#include "tests/renderer/shading/textured_triangle.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace asos {
namespace {

using test::make_image;
using test::Texel;

Texel noise(int x, int y) {
  const auto h = static_cast<std::uint32_t>(x * 7919 + y * 104729 + 17) * 2654435761u;
  return {static_cast<std::uint8_t>(h >> 24), static_cast<std::uint8_t>(h >> 16),
          static_cast<std::uint8_t>(h >> 8), static_cast<std::uint8_t>(h >> 20)};
}

// Rounding to 16 bits has an error of half a step per level.
float rounding(std::size_t levels) {
  return 0.5f / 65535.0f * static_cast<float>(levels) + 1e-6f;
}

TEST(MipChain, EveryLevelKeepsTheMeanWhateverTheSize) {
  for (const auto& [w, h] : {std::pair{16, 16}, {13, 7}, {1, 9}, {5, 1}, {31, 2}}) {
    const Image image = make_image(w, h, noise);
    const std::vector<MipLevel> chain = make_mip_levels(image, TexelKind::data);
    glm::dvec4 mean(0.0);
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
      mean[static_cast<int>(i % 4)] += image.rgba[i] / 255.0 / (w * h);
    ASSERT_FALSE(chain.empty());
    EXPECT_EQ(chain.back().width * chain.back().height, 1);
    std::size_t level_number = 0;
    for (const MipLevel& level : chain) {
      ++level_number;
      EXPECT_EQ(level.width, std::max(1, w >> level_number));
      EXPECT_EQ(level.height, std::max(1, h >> level_number));
      glm::dvec4 sum(0.0);
      for (int y = 0; y < level.height; ++y)
        for (int x = 0; x < level.width; ++x) sum += glm::dvec4(level.at(x, y));
      sum /= level.width * level.height;
      for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(sum[k], mean[k], rounding(level_number))
            << w << "x" << h << " " << level_number;
    }
  }
}

TEST(MipChain, OddSizesWeighTexelsByTheirShare) {
  // Five texels become two: boxes of 2.5 texels, which share the middle one.
  const std::array<std::uint8_t, 5> row{0, 50, 100, 200, 250};
  const Image image = make_image(5, 1, [&](int x, int) {
    const std::uint8_t b = row[static_cast<std::size_t>(x)];
    return Texel{b, b, b, 255};
  });
  const std::vector<MipLevel> chain = make_mip_levels(image, TexelKind::data);
  ASSERT_EQ(chain.size(), 2u);
  EXPECT_NEAR(chain[0].at(0, 0).r, (0 + 50 + 0.5f * 100) / 2.5f / 255.0f, rounding(1));
  EXPECT_NEAR(chain[0].at(1, 0).r, (0.5f * 100 + 200 + 250) / 2.5f / 255.0f, rounding(1));
}

TEST(MipChain, ColoursAreAveragedAsLight) {
  const Image image = make_image(4, 4, [](int x, int y) {
    const std::uint8_t b = (x + y) % 2 == 0 ? 255 : 0;
    return Texel{b, b, b, b};
  });
  const std::vector<MipLevel> chain = make_mip_levels(image, TexelKind::color);
  // Half the light, not 0.214, the value of the mean byte.
  EXPECT_NEAR(chain[0].at(1, 1).r, 0.5f, rounding(1));
  EXPECT_NEAR(chain[0].at(1, 1).a, 0.5f, rounding(1));
}

TEST(MipChain, ColoursOfCutOutsCountByTheirAlpha) {
  // Transparent texels are green, as in painted images, and must not contribute.
  const Image image = make_image(4, 4, [](int x, int) {
    return x % 2 == 0 ? Texel{255, 0, 0, 255} : Texel{0, 255, 0, 0};
  });
  const glm::vec4 texel = make_mip_levels(image, TexelKind::cover).back().at(0, 0);
  EXPECT_NEAR(texel.r, 1.0f, rounding(2));
  EXPECT_NEAR(texel.g, 0.0f, rounding(2));
  EXPECT_NEAR(texel.a, 0.5f, rounding(2));
}

TEST(MipChain, NormalsKeepTheirMeanAndTheRestIsVariance) {
  // Texels of unit normals tilted by 30 degrees to either side. Between them the tangent of the
  // angle varies linearly from -t to t, so the mean vertical component is asinh(t) / t, and the
  // variance is 1 minus its square. Tolerances: 1/255 for bytes, 1/20 texel for positions; borders
  // are clamped.
  const auto byte = [](float x) {
    return static_cast<std::uint8_t>(std::lround(127.5f * x + 127.5f));
  };
  const Image image = make_image(256, 4, [&](int x, int) {
    return Texel{byte(x % 2 == 0 ? 0.5f : -0.5f), byte(0.0f), byte(std::sqrt(0.75f)), 255};
  });
  const float t = std::tan(std::numbers::pi_v<float> / 6.0f);
  const float upright = std::asinh(t) / t;
  for (const MipLevel& level : make_mip_levels(image, TexelKind::normal)) {
    const glm::vec4 texel = level.at(level.width / 2, 0);
    EXPECT_NEAR(2.0f * texel.x - 1.0f, 0.0f, 0.008f);
    EXPECT_NEAR(2.0f * texel.z - 1.0f, upright, 0.004f);
    EXPECT_NEAR(texel.a, 1.0f - upright * upright, 0.008f);
  }
  const Image flat = make_image(8, 8, [&](int, int) { return Texel{128, 128, 255, 255}; });
  for (const MipLevel& level : make_mip_levels(flat, TexelKind::normal))
    EXPECT_EQ(level.at(0, 0).a, 0.0f);
}

TEST(MipChain, IsMadeForWhatIsUsedOnly) {
  World world;
  const int colour =
      test::add_texture(world, make_image(8, 8, noise), Wrap::repeat, Filter::linear);
  const int unused =
      test::add_texture(world, make_image(8, 8, noise), Wrap::repeat, Filter::linear);
  Material m = test::matte(glm::vec3(1));
  m.base_color_texture.texture = colour;
  test::add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, m);
  m.base_color_texture.texture = unused;
  world.materials.push_back(m);  // on no triangle
  const MipChains chains(world, find_render_features(world));
  EXPECT_EQ(chains.chain(colour, TexelKind::color)[2].width, 1);
  EXPECT_EQ(chains.chain(colour, TexelKind::color).size(), 3u);
  EXPECT_TRUE(chains.chain(colour, TexelKind::data).empty());
  EXPECT_TRUE(chains.chain(unused, TexelKind::color).empty());
  // 16 + 4 + 1 texels of 8 bytes.
  EXPECT_GE(chains.memory_bytes(), 168u);

  World plain;
  test::add_triangle(plain, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, test::matte(glm::vec3(1)));
  EXPECT_EQ(MipChains(plain, find_render_features(plain)).memory_bytes(), 0u);
}

TEST(MipChain, IsMadeOnceWhenATexelIsFirstRead) {
  const Image image = make_image(64, 32, noise);
  const std::vector<MipLevel> levels = make_mip_levels(image, TexelKind::color);
  for (int round = 0; round < 20; ++round) {
    const MipChain chain(image, TexelKind::color);
    EXPECT_EQ(chain.size(), 6u);
    EXPECT_FALSE(chain.empty());
    EXPECT_EQ(chain.memory_bytes(), std::size_t{0}) << "its size needs no level";
    // All threads read it at once, and get the same levels.
    std::vector<const MipLevel*> first(64);
    in_tasks(first.size(), [&](std::size_t i) { first[i] = &chain[i % chain.size()]; });
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_EQ(first[i], first[0] + i % chain.size());
      EXPECT_EQ(first[i]->rgba, levels[i % chain.size()].rgba);
    }
    EXPECT_GE(chain.memory_bytes(), 8u * (32 * 16 + 16 * 8 + 8 * 4 + 4 * 2 + 2 + 1));
  }
}

TEST(MipChain, OfATextureThatIsReadInPointsOrEnlargedIsNotMade) {
  const test::Textured textured(make_image(64, 64, noise));
  const MipChain& chain = textured.mips.chain(0, TexelKind::color);
  const auto look = [&](float texels) {
    const float width = texels / 64.0f;
    (void)textured.look(TexelKind::color, {0.3f, 0.4f}, {width, 0.0f}, {0.0f, width});
  };
  look(0.0f);
  look(0.7f);
  EXPECT_EQ(chain.memory_bytes(), 0u);
  look(20.0f);
  EXPECT_GT(chain.memory_bytes(), 0u);
  EXPECT_EQ(textured.mips.chain(0, TexelKind::normal).memory_bytes(), 0u);
}

}  // namespace
}  // namespace asos
