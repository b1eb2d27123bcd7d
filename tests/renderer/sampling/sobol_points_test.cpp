#include "renderer/sampling/sobol_points.h"

#include "renderer/sampling/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace asos {
namespace {

using Point = std::array<double, 4>;  // x, y in the pixel, u, v on a light

Point point(const SobolPixel& pixel, std::uint32_t index, std::uint32_t light = 0) {
  const glm::dvec2 p = pixel.pixel(index);
  const glm::dvec2 l = pixel.light(index, light);
  return {p.x, p.y, l.x, l.y};
}

std::vector<Point> points(const SobolPixel& pixel, std::uint32_t first, std::uint32_t count,
                          std::uint32_t light = 0) {
  std::vector<Point> all;
  for (std::uint32_t i = 0; i < count; ++i) all.push_back(point(pixel, first + i, light));
  return all;
}

/// Whether 2^m points are a (t, m, s)-net in the given dimensions: every elementary interval of
/// volume 2^(t-m) contains 2^t of them.
bool is_net(const std::vector<Point>& net, const std::vector<std::size_t>& dimensions, int t) {
  const int m = std::countr_zero(net.size());
  std::vector<int> halvings(dimensions.size(), 0);
  const std::function<bool(std::size_t, int)> check = [&](std::size_t d, int left) {
    if (d + 1 < dimensions.size()) {
      for (int q = 0; q <= left; ++q) {
        halvings[d] = q;
        if (!check(d + 1, left - q)) return false;
      }
      return true;
    }
    halvings[d] = left;
    std::vector<int> counts(net.size() >> t, 0);
    for (const Point& p : net) {
      std::size_t cell = 0;
      for (std::size_t i = 0; i < dimensions.size(); ++i) {
        const double cells = std::ldexp(1.0, halvings[i]);
        cell = (cell << halvings[i]) + static_cast<std::size_t>(p[dimensions[i]] * cells);
      }
      ++counts[cell];
    }
    return std::all_of(counts.begin(), counts.end(), [t](int n) { return n == 1 << t; });
  };
  return m <= t || check(0, m - t);
}

std::uint32_t bits(int dimension, std::uint32_t index) {
  return sobol_bits(static_cast<SobolDimension>(dimension), index);
}

TEST(SobolBits, AreJoeAndKuosFirstPoints) {
  // The first ten points in three dimensions from the authors' notes, in the order of the Gray
  // code.
  constexpr double published[10][3] = {{0, 0, 0},
                                       {0.5, 0.5, 0.5},
                                       {0.75, 0.25, 0.25},
                                       {0.25, 0.75, 0.75},
                                       {0.375, 0.375, 0.625},
                                       {0.875, 0.875, 0.125},
                                       {0.625, 0.125, 0.875},
                                       {0.125, 0.625, 0.375},
                                       {0.1875, 0.3125, 0.9375},
                                       {0.6875, 0.8125, 0.4375}};
  for (std::uint32_t n = 0; n < 10; ++n) {
    for (int d = 0; d < 3; ++d) {
      EXPECT_EQ(std::ldexp(bits(d, n ^ (n >> 1)), -32), published[n][d]) << n << " " << d;
    }
  }
}

// Also beyond the first byte of an index: each digit has a direction number by Sobol's recurrence,
// and those of an index's digits are combined by exclusive or.
TEST(SobolBits, AreSumsOfDirectionNumbersWhateverTheIndex) {
  std::uint32_t m = 1;  // direction numbers of the polynomial x + 1
  for (int k = 0; k < 32; ++k) {
    const std::uint32_t power = 1u << k;
    EXPECT_EQ(bits(0, power), 0x80000000u >> k);
    EXPECT_EQ(bits(1, power), m << (31 - k)) << k;
    m = (2 * m) ^ m;
  }
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::uint64_t random = mix_bits(seed);
    const auto a = static_cast<std::uint32_t>(random);
    const auto b = static_cast<std::uint32_t>(random >> 32);
    for (int d = 0; d < 4; ++d) {
      EXPECT_EQ(bits(d, a ^ b), bits(d, a) ^ bits(d, b)) << d;
      EXPECT_EQ(mirrored_sobol_bits(static_cast<SobolDimension>(d), a), mirrored_digits(bits(d, a)))
          << d;
    }
  }
}

