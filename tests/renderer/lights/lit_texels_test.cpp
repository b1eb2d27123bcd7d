#include "renderer/lights/lit_texels.h"

#include "tests/renderer/lights/emitter_worlds.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

namespace asos {
namespace {

constexpr int width = 50, height = 30;

/// Two bright rectangles on an almost black image.
test::Texel lamps(int x, int y) {
  const bool lit = (x >= 20 && x < 23 && y >= 10 && y < 18) || (x >= 45 && y == 29);
  return lit ? test::Texel{0, 13, 0, 255} : test::Texel{12, 3, 12, 255};
}

/// Returns the texel that a coordinate reads.
int texel_at(float u, int size, Wrap wrap, int step) {
  int i = static_cast<int>(std::floor(u * static_cast<float>(size) - 0.5f)) + step;
  if (wrap == Wrap::clamp_to_edge) return std::clamp(i, 0, size - 1);
  const int period = wrap == Wrap::repeat ? size : 2 * size;
  i = (i % period + period) % period;
  return i < size ? i : period - 1 - i;
}

TEST(LitTexels, MissNoneThatALookUpReads) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-2.5f, 2.5f), size(0.0f, 0.4f), within(0.0f, 1.0f);
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
    World world;
    const int texture =
        test::add_texture(world, test::make_image(width, height, lamps), wrap, Filter::linear);
    const LitTexels lit(world, texture);
    int black = 0, bright = 0;
    for (int i = 0; i < 2000; ++i) {
      const glm::vec2 low(place(random), place(random));
      const glm::vec2 high = low + glm::vec2(size(random), size(random));
      const bool any = lit.any(low, high);
      black += any ? 0 : 1;
      for (int k = 0; k < 200; ++k) {
        const glm::vec2 at = low + glm::vec2(within(random), within(random)) * (high - low);
        const int x = texel_at(at.x, width, wrap, k % 2);
        const int y = texel_at(at.y, height, wrap, k / 2 % 2);
        if (lamps(x, y)[1] < 13) continue;
        ++bright;
        ASSERT_TRUE(any) << at.x << " " << at.y;
      }
    }
    EXPECT_GT(black, 400) << "of 2000 rectangles";
    EXPECT_GT(bright, 1000) << "the test reads bright texels";
  }
}

TEST(LitTexels, CountAsLitWhereTheImageIsUnknown) {
  World world;
  EXPECT_TRUE(LitTexels(world, -1).any({0, 0}, {1, 1}));
  const int texture = test::add_texture(world,
                                        test::make_image(8, 8,
                                                         [](int, int) {
                                                           return test::Texel{0, 0, 0, 255};
                                                         }),
                                        Wrap::repeat, Filter::linear);
  const LitTexels black(world, texture);
  EXPECT_FALSE(black.any({0, 0}, {1, 1}));
  EXPECT_FALSE(black.any({-3, 0.5f}, {7, 0.5f}));
  EXPECT_TRUE(black.any({1e5f, 0}, {1e5f, 1})) << "coordinates that are not exact to a texel";
  constexpr float infinite = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(black.any({0, 0}, {infinite, 1}));
}

int looks = 0;  // of the emission below

glm::vec3 counted(const World& world, std::uint32_t triangle, float b1, float b2) {
  ++looks;
  return test::plain_emission(world, triangle, b1, b2);
}

TEST(EmissiveLights, AreNotSampledWhereTheirTextureIsBlack) {
  const auto lights_of = [](std::uint8_t left, std::uint8_t right) {
    World world;
    Material material = test::glow(glm::vec3(2.0f));
    material.emissive_texture.texture =
        test::add_texture(world,
                          test::make_image(128, 128,
                                           [&](int x, int) {
                                             const std::uint8_t b = x < 64 ? left : right;
                                             return test::Texel{b, b, b, 255};
                                           }),
                          Wrap::clamp_to_edge, Filter::linear);
    // One square of the left half of the image, and one of the right half.
    for (const float u : {0.05f, 0.55f}) {
      const glm::vec3 corner(10.0f * u, 0.0f, 0.0f);
      test::add_part(world,
                     {{corner, {0, 0, 1}, {u, 0.0f}},
                      {corner + glm::vec3(1, 0, 0), {0, 0, 1}, {u + 0.4f, 0.0f}},
                      {corner + glm::vec3(0, 1, 0), {0, 0, 1}, {u, 0.4f}}},
                     {{0, 1, 2}}, material);
    }
    looks = 0;
    return emissive_lights(world, counted).size();
  };
  EXPECT_EQ(lights_of(255, 255), 2u);
  const int all = looks;
  EXPECT_EQ(lights_of(12, 255), 1u);
  EXPECT_EQ(2 * looks, all);
  EXPECT_EQ(lights_of(12, 12), 0u);
  EXPECT_EQ(looks, 0);
}

}  // namespace
}  // namespace asos
