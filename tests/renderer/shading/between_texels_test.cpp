#include "renderer/shading/texture.h"
#include "renderer/shading/texture_filter.h"
#include "tests/renderer/shading/textured_triangle.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

// Filtered values that are not means of texels, unit normals and colours weighted by alpha, against
// lookups at many points of a patch.

namespace asos::test::between_texels_test {
namespace {

/// Mean visible colour of n x n points of a patch, and their mean alpha.
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

TEST(BetweenTexels, ColoursAreWeightedByAlpha) {
  const Image columns = make_image(64, 64, [](int x, int) {
    constexpr Texel red{255, 0, 0, 255}, green{0, 255, 0, 102}, blue{0, 0, 255, 0};
    return x / 8 % 4 == 1 ? green : x / 8 % 4 == 2 ? blue : red;
  });
  const auto look = [&](const Textured& t, TexelKind kind, std::optional<float> cutoff,
                        float height) {
    return filtered_texture(t.world, t.mips, t.use, {kind, cutoff},
                            {0, 0.31f, 0.4f, {{0.5f, 0.0f}, {0.0f, height}}});
  };
  // At this length the filter uses means of texels or coarser levels, which do not interpolate
  // along outlines. Shorter patches: see the next test.
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
  // Heights that select a coarser level, and the texels themselves.
  for (const float height : {0.5f, 0.06f}) {
    expect(look(blend, TexelKind::cover, {}, height), seen(blend, {}, height), "blend");
    expect(look(mask, TexelKind::cover, 0.3f, height), seen(mask, 0.3f, height), "mask");
    expect(look(mask, TexelKind::cover, 0.5f, height), seen(mask, 0.5f, height), "half");
    expect(look(mask, TexelKind::cover, 2.0f, height), {0.5f, 0.25f, 0.25f, 0.6f}, "none");
    expect(look(opaque, TexelKind::color, {}, height), {0.5f, 0.25f, 0.25f, 0.6f}, "opaque");
  }
}

// White labels on transparent black: along their outlines, interpolated colour and alpha vary
// together, as in a point lookup.
TEST(BetweenTexels, VisibleColourMatchesLookups) {
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

/// Mean of the unit normals at n x n points of a patch.
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

TEST(BetweenTexels, MeanNormalsMatchLookupsAndGiveVariance) {
  // Ridges tilted to either side by 30 degrees; random bumps; and a dome over the whole map.
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
    // A single point, up to four texels, and coarser levels.
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
}  // namespace asos::test::between_texels_test
