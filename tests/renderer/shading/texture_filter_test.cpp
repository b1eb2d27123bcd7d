#include "renderer/shading/texture_filter.h"

#include "renderer/shading/level_patch.h"
#include "renderer/shading/texture.h"
#include "tests/renderer/shading/textured_triangle.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <random>

namespace asos {
namespace {

using test::make_image;
using test::Texel;
using test::Textured;

Texel grey(double value) {
  const auto b = static_cast<std::uint8_t>(std::lround(255.0 * value));
  return {b, b, b, 255};
}

Image checkerboard(int size) {
  return make_image(size, size, [](int x, int y) { return grey((x + y) % 2); });
}

Image stripes(int size, int width) {
  return make_image(size, size, [=](int x, int) { return grey(x / width % 2); });
}

TEST(TextureFilter, ACheckerboardAveragesToItsLight) {
  for (const int size : {64, 60, 62}) {
    const Textured t(checkerboard(size));
    std::mt19937 rng(3);
    std::uniform_real_distribution<float> u(0.0f, 1.0f);
    for (int i = 0; i < 200; ++i) {
      // 8 to 40 texels wide, at any angle, and up to 4 times as long.
      const float angle = 6.28f * u(rng);
      const float width = (8.0f + 32.0f * u(rng)) / static_cast<float>(size);
      const glm::vec2 a = width * glm::vec2(std::cos(angle), std::sin(angle));
      const glm::vec2 b = (1.0f + 3.0f * u(rng)) * glm::vec2(-a.y, a.x);
      // Boxes of an even number of texels are exact. A box of 60 / 8 = 7.5 texels, as in the levels
      // of 60 and 62, has an error of at most half a texel of 7.5 along each axis.
      const float bound = size == 64 ? 1e-3f : 0.5f * 0.25f / 7.5f;
      EXPECT_NEAR(t.look(TexelKind::color, {u(rng), u(rng)}, a, b).r, 0.5f, bound) << size;
    }
  }
}

TEST(TextureFilter, ARampIsReproducedByAnyFootprintInsideIt) {
  // Bytes 0 to 255 along u: the texel centres of all levels are on the same line.
  const Textured t(make_image(256, 64, [](int x, int) { return grey(x / 255.0); }),
                   Wrap::clamp_to_edge);
  std::mt19937 rng(4);
  std::uniform_real_distribution<float> r(-1.0f, 1.0f);
  for (int i = 0; i < 500; ++i) {
    const glm::vec2 a = 0.06f * glm::vec2(r(rng), r(rng));
    const glm::vec2 b = 0.06f * glm::vec2(r(rng), r(rng));
    const float u = 0.5f + 0.25f * r(rng);
    // At an angle to the texel rows the weights have the right extent but not the shape: an error
    // of up to 1/16 texel.
    const float expected = (256.0f * u - 0.5f) / 255.0f;
    EXPECT_NEAR(t.look(TexelKind::data, {u, 0.5f}, a, b).g, expected, 0.0625f / 255.0f) << i;
    // Along the rows levels have an error of 2^-17, and sums that of rounding.
    EXPECT_NEAR(t.look(TexelKind::data, {u, 0.5f}, {a.x, 0.0f}, {0.0f, b.y}).g, expected, 5e-5f)
        << i;
  }
}

TEST(TextureFilter, StripesStaySharpAcrossAndAverageAlong) {
  // Stripes of 8 texels, and a footprint of half a texel by 8 texels.
  const Textured t(stripes(128, 8));
  const glm::vec2 thin(0.5f / 128.0f, 0.0f);
  const glm::vec2 tall(0.0f, 8.0f / 128.0f);
  for (int stripe = 0; stripe < 16; ++stripe) {
    const float u = (8.0f * static_cast<float>(stripe) + 4.0f) / 128.0f;
    EXPECT_NEAR(t.look(TexelKind::data, {u, 0.4f}, thin, tall).r, static_cast<float>(stripe % 2),
                1e-5f);
  }
  // Over two whole stripes the result is their mean.
  const glm::vec2 wide(16.0f / 128.0f, 0.0f);
  const glm::vec2 low(0.0f, 0.5f / 128.0f);
  for (float u = 0.2f; u < 0.8f; u += 0.013f)
    EXPECT_NEAR(t.look(TexelKind::data, {u, 0.4f}, wide, low).r, 0.5f, 1e-5f) << u;
}

TEST(TextureFilter, AFootprintIsTheMeanHoweverLongAndThin) {
  // Columns from black to white: point lookups mostly differ from their mean.
  const Textured t(make_image(16, 16, [](int x, int) { return grey(x / 15.0); }));
  for (const float turn : {0.0f, 0.3f}) {
    const glm::vec2 along(std::cos(turn), std::sin(turn));
    for (float length = 1e2f; length < 1e17f; length *= 3.0f) {
      for (float width = 1e-38f; width < length; width *= 1e3f) {
        const glm::vec2 right = length * along, across = width * glm::vec2(-along.y, along.x);
        for (const glm::vec2 down : {across, right + across, glm::vec2(0.0f), right}) {
          const glm::vec2 uv(0.02f, 0.3f);
          EXPECT_NEAR(t.look(TexelKind::data, uv, right, down).r, 0.5f, 0.02f)
              << length << " x " << width;
          EXPECT_NEAR(t.look(TexelKind::data, uv, down, right).r, 0.5f, 0.02f)
              << length << " x " << width;
        }
      }
    }
  }
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  const glm::vec2 wide(1.0f, 0.0f);
  const glm::vec2 unknown(0.0f, none);
  const glm::vec4 point = sample_texture(t.world, t.use, 0, 0.02f, 0.3f, Encoding::linear);
  EXPECT_EQ(t.look(TexelKind::data, {0.02f, 0.3f}, wide, unknown), point);
  EXPECT_EQ(t.look(TexelKind::data, {0.02f, 0.3f}, unknown, wide), point);
}

TEST(TextureFilter, AFootprintFarSmallerThanATexelIsTheLookupToTheBit) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<float> u(-2.0f, 3.0f);
  for (const Filter filter : {Filter::linear, Filter::nearest}) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge}) {
      const Textured t(
          make_image(13, 7, [](int x, int y) { return grey((x * 5 + y * 3) % 11 / 10.0); }), wrap,
          filter);
      for (int i = 0; i < 300; ++i) {
        const glm::vec2 uv(u(rng), u(rng));
        const float least = filter == Filter::linear ? least_footprint : 1e-4f;
        for (const float texels : {0.0f, 1e-20f, 0.9f * least}) {
          const glm::vec2 right(texels / 13.0f, 0.0f);
          const glm::vec2 down(0.0f, texels / 7.0f);
          const glm::vec4 filtered = t.look(TexelKind::color, uv, right, down);
          const glm::vec4 point = sample_texture(t.world, t.use, 0, uv.x, uv.y, Encoding::srgb);
          EXPECT_EQ(std::memcmp(&filtered, &point, sizeof point), 0) << uv.x << " " << uv.y;
          const MeanNormal n =
              filtered_normal(t.world, t.mips, t.use, {0, uv.x, uv.y, {right, down}});
          EXPECT_EQ(n.texel,
                    glm::vec3(sample_texture(t.world, t.use, 0, uv.x, uv.y, Encoding::linear)));
          EXPECT_EQ(n.variance, 0.0f);
        }
      }
    }
  }
}

