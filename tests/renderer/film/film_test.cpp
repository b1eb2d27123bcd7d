#include "renderer/film/film.h"

#include "renderer/film/split_map.h"
#include "renderer/film/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace asos {
namespace {

TEST(Film, PutsTilesAndLeavesOutWhatLiesOutside) {
  Film film(4, 3);
  FinishedTile tile{.rect = {3, -1, 2, 3}};
  for (int i = 0; i < 6; ++i) {
    tile.radiance.emplace_back(static_cast<float>(i + 1));
    tile.split_level.push_back(static_cast<std::uint8_t>(i + 1));
    tile.cause.push_back(static_cast<SplitCause>(i + 1));
  }
  film.put(tile);
  EXPECT_EQ(film.radiance[film.index(3, 0)].x, 3.0f);
  EXPECT_EQ(film.radiance[film.index(3, 1)].x, 5.0f);
  EXPECT_EQ(film.split_level[film.index(3, 1)], 5);
  EXPECT_EQ(film.cause[film.index(3, 1)], static_cast<SplitCause>(5));
  EXPECT_EQ(std::count(film.cause.begin(), film.cause.end(), SplitCause::none), 10);
  float sum = 0.0f;
  for (const glm::vec3& c : film.radiance) sum += c.x;
  EXPECT_EQ(sum, 8.0f);
}

TEST(Film, ForgetsCostsWhereATileTellsNone) {
  Film film(4, 2);
  FinishedTile tile{.rect = {1, 0, 2, 2}};
  tile.radiance.resize(4);
  tile.split_level.resize(4);
  tile.cause.resize(4);
  tile.rays = {1, 2, 3, 4};
  tile.seconds.assign(4, 0.5f);
  film.put(tile);
  EXPECT_EQ(film.rays, (std::vector<float>{0, 1, 2, 0, 0, 3, 4, 0}));
  EXPECT_EQ(film.seconds[film.index(2, 1)], 0.5f);
  tile.rays.clear();
  tile.seconds.clear();
  film.put(tile);
  EXPECT_EQ(film.rays, std::vector<float>(8, 0.0f));
}

TEST(FinishedTile, CopiesThePixelsThatTwoShare) {
  const auto tile_at = [](const PixelRect& rect, float value) {
    FinishedTile tile{.rect = rect};
    const auto pixels = static_cast<std::size_t>(rect.width * rect.height);
    tile.radiance.assign(pixels, glm::vec3(value));
    tile.split_level.assign(pixels, static_cast<std::uint8_t>(value));
    tile.cause.assign(pixels, SplitCause::crease);
    tile.rays.assign(pixels, value);
    return tile;
  };
  FinishedTile to = tile_at({10, 20, 3, 2}, 1.0f);
  to.cause.assign(6, SplitCause::none);
  to.seconds.assign(6, 5.0f);
  copy_pixels(tile_at({11, 18, 9, 3}, 2.0f), to);
  EXPECT_EQ(to.rays, (std::vector<float>{1, 2, 2, 1, 1, 1}));
  EXPECT_EQ(to.split_level, (std::vector<std::uint8_t>{1, 2, 2, 1, 1, 1}));
  EXPECT_EQ(to.radiance[1], glm::vec3(2.0f));
  EXPECT_EQ(to.radiance[3], glm::vec3(1.0f));
  EXPECT_EQ(to.cause[2], SplitCause::crease);
  EXPECT_EQ(to.cause[4], SplitCause::none);
  EXPECT_EQ(to.seconds, (std::vector<float>{5, 0, 0, 5, 5, 5})) << "not told";
  // Costs that are not stored are skipped, and tiles without overlap change nothing.
  to.rays.clear();
  copy_pixels(tile_at({10, 20, 1, 1}, 3.0f), to);
  copy_pixels(tile_at({13, 20, 4, 4}, 4.0f), to);
  EXPECT_TRUE(to.rays.empty());
  EXPECT_EQ(to.split_level, (std::vector<std::uint8_t>{3, 2, 2, 1, 1, 1}));
}

TEST(SplitMap, CostsHaveAbsoluteLogarithmicScales) {
  Film film(5, 1);
  film.rays = {0.0f, 1.0f, 64.0f, 4096.0f, 1e9f};
  film.seconds = {0.0f, 1e-7f, 3.1622776e-5f, 1e-2f, 60.0f};
  for (const auto colours : {SplitMapColours::rays, SplitMapColours::time}) {
    const SplitMapKey key{colours};
    EXPECT_EQ(key.value(film, 0), 0) << "not told";
    EXPECT_EQ(key.colour(0), glm::u8vec3(0));
    EXPECT_EQ(key.value(film, 1), 1);
    EXPECT_EQ(key.value(film, 2), 128) << "half of the decades";
    EXPECT_EQ(key.value(film, 3), 255);
    EXPECT_EQ(key.value(film, 4), 255);
    EXPECT_EQ(key.colour(255), glm::u8vec3(255));
    int before = 0;
    for (int v = 1; v <= 255; ++v) {
      const glm::u8vec3 c = key.colour(static_cast<std::uint8_t>(v));
      const int sum = c.x + c.y + c.z;
      EXPECT_GE(sum, before - 1) << v << ": three roundings";
      before = sum;
    }
  }
}

TEST(Film, IgnoresTilesWithoutTheirData) {
  Film film(4, 4);
  FinishedTile tile{.rect = {0, 0, 2, 2}};
  tile.radiance.resize(3, glm::vec3(1.0f));
  tile.split_level.resize(4, 1);
  tile.cause.resize(4, SplitCause::crease);
  film.put(tile);
  tile.radiance.resize(4, glm::vec3(1.0f));
  tile.cause.resize(3);
  film.put(tile);
  for (const glm::vec3& c : film.radiance) EXPECT_EQ(c, glm::vec3(0.0f));
  EXPECT_TRUE(Film(-1, 5).radiance.empty());
}

TEST(Display, IsTheSrgbCurveClippedAtWhite) {
  const glm::vec3 c = display_rgb({0.001f, 0.5f, 2.0f}, 0.0f);
  EXPECT_FLOAT_EQ(c.r, 0.01292f);
  EXPECT_NEAR(c.g, 1.055 * std::pow(0.5, 1.0 / 2.4) - 0.055, 1e-6);
  EXPECT_EQ(c.b, 1.0f);
  EXPECT_EQ(display_rgb(glm::vec3(-1.0f), 0.0f), glm::vec3(0.0f));
  EXPECT_EQ(display_rgb(glm::vec3(std::numeric_limits<float>::quiet_NaN()), 0.0f), glm::vec3(0));
}

TEST(Display, ExposureCountsInStops) {
  EXPECT_EQ(display_rgb(glm::vec3(0.125f), 2.0f), display_rgb(glm::vec3(0.5f), 0.0f));
  EXPECT_EQ(display_bytes(glm::vec3(0.5f), -1.0f), display_bytes(glm::vec3(0.25f), 0.0f));
}

TEST(Display, BytesAreTheRoundedCurve) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<float> d(-0.1f, 1.1f);
  for (int i = 0; i < 100000; ++i) {
    const float x = i < 5000 ? static_cast<float>(i) * 1e-6f : d(rng);
    const float exact = 255.0f * display_rgb(glm::vec3(x), 0.0f).r;
    // Near one half, float rounding may differ between the table and the curve.
    const float to_half = std::abs(exact - std::floor(exact) - 0.5f);
    if (to_half < 1e-3f) continue;
    EXPECT_EQ(display_bytes(glm::vec3(x), 0.0f).r, static_cast<int>(exact + 0.5f)) << x;
  }
  EXPECT_EQ(display_bytes(glm::vec3(std::numeric_limits<float>::quiet_NaN()), 0.0f),
            glm::u8vec3(0));
  EXPECT_EQ(display_bytes(glm::vec3(std::numeric_limits<float>::infinity()), 0.0f),
            glm::u8vec3(255));
}

