#include "tests/renderer/comparison/rival_scenes.h"
#include "tests/support/make_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asos::test::sobol_adaptive_test {
namespace {

constexpr std::uint64_t pixels = 64;

RenderSettings adaptive(double eps, int max_level, int size = 8) {
  RenderSettings settings = settings_for(Method::sobol_adaptive, 16, size);
  settings.asos.eps = eps;
  settings.asos.max_level = max_level;
  return settings;
}

/// Brighter from left to right, by an eighth per pixel: no two samples are equal.
std::shared_ptr<const RenderScene> gradient() {
  World world;
  add_card(world, {0, 0}, {8, 8}, unlit(glm::vec3(1)));
  for (const glm::vec3& at : world.positions)
    world.colors.emplace_back(glm::vec3((at.x + 4.0f) / 8.0f), 1.0f);
  return make_render_scene(std::move(world));
}

TEST(SobolAdaptive, AFlatPictureTakesTheFirstSixteenSamplesOnly) {
  const auto scene = make_render_scene(two_colours(4.0f, glm::vec3(0.25f), glm::vec3(0.75f)));
  const BlockResult r = render_small(*scene, adaptive(0.0, 8));
  EXPECT_EQ(r.statistics.eye_rays, pixels * 16);
  EXPECT_EQ(r.statistics.split_pixels, 0u);
  for (int x = 0; x < 8; ++x) EXPECT_EQ(red_at(r, x, 3), x < 4 ? 0.25f : 0.75f) << x;
}

// Pixels next to the edge wait until their neighbours have converged.
TEST(SobolAdaptive, AnEdgeAndItsNeighboursTakeMoreSamplesThanTheRest) {
  const auto scene = make_render_scene(two_colours(3.3f, glm::vec3(0), glm::vec3(1)));
  const BlockResult r = render_small(*scene, adaptive(1.0 / 256.0, 4));
  EXPECT_EQ(r.statistics.split_pixels, 24u);
  for (std::size_t i = 0; i < pixels; ++i) {
    const bool edge = i % 8 >= 2 && i % 8 <= 4;
    EXPECT_EQ(r.tile.split_level[i] > 0, edge) << i;
    EXPECT_GE(r.tile.rays[i], edge ? 32.0f : 16.0f) << i;
    EXPECT_LE(r.tile.rays[i], edge ? 1024.0f : 16.0f) << i;
  }
  // Four standard errors.
  for (int y = 0; y < 8; ++y) EXPECT_NEAR(red_at(r, 3, y), 0.7, 4.0 / 256.0) << y;
}

// A wire 1/25 pixel wide, which the 16 samples of every third pixel miss.
TEST(SobolAdaptive, NeighboursFindWhatFirstSamplesMiss) {
  World world;
  add_card(world, {-9, -9}, {17, 17}, unlit(glm::vec3(0)));
  add_card(world, {3.51f, -9}, {3.55f, 17}, unlit(glm::vec3(1)), 0.5f);
  const auto scene = make_render_scene(std::move(world));
  const BlockResult few = render_small(*scene, adaptive(1.0, 0));
  const BlockResult many = render_small(*scene, adaptive(1.0 / 1024.0, 5));
  int missed = 0;
  for (int y = 0; y < 8; ++y) {
    if (red_at(few, 3, y) == 0.0f) ++missed;
    EXPECT_NEAR(red_at(many, 3, y), 0.04, 4.0 / 1024.0) << y;
  }
  EXPECT_GT(missed, 0) << "otherwise there is nothing to find";
}

TEST(SobolAdaptive, EndsAtItsLimits) {
  const auto scene = gradient();
  for (const auto& [max_level, most] :
       {std::pair{0, 16u}, {1, 16u}, {2, 64u}, {3, 256u}, {4, 1024u}}) {
    const BlockResult r = render_small(*scene, adaptive(0.0, max_level));
    EXPECT_EQ(r.statistics.eye_rays, pixels * most) << max_level;
    const auto level = static_cast<std::uint8_t>(max_level < 2 ? 0 : max_level);
    EXPECT_EQ(r.tile.split_level, std::vector<std::uint8_t>(pixels, level)) << max_level;
    EXPECT_EQ(r.tile.rays, std::vector<float>(pixels, static_cast<float>(most))) << max_level;
    EXPECT_EQ(render_small(*scene, adaptive(1.0, max_level)).statistics.eye_rays, pixels * 16);
  }
}

TEST(SobolAdaptive, EqualsSobolWithAsManySamples) {
  const auto scene = gradient();
  const BlockResult all = render_small(*scene, adaptive(0.0, 3));
  const BlockResult sobol = render_small(*scene, settings_for(Method::sobol, 256));
  // Equal up to the order of summation.
  for (int x = 0; x < 8; ++x) EXPECT_NEAR(red_at(all, x, 5), red_at(sobol, x, 5), 1e-6) << x;
}

TEST(SobolAdaptive, StopsAtDisplayedWhite) {
  const auto white = make_render_scene(two_colours(3.3f, glm::vec3(2), glm::vec3(9)));
  EXPECT_EQ(render_small(*white, adaptive(0.0, 8)).statistics.eye_rays, pixels * 16);
  const auto grey = make_render_scene(two_colours(3.3f, glm::vec3(0.5f), glm::vec3(9)));
  EXPECT_EQ(render_small(*grey, adaptive(1.0 / 256.0, 4)).statistics.split_pixels, 0u)
      << "even its darkest pixel is white, by every quarter of its samples";
  const auto dark = make_render_scene(two_colours(3.3f, glm::vec3(0), glm::vec3(1.2f)));
  EXPECT_EQ(render_small(*dark, adaptive(1.0 / 256.0, 4)).statistics.split_pixels, 24u);
}

// Neutral displays values above white with differences of several steps, so an edge between two of
// them is refined.
TEST(SobolAdaptive, RefinesDifferencesVisibleThroughTheCurve) {
  const auto bright = make_render_scene(two_colours(3.3f, glm::vec3(1.2f), glm::vec3(4)));
  RenderSettings settings = adaptive(1.0 / 4096.0, 4);
  EXPECT_EQ(render_small(*bright, settings).statistics.split_pixels, 0u);
  for (const ToneCurve curve : {ToneCurve::neutral, ToneCurve::agx}) {
    settings.judged_tone = curve;
    const BlockResult r = render_small(*bright, settings);
    EXPECT_EQ(r.statistics.split_pixels, 24u);
    const double expected = displayed_intensity(glm::dvec3(0.3 * 1.2 + 0.7 * 4.0), curve).x;
    const auto found = static_cast<double>(red_at(r, 3, 3));
    EXPECT_NEAR(displayed_intensity(glm::dvec3(found), curve).x, expected, 4.0 / 256.0);
  }
}

/// A still life with penumbrae.
struct SoftScene {
  std::shared_ptr<const RenderScene> scene;
  Camera camera = look_at({2, 2, 5}, {0, 0.7, 0}, 0.7);