/// Mean of lookups at n x n points of a patch.
double mean_of_lookups(const Textured& t, glm::vec2 middle, glm::vec2 a, glm::vec2 b, int n) {
  double sum = 0.0;
  for (int k = 0; k < n * n; ++k) {
    const glm::vec2 share = (glm::vec2(k % n, k / n) + 0.5f) / static_cast<float>(n) - 0.5f;
    const glm::vec2 at = middle + share.x * a + share.y * b;
    sum += static_cast<double>(sample_texture(t.world, t.use.texture, at, Encoding::linear).g);
  }
  return sum / (n * n);
}

TEST(TextureFilter, TheMeanIsThatOfManyLookups) {
  // Random texels, the hardest case for a filter.
  std::mt19937 rng(6);
  const Textured t(make_image(
      128, 128, [&](int, int) { return grey(static_cast<double>(rng() % 256) / 255.0); }));
  std::uniform_real_distribution<float> r(0.0f, 1.0f);
  const auto rms = [&](float texels, float turn) {
    double squares = 0.0;
    constexpr int places = 60;
    for (int i = 0; i < places; ++i) {
      const float angle = turn * r(rng);
      const glm::vec2 a = texels / 128.0f * glm::vec2(std::cos(angle), std::sin(angle));
      const glm::vec2 b = 1.5f * glm::vec2(-a.y, a.x);
      const glm::vec2 middle(r(rng), r(rng));
      const double off = static_cast<double>(t.look(TexelKind::data, middle, a, b).g) -
                         mean_of_lookups(t, middle, a, b, 96);
      squares += off * off;
    }
    return std::sqrt(squares / places);
  };
  // Within the finest level and along its rows the result is exact, except for the reference's own
  // error.
  for (const float texels : {0.3f, 1.0f, 3.3f, 8.0f}) EXPECT_LT(rms(texels, 0.0f), 5e-4) << texels;
  // In a rotated footprint, texels count as rotated squares. In coarser levels a texel at the
  // border counts as a whole. Single texels have a standard deviation of 0.29.
  for (const float texels : {0.3f, 1.0f, 3.3f, 8.0f, 20.0f, 60.0f})
    EXPECT_LT(rms(texels, 6.28f), 0.012) << texels;
}

