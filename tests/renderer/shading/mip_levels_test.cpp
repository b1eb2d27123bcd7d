#include "renderer/shading/mip_levels.h"

#include "renderer/shading/bilinear.h"
#include "renderer/shading/texture.h"
#include "tests/support/tiny_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

// Mip levels against slow ones in double precision, texel by texel.

namespace asos {
namespace {

using test::make_image;
using test::Texel;

/// Bytes of a texel, at random from its place.
Texel speckle(int x, int y) {
  auto h = static_cast<std::uint32_t>(x * 7919 + y * 104729 + 17) * 2654435761u;
  h ^= h >> 15;
  h *= 2246822519u;
  return {static_cast<std::uint8_t>(h >> 24), static_cast<std::uint8_t>(h >> 16),
          static_cast<std::uint8_t>(h >> 8), static_cast<std::uint8_t>(h)};
}

/// Noise whose alpha is 0 over half of the image.
Texel cut_out(int x, int y) {
  Texel texel = speckle(x, y);
  if (x / 3 % 2 == 0) texel[3] = 0;
  return texel;
}

/// Normals of gentle waves, with a bend from one row to the next.
Texel waves(int x, int y) {
  const auto byte = [](double n) {
    return static_cast<std::uint8_t>(std::lround(127.5 * (n + 1)));
  };
  const double tilt = 0.1 * std::sin(0.7 * x) + (y == 5 ? 0.6 : 0.0);
  return {byte(std::sin(tilt)), byte(0.05 * std::cos(0.5 * y)), byte(std::cos(tilt)), 255};
}

Image with_low_bytes(Image image) {
  SharedBytes::Bytes low;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    low.push_back(static_cast<std::uint8_t>(37 * i + 11));
  image.low = SharedBytes(std::move(low));
  return image;
}

glm::dvec3 unit(glm::dvec3 n) {
  return n / glm::length(n);
}

/// Returns the mean of the unit normals at n x n places in a texel.
glm::dvec3 normal_of(const Texels& texels, int x, int y, int n) {
  const auto at = [&](int u, int v) {
    return 2.0 * glm::dvec3(texels.at(std::clamp(u, 0, texels.width - 1),
                                      std::clamp(v, 0, texels.height - 1))) -
           1.0;
  };
  glm::dvec3 sum(0.0);
  for (int k = 0; k < n * n; ++k) {
    const glm::dvec2 off = (glm::dvec2(k % n, k / n) + 0.5) / static_cast<double>(n) - 0.5;
    const int u = off.x < 0.0 ? -1 : 1, v = off.y < 0.0 ? -1 : 1;
    const glm::dvec2 t = glm::abs(off);
    sum += unit(glm::mix(glm::mix(at(x, y), at(x + u, y), t.x),
                         glm::mix(at(x, y + v), at(x + u, y + v), t.x), t.y));
  }
  return sum / static_cast<double>(n * n);
}

/// Returns a texel of the image, or of level 1 and up, as the texels of its kind are averaged.
glm::dvec4 texel_of(const Image& image, TexelKind kind, int x, int y) {
  const Texels texels(image, kind == TexelKind::color || kind == TexelKind::cover
                                 ? Encoding::srgb
                                 : Encoding::linear);
  if (kind != TexelKind::normal) return glm::dvec4(texels.at(x, y));
  glm::dvec3 mean = normal_of(texels, x, y, 2);
  if (glm::dot(mean, unit(2.0 * glm::dvec3(texels.at(x, y)) - 1.0)) < 1.0 - 1e-3)
    mean = normal_of(texels, x, y, 4);
  return {0.5 + 0.5 * mean, 1.0 - glm::dot(mean, mean)};
}

template <typename TexelAt>
glm::dvec4 mean_of(const TexelAt& texel, TexelKind kind, glm::dvec2 low, glm::dvec2 high) {
  glm::dvec4 sum(0.0), seen(0.0);
  double weight = 0.0, square = 0.0;
  for (int y = static_cast<int>(low.y); y < high.y; ++y) {
    for (int x = static_cast<int>(low.x); x < high.x; ++x) {
      const glm::dvec2 part = glm::min(high, glm::dvec2(x + 1, y + 1)) - glm::max(low, {x, y});
      const double share = part.x * part.y;
      const glm::dvec4 value = texel(x, y);
      const glm::dvec3 normal = 2.0 * glm::dvec3(value) - 1.0;
      weight += share;
      sum += share * value;
      seen += share * value.a * value;
      square += share * (value.a + glm::dot(normal, normal));
    }
  }
  glm::dvec4 mean = sum / weight;
  if (kind == TexelKind::cover && sum.a > 0.0) mean = glm::dvec4(glm::dvec3(seen) / sum.a, mean.a);
  const glm::dvec3 normal = 2.0 * glm::dvec3(mean) - 1.0;
  if (kind == TexelKind::normal) mean.a = square / weight - glm::dot(normal, normal);
  return glm::clamp(mean, 0.0, 1.0);
}

/// Expects the levels of an image to be those of the level before each, within rounding.
void expect_means(const Image& image, TexelKind kind) {
  // Half a step, and what single precision adds.
  constexpr double rounding = 0.52;
  const std::vector<MipLevel> levels = make_mip_levels(image, kind);
  ASSERT_EQ(levels.size(), mip_levels_of(image));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const MipLevel& level = levels[i];
    EXPECT_EQ(level.width, side_of_level(image.width, i + 1));
    EXPECT_EQ(level.height, side_of_level(image.height, i + 1));
    ASSERT_EQ(level.rgba.size(), 4u * static_cast<std::size_t>(level.width * level.height));
    const auto finer = [&](int x, int y) {
      return i == 0 ? texel_of(image, kind, x, y) : glm::dvec4(levels[i - 1].at(x, y));
    };
    const glm::dvec2 scale(static_cast<double>(side_of_level(image.width, i)) / level.width,
                           static_cast<double>(side_of_level(image.height, i)) / level.height);
    double worst = 0.0;
    for (int y = 0; y < level.height; ++y) {
      for (int x = 0; x < level.width; ++x) {
        const glm::dvec4 mean =
            mean_of(finer, kind, scale * glm::dvec2(x, y), scale * glm::dvec2(x + 1, y + 1));
        for (int c = 0; c < 4; ++c)
          worst = std::max(worst, std::abs(65535.0 * mean[c] - level.texel(x, y)[c]));
      }
    }
    EXPECT_LT(worst, rounding) << image.width << " x " << image.height << ", level " << i + 1;
  }
}

TEST(MipLevels, AreThoseOfDoublePrecisionForAllKindsAndSizes) {
  for (const auto& [width, height] :
       {std::pair{64, 32}, {13, 7}, {1, 9}, {5, 1}, {2, 1}, {31, 2}, {48, 36}, {97, 40}}) {
    const Image plain = make_image(width, height, speckle);
    const Image cut = make_image(width, height, cut_out);
    const Image normals = make_image(width, height, waves);
    for (const bool wide : {false, true}) {
      SCOPED_TRACE(wide ? "16 bits" : "8 bits");
      const auto image = [&](const Image& of) { return wide ? with_low_bytes(of) : of; };
      for (const TexelKind kind : {TexelKind::color, TexelKind::cover, TexelKind::data}) {
        SCOPED_TRACE(static_cast<int>(kind));
        expect_means(image(plain), kind);
        expect_means(image(cut), kind);
      }
      SCOPED_TRACE("normals");
      expect_means(image(normals), TexelKind::normal);
      expect_means(image(plain), TexelKind::normal);
    }
  }
}

TEST(MipLevels, OfOneTexelOrNoneAreNone) {
  EXPECT_EQ(mip_levels_of(Image{}), 0u);
  EXPECT_TRUE(make_mip_levels(Image{}, TexelKind::color).empty());
  EXPECT_TRUE(make_mip_levels(make_image(1, 1, speckle), TexelKind::normal).empty());
}

}  // namespace
}  // namespace asos