TEST(SplitColour, GrowsBrighterWithTheLevelAndIsBlackForNone) {
  EXPECT_EQ(split_colour(0), glm::u8vec3(0));
  EXPECT_EQ(split_colour(0, SplitCause::outline), exact_colour);
  double last = 0.0;
  for (int level = 1; level <= split_colour_levels; ++level) {
    const glm::u8vec3 c = split_colour(level, SplitCause::outline);
    EXPECT_EQ(split_colour(level), c) << "whatever the cause";
    EXPECT_NE(c, exact_colour);
    const double luma = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
    EXPECT_GT(luma, last) << level;
    last = luma;
  }
  EXPECT_EQ(split_colour(split_colour_levels + 3), split_colour(split_colour_levels));
}

TEST(SplitColour, IsTheMapsColour) {
  Film film(3, 1);
  film.split_level = {0, 0, 4};
  film.cause = {SplitCause::none, SplitCause::crease, SplitCause::shading};
  const SplitMapKey key{SplitMapColours::level};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(key.colour(key.value(film, i)), split_colour(film.split_level[i], film.cause[i]));
  EXPECT_EQ(split_words(0, SplitCause::none, 0), "not split");
  EXPECT_EQ(split_words(0, SplitCause::crease, 0), "exact, crease, seam");
  EXPECT_EQ(split_words(4, SplitCause::shading, 0), "level 4, shading");
  EXPECT_EQ(split_words(2, SplitCause::none, 0), "level 2") << "the method records no causes";
}

