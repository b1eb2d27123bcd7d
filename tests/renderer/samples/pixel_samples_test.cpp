#include "renderer/samples/pixel_samples.h"

#include "renderer/samples/sobol_sampler.h"
#include "renderer/scene/builtin.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace asos::test::pixel_samples_test {
namespace {

TEST(PixelSamples, DoubleUntilThereAreEnough) {
  EXPECT_EQ(PixelSamples::after_round(0, 16), 1);
  EXPECT_EQ(PixelSamples::after_round(1, 16), 2);
  EXPECT_EQ(PixelSamples::after_round(8, 16), 16);
  EXPECT_EQ(PixelSamples::after_round(8, 9), 9);
}

// Rendering in single passes gives the same pixels as a block that takes all samples at once.
TEST(PixelSamples, RoundsEndAsABlockDoes) {
  const auto scene = *prepare(*builtin_scene("boxes"));
  const RenderSettings settings = make_settings(64, 64);
  const View view(first_camera(scene->world(), 1.0), 64, 64,
                  radius_around_origin(scene->world().bounds));
  const BlockJob job{*scene, view, settings, {0, 32, 32, 32}};
  PixelSamples pixels(job.block);
  for (const int end : {1, 2, 4, 8, 12}) {
    SobolSampler places(settings.seed);
    pixels.advance(job, places, end, 12);
    EXPECT_EQ(pixels.taken(), end);
  }
  SobolSampler places(settings.seed);
  const BlockResult direct = sample_block(job, places, 12);
  EXPECT_EQ(pixels.result().tile.radiance, direct.tile.radiance);
  EXPECT_EQ(pixels.result().statistics.rays(), direct.statistics.rays());
}

TEST(PixelSamples, TellWhatMoved) {
  const auto scene = *prepare(*builtin_scene("boxes"));
  const RenderSettings settings = make_settings(64, 64);
  const View view(first_camera(scene->world(), 1.0), 64, 64,
                  radius_around_origin(scene->world().bounds));
  const BlockJob job{*scene, view, settings, {0, 32, 32, 32}};
  PixelSamples pixels(job.block);
  SobolSampler places(settings.seed);
  pixels.advance(job, places, 1, 1);
  const std::vector<glm::vec3> one = pixels.result().tile.radiance;
  EXPECT_EQ(pixels.moved(), 0.0);
  pixels.advance(job, places, 2, 2);
  const std::vector<glm::vec3> two = pixels.result().tile.radiance;
  int some = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const glm::vec3 off = glm::clamp(two[i], 0.0f, 1.0f) - glm::clamp(one[i], 0.0f, 1.0f);
    EXPECT_NEAR(pixels.moved(i), glm::dot(off, off), 1e-5);
    some += pixels.moved(i) > 0.0f;
  }
  EXPECT_GT(some, 100);
}

// Visits each stratum once; the first eighth of them lies in all quarters of the pixel.
TEST(GridSampler, VisitEachStratumOnceAndSpreadTheFirst) {
  for (const int n : {1, 2, 3, 4, 8, 16}) {
    GridSampler places(n, false);
    places.start_pixel(3, 5);
    std::set<std::pair<int, int>> seen;
    for (int i = 0; i < n * n; ++i) {
      places.start_sample(i);
      const PixelPoint p = places.in_pixel();
      seen.emplace(static_cast<int>(p.x * n), static_cast<int>(p.y * n));
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(n * n)) << n;
  }
  GridSampler places(8, false);
  places.start_pixel(0, 0);
  std::set<std::pair<int, int>> quarters;
  for (int i = 0; i < 8; ++i) {
    places.start_sample(i);
    const PixelPoint p = places.in_pixel();
    quarters.emplace(static_cast<int>(2 * p.x), static_cast<int>(2 * p.y));
  }
  EXPECT_EQ(quarters.size(), 4u) << "eight samples of 64 are in all quarters of the pixel";
}

}  // namespace
}  // namespace asos::test::pixel_samples_test