TEST(OwenScramble, DependsOnTheDigitsBeforeAlone) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::uint64_t random = mix_bits(seed);
    const auto a = static_cast<std::uint32_t>(random);
    const auto b = a ^ (static_cast<std::uint32_t>(random >> 32) >> (seed % 32));
    const std::uint64_t key = mix_bits(random);
    // The first digit in which two numbers differ stays the same after scrambling.
    EXPECT_EQ(std::countl_zero(owen_scramble(a, key) ^ owen_scramble(b, key)),
              std::countl_zero(a ^ b));
  }
}

TEST(OwenScramble, FlipsEveryDigitOfEveryBranchIndependently) {
  // The flips at the first 31 nodes of the tree, over many seeds: each is a fair coin, and each
  // pair two fair coins. Allows 5 standard deviations of 2^14 throws; there are 496 of them.
  constexpr int throws = 1 << 14;
  std::vector<std::array<int, 31>> flips(throws);
  for (int i = 0; i < throws; ++i) {
    const std::uint64_t seed = mix_bits(static_cast<std::uint64_t>(i));
    for (std::uint32_t node = 0; node < 31; ++node) {
      const int level = std::bit_width(node + 1) - 1;
      const std::uint32_t prefix = node + 1 - (1u << level);
      const std::uint32_t bits = level == 0 ? 0 : prefix << (32 - level);
      flips[static_cast<std::size_t>(i)][node] =
          (owen_scramble(bits, seed) >> (31 - level)) & 1u ? 1 : -1;
    }
  }
  const double bound = 5.0 * std::sqrt(throws);
  for (std::size_t a = 0; a < 31; ++a) {
    int sum = 0;
    for (const auto& f : flips) sum += f[a];
    EXPECT_LT(std::abs(sum), bound) << a;
    for (std::size_t b = 0; b < a; ++b) {
      int both = 0;
      for (const auto& f : flips) both += f[a] * f[b];
      EXPECT_LT(std::abs(both), bound) << a << " " << b;
    }
  }
}

TEST(SobolPixel, PixelPointsAreNetsOfQualityZero) {
  for (const auto& [x, y, seed] : {std::array{0, 0, 0}, {17, 5, 1}, {-3, 1919, 77}}) {
    const SobolPixel pixel(x, y, static_cast<std::uint32_t>(seed));
    for (std::uint32_t m = 0; m <= 11; ++m) {
      for (const std::uint32_t block : {0u, 1u, 6u}) {
        EXPECT_TRUE(is_net(points(pixel, block << m, 1u << m), {0, 1}, 0)) << m << " " << block;
      }
    }
  }
}

TEST(SobolPixel, LightPointsAreNets) {
  for (const std::uint32_t light : {0u, 1u, 40u}) {
    const SobolPixel pixel(12, 34, 5);
    for (std::uint32_t m = 0; m <= 11; ++m) {
      for (const std::uint32_t block : {0u, 1u, 6u}) {
        const std::vector<Point> net = points(pixel, block << m, 1u << m, light);
        EXPECT_TRUE(is_net(net, {2}, 0)) << m << " " << block;
        EXPECT_TRUE(is_net(net, {3}, 0)) << m << " " << block;
        EXPECT_TRUE(is_net(net, {2, 3}, 2)) << m << " " << block;
      }
    }
  }
}

TEST(SobolPixel, PixelAndLightTogetherAreNets) {
  for (const std::uint32_t light : {0u, 3u}) {
    const SobolPixel pixel(7, 8, 9);
    for (std::uint32_t m = 0; m <= 10; ++m) {
      for (const std::uint32_t block : {0u, 5u}) {
        const std::vector<Point> net = points(pixel, block << m, 1u << m, light);
        EXPECT_TRUE(is_net(net, {0, 1, 2, 3}, 3)) << m << " " << block;
      }
    }
  }
}

TEST(SobolPixel, IsNoNetOfBetterQuality) {
  // The net test must detect that the light's two dimensions are no net of quality zero, and that
  // the pixel's are none if the points do not start at a multiple of their number.
  const SobolPixel pixel(1, 2, 3);
  EXPECT_FALSE(is_net(points(pixel, 0, 64), {2, 3}, 0));
  EXPECT_FALSE(is_net(points(pixel, 3, 64), {0, 1}, 0));
}