  SoftScene() {
    FlattenedScene still = still_life();
    const Light ball = make_bulb({1, 3, 2}, 5.0f, 0.5);
    still.lights = {ball};
    scene = make_render_scene(std::move(still));
  }
  [[nodiscard]] Picture picture(RenderSettings settings, int seed) const {
    settings.seed = seed;
    return render_picture(*scene, camera, settings);
  }
};

/// Differences between two displayed pictures: mean over pixels, and RMS.
struct Off {
  double mean = 0.0;
  double rms = 0.0;
};
Off off(const Picture& picture, const Picture& reference) {
  Off sum;
  const auto count = static_cast<double>(picture.film.radiance.size());
  for (std::size_t i = 0; i < picture.film.radiance.size(); ++i) {
    const double d = static_cast<double>(std::min(1.0f, picture.film.radiance[i].g)) -
                     static_cast<double>(std::min(1.0f, reference.film.radiance[i].g));
    sum.mean += d / count;
    sum.rms += d * d / count;
  }
  sum.rms = std::sqrt(sum.rms);
  return sum;
}

TEST(SobolAdaptive, MeetsEpsAndIsNotBiasedBesideSobol) {
  const SoftScene soft;
  const Picture reference = soft.picture(settings_for(Method::sobol, 4096, 24), 999);
  constexpr double eps = 1.0 / 64.0;
  constexpr int seeds = 16;
  double sum = 0.0;
  double squares = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    const Off found = off(soft.picture(adaptive(eps, 5, 24), seed), reference);
    EXPECT_LE(found.rms, eps) << seed;
    sum += found.mean;
    squares += found.mean * found.mean;
  }
  // The standard error of the mean comes from the seeds' means. The reference's noise is
  // negligible, because it has 4096 samples instead of 16 or more. By Student's distribution with
  // 15 degrees of freedom one in a thousand differs by more than four standard errors.
  const double mean = sum / seeds;
  const double spread = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
  EXPECT_GT(spread, 0.0);
  EXPECT_LE(std::abs(mean), 4.0 * spread);
}

TEST(SobolAdaptive, TakesFewerSamplesThanSobolToTheSameError) {
  const SoftScene soft;
  const Picture reference = soft.picture(settings_for(Method::sobol, 4096, 24), 999);
  const Picture fine = soft.picture(adaptive(1.0 / 128.0, 5, 24), 1);
  const double samples = static_cast<double>(fine.statistics.eye_rays) / (24.0 * 24.0);
  const auto as_many = static_cast<int>(std::ceil(samples));
  EXPECT_GT(as_many, 16);
  const Picture sobol = soft.picture(settings_for(Method::sobol, as_many, 24), 1);
  EXPECT_LT(off(fine, reference).rms, off(sobol, reference).rms);
}

}  // namespace
}  // namespace asos::test::sobol_adaptive_test
