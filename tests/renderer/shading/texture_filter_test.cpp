#include "renderer/shading/texture_filter.h"

#include "renderer/shading/texture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

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

/// One triangle whose (b1, b2) are its (u, v), and one texture on it.
struct Textured {
  World world;
  MipChains mips;
  TextureUse use;

  explicit Textured(Image image, Wrap wrap = Wrap::repeat, Filter filter = Filter::linear,
                    AlphaMode alpha = AlphaMode::opaque) {
    Material m = test::matte(glm::vec3(1));
    m.alpha_mode = alpha;
    use.texture = test::add_texture(world, std::move(image), wrap, filter);
    m.base_color_texture = m.metallic_roughness_texture = m.normal_texture = use;
    test::add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, m);
    mips = MipChains(world, find_needs(world));
  }

  [[nodiscard]] glm::vec4 look(TexelKind kind, glm::vec2 uv, glm::vec2 right,
                               glm::vec2 down) const {
    return filtered_texture(world, mips, use, {kind}, {0, uv.x, uv.y, {right, down}});
  }
};

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
      // 8 to 40 texels wide, at any angle, up to 4 times longer.
      const float angle = 6.28f * u(rng);
      const float width = (8.0f + 32.0f * u(rng)) / static_cast<float>(size);
      const glm::vec2 a = width * glm::vec2(std::cos(angle), std::sin(angle));
      const glm::vec2 b = (1.0f + 3.0f * u(rng)) * glm::vec2(-a.y, a.x);
      // Boxes of an even number of texels are exact; a box of 60 / 8 = 7.5 texels, which levels of
      // 60 and 62 have, is off by at most half a texel of 7.5 along each of two axes.
      const float bound = size == 64 ? 1e-3f : 0.5f * 0.25f / 7.5f;
      EXPECT_NEAR(t.look(TexelKind::color, {u(rng), u(rng)}, a, b).r, 0.5f, bound) << size;
    }
  }
}

TEST(TextureFilter, ARampIsReproducedByAnyFootprintInsideIt) {
  // Bytes 0 to 255 along u: level L's texel centres lie on the same line.
  const Textured t(make_image(256, 64, [](int x, int) { return grey(x / 255.0); }),
                   Wrap::clamp_to_edge);
  std::mt19937 rng(4);
  std::uniform_real_distribution<float> r(-1.0f, 1.0f);
  for (int i = 0; i < 500; ++i) {
    const glm::vec2 a = 0.06f * glm::vec2(r(rng), r(rng));
    const glm::vec2 b = 0.06f * glm::vec2(r(rng), r(rng));
    const float u = 0.5f + 0.25f * r(rng);
    // At an angle to the texels' rows, weights are those of texels whose extent is right but not
    // their shape: up to a sixteenth of a texel off.
    const float expected = (256.0f * u - 0.5f) / 255.0f;
    EXPECT_NEAR(t.look(TexelKind::data, {u, 0.5f}, a, b).g, expected, 0.0625f / 255.0f) << i;
    // Along the rows levels err by 2^-17, and sums by rounding.
    EXPECT_NEAR(t.look(TexelKind::data, {u, 0.5f}, {a.x, 0.0f}, {0.0f, b.y}).g, expected, 5e-5f)
        << i;
  }
}

TEST(TextureFilter, StripesStaySharpAcrossAndAverageAlong) {
  // Stripes of 8 texels. A footprint 16 times longer than its half texel.
  const Textured t(stripes(128, 8));
  const glm::vec2 thin(0.5f / 128.0f, 0.0f);
  const glm::vec2 tall(0.0f, 8.0f / 128.0f);
  for (int stripe = 0; stripe < 16; ++stripe) {
    const float u = (8.0f * static_cast<float>(stripe) + 4.0f) / 128.0f;
    EXPECT_NEAR(t.look(TexelKind::data, {u, 0.4f}, thin, tall).r, static_cast<float>(stripe % 2),
                1e-5f);
  }
  // Across two whole stripes it is their mean.
  const glm::vec2 wide(16.0f / 128.0f, 0.0f);
  const glm::vec2 low(0.0f, 0.5f / 128.0f);
  for (float u = 0.2f; u < 0.8f; u += 0.013f)
    EXPECT_NEAR(t.look(TexelKind::data, {u, 0.4f}, wide, low).r, 0.5f, 1e-5f) << u;
}