// Models with a few texels per face use nearest filtering: the visible features are the texels'
// edges.
TEST(TextureFilter, NearestTexelsCountByTheirAreas) {
  std::mt19937 rng(7);
  const Textured t(make_image(64, 64, [&](int, int) { return grey(rng() % 2 ? 1.0 : 0.0); }),
                   Wrap::repeat, Filter::nearest);
  std::uniform_real_distribution<float> r(0.0f, 1.0f);
  for (const float texels : {0.01f, 0.1f, 0.5f, 1.0f, 2.2f, 5.0f}) {
    double squares = 0.0;
    constexpr int places = 60;
    for (int i = 0; i < places; ++i) {
      const auto edge = [&](float length) {
        const float angle = 6.28f * r(rng);
        return length / 64.0f * glm::vec2(std::cos(angle), std::sin(angle));
      };
      const glm::vec2 a = edge(texels);
      const glm::vec2 b = 1.5f * glm::vec2(-a.y, a.x) + edge(0.2f * texels);
      const glm::vec2 middle(r(rng), r(rng));
      const double off = static_cast<double>(t.look(TexelKind::data, middle, a, b).g) -
                         mean_of_lookups(t, middle, a, b, 128);
      squares += off * off / places;
    }
    EXPECT_LT(std::sqrt(squares), 1e-3) << texels;
  }
}

// Patches smaller than a texel along an oblique edge, which they cross obliquely: the steps between
// texels are visible. In pictures this occurs where triangles end at such an edge, with about one
// texel per pixel.
TEST(TextureFilter, SmallPatchesSeeTexelsWhereTheyLie) {
  constexpr int size = 64;
  const Textured t(
      make_image(size, size, [](int x, int y) { return grey(2 * x + 3 * y > 160 ? 1.0 : 0.0); }));
  std::mt19937 rng(11);
  std::uniform_real_distribution<float> u(0.0f, 1.0f);
  double squares = 0.0;
  constexpr int patches = 400;
  for (int i = 0; i < patches; ++i) {
    const float texels = 0.3f + 0.3f * u(rng);
    const glm::vec2 a = texels / size * glm::normalize(glm::vec2(1.0f + u(rng), 1.0f));
    const glm::vec2 b(-a.y, a.x);
    const float x = 20.0f + 20.0f * u(rng);
    const glm::vec2 at = glm::vec2(x, (160.0f - 2.0f * x) / 3.0f + 1.0f * u(rng)) / float(size);
    double mean = 0.0;
    constexpr int n = 16;
    for (int k = 0; k < n * n; ++k) {
      const glm::vec2 share = (glm::vec2(k % n, k / n) + 0.5f) / float(n) - 0.5f;
      const glm::vec2 place = at + share.x * a + share.y * b;
      mean += static_cast<double>(t.look(TexelKind::color, place, {}, {}).r) / (n * n);
    }
    const double off = static_cast<double>(t.look(TexelKind::color, at, a, b).r) - mean;
    squares += off * off / patches;
  }
  EXPECT_LT(std::sqrt(squares), 0.015);
}

TEST(TextureFilter, MeansCrossBordersAsTheSamplerWraps) {
  // Left half black, right half white; a footprint of a quarter around the border at u = 0.
  const Image halves = make_image(64, 64, [](int x, int) { return grey(x >= 32); });
  const glm::vec2 a(0.25f, 0.0f);
  const glm::vec2 b(0.0f, 0.25f);
  const auto at_border = [&](Wrap wrap) {
    return Textured(halves, wrap).look(TexelKind::data, {0.0f, 0.5f}, a, b).r;
  };
  EXPECT_NEAR(at_border(Wrap::repeat), 0.5f, 1e-4f);
  EXPECT_NEAR(at_border(Wrap::mirrored_repeat), 0.0f, 1e-4f);
  EXPECT_NEAR(at_border(Wrap::clamp_to_edge), 0.0f, 1e-4f);
}

// Invalid or huge footprints give values from 0 to 1.
TEST(TextureFilter, AnyFootprintIsSafe) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Textured t(checkerboard(16));
  for (const float bad : {nan, infinity, -infinity, 3e38f, 1e18f, 1e9f}) {
    for (const float u : {0.3f, nan, infinity, 3e38f}) {
      for (const glm::vec2 b : {glm::vec2(0.0f), glm::vec2(0, 1), glm::vec2(bad, 1)}) {
        const float r = t.look(TexelKind::color, {u, 0.2f}, {bad, 0.0f}, b).r;
        EXPECT_TRUE(r >= 0.0f && r <= 1.0f) << bad << " " << u << " " << r;
        const MeanNormal n =
            filtered_normal(t.world, t.mips, t.use, {0, u, 0.2f, {{bad, 0.0f}, b}});
        EXPECT_TRUE(n.variance >= 0.0f && n.variance <= 1.0f) << bad << " " << u;
      }
    }
  }
}

}  // namespace
}  // namespace asos