/// All coordinates of one sample of many pixels: x, y, and u, v of two lights.
std::vector<std::array<double, 6>> over_pixels(std::uint32_t index, std::uint32_t seed, int dx = 0,
                                               int dy = 0) {
  std::vector<std::array<double, 6>> all;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const SobolPixel pixel(x + dx, y + dy, seed);
      const Point a = point(pixel, index, 0);
      const glm::dvec2 b = pixel.light(index, 1);
      all.push_back({a[0], a[1], a[2], a[3], b.x, b.y});
    }
  }
  return all;
}

/// Correlation of two coordinates, each uniform.
double correlation(const std::vector<std::array<double, 6>>& a, std::size_t i,
                   const std::vector<std::array<double, 6>>& b, std::size_t j) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k][i] - 0.5) * (b[k][j] - 0.5);
  return 12.0 * sum / static_cast<double>(a.size());
}

// Five standard deviations of a mean over the 4096 pixels, for values of variance 1.
constexpr double bound = 5.0 / 64.0;

TEST(SobolPixel, EachSampleIsUniformOverPixels) {
  for (const std::uint32_t index : {0u, 1u, 5u, 1000u}) {
    const auto all = over_pixels(index, 11);
    for (std::size_t c = 0; c < 6; ++c) {
      double mean = 0.0;
      std::array<int, 64> histogram{};
      for (const auto& p : all) {
        ASSERT_GE(p[c], 0.0);
        ASSERT_LT(p[c], 1.0);
        mean += p[c] / static_cast<double>(all.size());
        ++histogram[static_cast<std::size_t>(64.0 * p[c])];
      }
      EXPECT_LT(std::abs(mean - 0.5), bound / std::sqrt(12.0)) << index << " " << c;
      // Chi squared of 63 degrees of freedom: mean 63, standard deviation sqrt(126).
      double chi = 0.0;
      for (const int n : histogram) chi += (n - 64.0) * (n - 64.0) / 64.0;
      EXPECT_LT(chi, 63.0 + 5.0 * std::sqrt(126.0)) << index << " " << c;
    }
  }
}

TEST(SobolPixel, PixelsSeedsAndDimensionsAreUncorrelated) {
  for (const std::uint32_t index : {0u, 3u}) {
    const auto here = over_pixels(index, 11);
    const auto right = over_pixels(index, 11, 1, 0);
    const auto below = over_pixels(index, 11, 0, 1);
    const auto reseeded = over_pixels(index, 12);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        EXPECT_LT(std::abs(correlation(here, i, right, j)), bound) << i << " " << j;
        EXPECT_LT(std::abs(correlation(here, i, below, j)), bound) << i << " " << j;
        EXPECT_LT(std::abs(correlation(here, i, reseeded, j)), bound) << i << " " << j;
        if (i == j) continue;
        EXPECT_LT(std::abs(correlation(here, i, here, j)), bound) << i << " " << j;
      }
    }
  }
}

TEST(SobolPixel, IsAFunctionOfItsKeysAlone) {
  const SobolPixel pixel(3, 4, 5);
  const glm::dvec2 late = pixel.light(9, 2);
  const glm::dvec2 early = pixel.pixel(1);
  const SobolPixel again(3, 4, 5);
  EXPECT_EQ(again.pixel(1), early);
  EXPECT_EQ(again.light(9, 2), late);
  // No two pixels of a picture, for a few seeds, have the same points.
  std::set<std::pair<double, double>> seen;
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x) {
      for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const glm::dvec2 p = SobolPixel(x, y, seed).pixel(0);
        seen.emplace(p.x, p.y);
      }
    }
  }
  EXPECT_EQ(seen.size(), 10'000u);
}

/// RMSE, over pixels, of the mean of `n` values of an integrand.
template <typename Value>
double rms_error(std::uint32_t n, double expected, Value value) {
  constexpr int pixels = 400;
  double sum = 0.0;
  for (int p = 0; p < pixels; ++p) {
    const SobolPixel pixel(p, 2 * p, 1);
    double mean = 0.0;
    for (std::uint32_t i = 0; i < n; ++i) mean += value(pixel, p, i) / n;
    sum += (mean - expected) * (mean - expected) / pixels;
  }
  return std::sqrt(sum);
}