TEST(TextureFilter, AFootprintIsTheMeanHoweverLongAndThin) {
  // Columns from black to white: a lookup is far from their mean at most places.
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

/// Of n x n places all over a patch, one by one.
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
  // Texels of no order, at which any fault of a filter shows most.
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
  // Within the finest level and along its rows: exact but for the lookups' own sum.
  for (const float texels : {0.3f, 1.0f, 3.3f, 8.0f}) EXPECT_LT(rms(texels, 0.0f), 5e-4) << texels;
  // Turned, texels stand for squares that are turned with it. Of coarser levels those at the rim
  // count by what the whole texel shows. Their own spread is 0.29.
  for (const float texels : {0.3f, 1.0f, 3.3f, 8.0f, 20.0f, 60.0f})
    EXPECT_LT(rms(texels, 6.28f), 0.012) << texels;
}

// Models of a few texels a face have them: all that is seen of them are their own edges.
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

// Patches of less than a texel that lie aslant along an edge which is aslant itself: the texels'
// own steps show in them, as they do where triangles end at such an edge in a picture that shows
// about a texel in each pixel.
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

// Columns of red that covers, green that covers by 0.4, and blue that does not, a whole period of
// them.
/// What is seen of n x n places all over a patch, and their mean alpha.
glm::dvec4 mean_of_seen(const Textured& t, std::optional<float> cutoff, glm::vec2 middle,
                        glm::vec2 a, glm::vec2 b, int n) {
  glm::dvec3 sum(0.0);
  double seen = 0.0, alpha = 0.0;
  for (int k = 0; k < n * n; ++k) {
    const glm::vec2 share = (glm::vec2(k % n, k / n) + 0.5f) / static_cast<float>(n) - 0.5f;
    const glm::dvec4 texel(
        sample_texture(t.world, t.use.texture, middle + share.x * a + share.y * b, Encoding::srgb));
    const double one = cutoff ? (texel.a >= static_cast<double>(*cutoff) ? 1.0 : 0.0) : texel.a;
    sum += one * glm::dvec3(texel);
    seen += one;
    alpha += texel.a;
  }
  return {sum / seen, alpha / (n * n)};
}

TEST(TextureFilter, ColoursThatAlphaBlendsOrCutsCountByWhatIsSeenOfThem) {
  const Image columns = make_image(64, 64, [](int x, int) {
    constexpr Texel red{255, 0, 0, 255}, green{0, 255, 0, 102}, blue{0, 0, 255, 0};
    return x / 8 % 4 == 1 ? green : x / 8 % 4 == 2 ? blue : red;
  });
  const auto look = [&](const Textured& t, TexelKind kind, std::optional<float> cutoff,
                        float height) {
    return filtered_texture(t.world, t.mips, t.use, {kind, cutoff},
                            {0, 0.31f, 0.4f, {{0.5f, 0.0f}, {0.0f, height}}});
  };
  // What is so long is the mean of texels, and so are coarser levels: along outlines these do not
  // know what lies between texels. Where it is less, see the next test.
  constexpr float allowed = 0.03f;
  const auto expect = [&](glm::vec4 got, glm::vec4 truth, const char* what) {
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(got[k], truth[k], allowed) << what << " " << k;
  };
  const auto seen = [](const Textured& t, std::optional<float> cutoff, float height) {
    return glm::vec4(mean_of_seen(t, cutoff, {0.31f, 0.4f}, {0.5f, 0.0f}, {0.0f, height}, 512));
  };
  const Textured blend(columns, Wrap::repeat, Filter::linear, AlphaMode::blend);
  const Textured mask(columns, Wrap::repeat, Filter::linear, AlphaMode::mask);
  const Textured opaque(columns);
  // In a coarser level, and in the texels themselves.
  for (const float height : {0.5f, 0.06f}) {
    expect(look(blend, TexelKind::cover, {}, height), seen(blend, {}, height), "blend");
    expect(look(mask, TexelKind::cover, 0.3f, height), seen(mask, 0.3f, height), "mask");
    expect(look(mask, TexelKind::cover, 0.5f, height), seen(mask, 0.5f, height), "half");
    expect(look(mask, TexelKind::cover, 2.0f, height), {0.5f, 0.25f, 0.25f, 0.6f}, "none");
    expect(look(opaque, TexelKind::color, {}, height), {0.5f, 0.25f, 0.25f, 0.6f}, "opaque");
  }
}