// A sampled pixel was once "level 3" over a drawing of one undivided cell.
TEST(SplitColour, OfSampledPixelsIsNotThatOfALevel) {
  Film film(4, 1);
  film.cause = {SplitCause::shading, SplitCause::shadow, SplitCause::shadow, SplitCause::shadow};
  film.split_level = {0, 0, 0, 2};
  film.samples = {16, 12, 0, 12};
  const SplitMapKey key{SplitMapColours::level};
  EXPECT_EQ(key.colour(key.value(film, 0)), sampled_colour);
  EXPECT_EQ(key.colour(key.value(film, 1)), sampled_colour);
  EXPECT_EQ(key.colour(key.value(film, 2)), exact_colour);
  EXPECT_EQ(key.colour(key.value(film, 3)), split_colour(2));
  for (int level = 0; level <= split_colour_levels; ++level)
    EXPECT_NE(split_colour(level), sampled_colour);
  EXPECT_EQ(split_words(film, 0), "16 samples, shading");
  EXPECT_EQ(split_words(film, 2), "exact, shadow");
  EXPECT_EQ(split_words(film, 3), "level 2, 12 samples, shadow");
  EXPECT_EQ(split_words(0, SplitCause::lens, 0), "sampled, lens blur");
}

TEST(Film, KeepsTheNumberOfSamplesOfFinalTiles) {
  FinishedTile tile{.rect = {0, 0, 2, 1}};
  tile.radiance.resize(2);
  tile.split_level = {0, 0};
  tile.cause = {SplitCause::shading, SplitCause::none};
  tile.outlook.resize(2);
  tile.outlook[0].samples = 70'000;
  Film film(2, 1);
  film.put(tile);
  EXPECT_EQ(film.samples, (std::vector<std::uint16_t>{0xffff, 0}));
  tile.coarse = true;
  tile.outlook.clear();
  film.put(tile);
  EXPECT_EQ(film.samples[0], 0xffff) << "coarse tiles do not know it";
}

TEST(Statistics, AddUp) {
  RenderStatistics a{.eye_rays = 1, .shadow_rays = 2, .reflection_rays = 3};
  a.pyrays_by_level[8] = 4;
  a.split_pixels = 5;
  a.missed_splits = 6;
  a.saturated_pixels = 7;
  a.unresolved_area = 0.5;
  a.rejected_samples = 8;
  a.cut_stacks = 9;
  a.count_sample(SamplePath::face, 10);
  a.pixels_by_cause[static_cast<std::size_t>(SplitCause::shadow)] = 9;
  RenderStatistics b = a;
  b += a;
  EXPECT_EQ(b.eye_rays, 2u);
  EXPECT_EQ(b.shadow_rays, 4u);
  EXPECT_EQ(b.reflection_rays, 6u);
  EXPECT_EQ(b.pyrays_by_level[8], 8u);
  EXPECT_EQ(b.split_pixels, 10u);
  EXPECT_EQ(b.missed_splits, 12u);
  EXPECT_EQ(b.saturated_pixels, 14u);
  EXPECT_EQ(b.unresolved_area, 1.0);
  EXPECT_EQ(b.rejected_samples, 16u);
  EXPECT_EQ(b.cut_stacks, 18u);
  EXPECT_EQ(b.samples_by_path[static_cast<std::size_t>(SamplePath::face)], 20u);
  EXPECT_EQ(b.pixels_by_cause[static_cast<std::size_t>(SplitCause::shadow)], 18u);
}

TEST(Statistics, LightsAddUpInAnyOrder) {
  RenderStatistics few, many;
  few.count_shadow_ray(0, 5);
  few.count_shadow_pyray(0);
  many.count_shadow_ray(3, 7);
  many.count_shadow_ray(0);
  many.count_shadow_pyray(2, 4);
  RenderStatistics one = few, other = many;
  one += many;
  other += few;
  EXPECT_EQ(one.lights, other.lights);
  ASSERT_EQ(one.lights.size(), 4u);
  EXPECT_EQ(one.lights[0], (LightStatistics{6, 1}));
  EXPECT_EQ(one.lights[1], LightStatistics{});
  EXPECT_EQ(one.lights[2], (LightStatistics{0, 4}));
  EXPECT_EQ(one.of_light(3), (LightStatistics{7, 0}));
  EXPECT_EQ(one.of_light(9), LightStatistics{});
  EXPECT_EQ(one.shadow_rays, 13u);
  EXPECT_EQ(one.shadow_pyrays, 5u);
}

}  // namespace
}  // namespace asos