// A smooth function of two variables and its integral over the unit square.
double smooth(double x, double y) {
  return std::exp(x) * std::sin(2.0 * y);
}
const double smooth_integral = (std::exp(1.0) - 1.0) * 0.5 * (1.0 - std::cos(2.0));

TEST(SobolPixel, IntegratesSmoothFunctionsBetterThanStratifiedSamples) {
  const auto in_pixel = [](const SobolPixel& pixel, int, std::uint32_t i) {
    const glm::dvec2 p = pixel.pixel(i);
    return smooth(p.x, p.y);
  };
  const auto on_light = [](const SobolPixel& pixel, int, std::uint32_t i) {
    const glm::dvec2 p = pixel.light(i, 2);
    return smooth(p.x, p.y);
  };
  const auto stratified = [](const SobolPixel&, int p, std::uint32_t i) {
    const RandomPair r = unit_pair(pixel_random(p, 7, i));
    return smooth((i % 16 + r.u) / 16.0, (i / 16 + r.v) / 16.0);
  };
  const double reference = rms_error(256, smooth_integral, stratified);
  // Here the variance falls as N^-2 for stratified samples, and nearly as N^-3 for scrambled nets
  // (Owen 1997, "Scrambled net variance for integrals of smooth functions").
  const auto rate = [](auto value) {
    return 2.0 *
           std::log2(rms_error(64, smooth_integral, value) /
                     rms_error(1024, smooth_integral, value)) /
           4.0;
  };
  EXPECT_LT(rms_error(256, smooth_integral, in_pixel), reference);
  EXPECT_LT(rms_error(256, smooth_integral, on_light), reference);
  EXPECT_GT(rate(in_pixel), 2.25);
  EXPECT_GT(rate(on_light), 2.25);
}

TEST(SobolPixel, StratifiesEveryLightTogetherWithThePixel) {
  // x u + y v couples pixel and light. Samples that are stratified separately and paired at random
  // converge only at the random rate.
  for (const std::uint32_t light : {0u, 5u}) {
    const auto together = [light](const SobolPixel& pixel, int, std::uint32_t i) {
      const Point p = point(pixel, i, light);
      return p[0] * p[2] + p[1] * p[3];
    };
    // A permutation that maps the set 0 to 255 to itself.
    const auto paired_at_random = [light](const SobolPixel& pixel, int p, std::uint32_t i) {
      const std::uint64_t seed = mix_bits(static_cast<std::uint64_t>(p));
      const Point a = point(pixel, i, light);
      const Point b = point(pixel, owen_scramble(i << 24, seed) >> 24, light);
      return a[0] * b[2] + a[1] * b[3];
    };
    EXPECT_LT(rms_error(256, 0.5, together), 0.25 * rms_error(256, 0.5, paired_at_random));
  }
}

TEST(SobolPixel, StratifiesTimeAloneAndTogetherWithThePixel) {
  for (const bool beside_lens : {false, true}) {
    const SobolPixel pixel(3, 7, 5);
    std::vector<bool> met(64, false);
    for (std::uint32_t i = 0; i < 64; ++i)
      met[static_cast<std::size_t>(64.0 * pixel.time(i, beside_lens))] = true;
    EXPECT_EQ(std::count(met.begin(), met.end(), true), 64) << beside_lens;
  }
  // An edge that crosses a pixel while the shutter is open; it covers half of the pixel.
  const auto edge = [](const SobolPixel& pixel, int, std::uint32_t i) {
    return pixel.pixel(i).x < pixel.time(i, false) ? 1.0 : 0.0;
  };
  const auto paired_at_random = [](const SobolPixel& pixel, int p, std::uint32_t i) {
    const std::uint64_t seed = mix_bits(static_cast<std::uint64_t>(p));
    return pixel.pixel(i).x < pixel.time(owen_scramble(i << 24, seed) >> 24, false) ? 1.0 : 0.0;
  };
  EXPECT_LT(rms_error(256, 0.5, edge), 0.7 * rms_error(256, 0.5, paired_at_random));
}

}  // namespace
}  // namespace asos