// White labels on black that does not cover: along their outlines the one's colour goes with the
// other's alpha, as it does where a point is looked up.
TEST(TextureFilter, WhatIsSeenIsWhatLookupsAllOverThePatchSee) {
  const Image labels = make_image(128, 128, [](int x, int y) {
    const bool label = x % 32 < 13 && y % 32 < 13;
    const std::uint8_t c = label ? 255 : 0;
    return Texel{c, c, c, static_cast<std::uint8_t>(label ? (x % 32 < 3 ? 102 : 255) : 0)};
  });
  const Textured t(labels, Wrap::repeat, Filter::linear, AlphaMode::blend);
  for (const float texels : {0.4f, 1.0f, 3.0f, 6.0f, 11.0f, 15.0f, 40.0f}) {
    double squares = 0.0;
    int count = 0;
    for (const glm::vec2 along : {glm::vec2(1.0f, 0.0f), glm::vec2(0.96f, 0.28f)}) {
      for (int i = 0; i < 40; ++i) {
        const glm::vec2 uv(0.013f * static_cast<float>(i), 0.029f * static_cast<float>(i));
        const glm::vec2 a = texels / 128.0f * along, b(-a.y, a.x);
        const glm::vec4 got = filtered_texture(t.world, t.mips, t.use, {TexelKind::cover, {}},
                                               {0, uv.x, uv.y, {a, b}});
        const glm::dvec4 truth = mean_of_seen(t, {}, uv, a, b, 64);
        if (!(truth.a > 0.0)) continue;
        const double off = static_cast<double>(got.r * got.a) - truth.r * truth.a;
        squares += off * off;
        ++count;
      }
    }
    EXPECT_LT(std::sqrt(squares / count), 0.01) << texels;
  }
}

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

/// The mean of the unit normals at n x n places all over a patch.
glm::dvec3 mean_of_normals(const Textured& t, glm::vec2 middle, glm::vec2 a, glm::vec2 b, int n) {
  glm::dvec3 sum(0.0);
  for (int k = 0; k < n * n; ++k) {
    const glm::vec2 share = (glm::vec2(k % n, k / n) + 0.5f) / static_cast<float>(n) - 0.5f;
    const glm::vec2 at = middle + share.x * a + share.y * b;
    sum += glm::normalize(
        2.0 * glm::dvec3(sample_texture(t.world, t.use.texture, at, Encoding::linear)) - 1.0);
  }
  return sum / static_cast<double>(n * n);
}

TEST(TextureFilter, NormalsAreThoseOfLookupsAllOverThePatchAndWhatTheyLackIsVariance) {
  // Ridges tilted to either side by 30 degrees; bumps without order; and a dome over all of it.
  std::mt19937 rng(7);
  std::uniform_int_distribution<int> any(64, 191);
  const auto byte = [](float x) {
    return static_cast<std::uint8_t>(std::lround(127.5f * x + 127.5f));
  };
  const Image maps[] = {
      make_image(64, 64,
                 [](int x, int) {
                   return Texel{static_cast<std::uint8_t>(x % 2 == 0 ? 191 : 64), 128, 238, 255};
                 }),
      make_image(64, 64,
                 [&](int, int) {
                   return Texel{static_cast<std::uint8_t>(any(rng)),
                                static_cast<std::uint8_t>(any(rng)), 238, 255};
                 }),
      make_image(64, 64, [&](int x, int y) {
        const glm::vec2 p = (glm::vec2(x, y) - 31.5f) / 48.0f;
        return Texel{byte(p.x), byte(p.y), byte(std::sqrt(1.0f - glm::dot(p, p))), 255};
      })};
  for (const Image& map : maps) {
    const Textured t(map);
    // Up to a point's, within four texels, and as coarser levels have it.
    for (const float texels : {0.3f, 0.6f, 1.0f, 2.5f, 3.9f, 5.0f, 9.0f, 24.0f}) {
      const glm::vec2 a = texels / 64.0f * glm::vec2(0.8f, 0.6f);
      const glm::vec2 b = texels / 64.0f * glm::vec2(-0.6f, 0.8f);
      for (const glm::vec2 uv : {glm::vec2(0.4f, 0.3f), glm::vec2(0.51f, 0.47f)}) {
        const MeanNormal n = filtered_normal(t.world, t.mips, t.use, {0, uv.x, uv.y, {a, b}});
        const glm::dvec3 mean = mean_of_normals(t, uv, a, b, 96);
        const double tolerance = texels < 4.0f ? 0.03 : 0.06;
        EXPECT_NEAR(2.0 * static_cast<double>(n.texel.x) - 1.0, mean.x, tolerance) << texels;
        EXPECT_NEAR(2.0 * static_cast<double>(n.texel.y) - 1.0, mean.y, tolerance) << texels;
        EXPECT_NEAR(static_cast<double>(n.variance), 1.0 - glm::dot(mean, mean), 0.02) << texels;
      }
    }
  }
  const TexturePlace place{0, 0.4f, 0.3f, {{0.25f, 0.0f}, {0.0f, 0.25f}}};
  const Textured flat(make_image(64, 64, [](int, int) { return Texel{128, 128, 255, 255}; }));
  EXPECT_NEAR(filtered_normal(flat.world, flat.mips, flat.use, place).variance, 0.0f, 1e-6f);
}

}  // namespace
}  // namespace asos
