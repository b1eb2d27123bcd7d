#include "tests/renderer/comparison/rival_scenes.h"
#include "tests/support/make_light.h"

#include <gtest/gtest.h>

namespace asos::test::mitchell_test {
namespace {

RenderSettings mitchell(int spp, double scale = 1.0) {
  RenderSettings settings = settings_for(Method::mitchell, spp);
  settings.sampling.contrast_scale = scale;
  return settings;
}

TEST(Mitchell, AFlatPictureCostsFourRaysAPixel) {
  for (const float grey : {0.0f, 0.7f}) {
    const auto scene = make_render_scene(two_colours(12, glm::vec3(grey), glm::vec3(grey)));
    for (const int spp : {4, 16, 256}) {
      const BlockResult r = render_small(*scene, mitchell(spp));
      EXPECT_EQ(r.statistics.eye_rays, 64u * 4u) << spp;
      EXPECT_EQ(r.statistics.split_pixels, 0u);
      EXPECT_EQ(red_at(r, 3, 3), grey);
    }
    EXPECT_EQ(render_small(*scene, mitchell(3)).statistics.eye_rays, 64u * 3u);
    // A scale of 0 disables the contrast test.
    EXPECT_EQ(render_small(*scene, mitchell(16, 0.0)).statistics.eye_rays, 64u * 16u);
  }
}

// Of the sequence's first four points, two are in each half of the pixel, so an edge through its
// centre is always detected. Each column of width 1/256 has one of 256 points.
TEST(Mitchell, EdgesTakeTheHighDensityAndAreExact) {
  for (const int spp : {16, 64, 256}) {
    const auto scene = make_render_scene(two_colours(4.5f, glm::vec3(1), glm::vec3(0)));
    const BlockResult r = render_small(*scene, mitchell(spp));
    EXPECT_EQ(r.statistics.split_pixels, 8u);
    EXPECT_EQ(r.statistics.eye_rays, 56u * 4u + 8u * static_cast<unsigned>(spp));
    for (int y = 0; y < 8; ++y) {
      EXPECT_NEAR(red_at(r, 4, y), 0.5f, 1e-6);
      EXPECT_EQ(r.tile.split_level[static_cast<std::size_t>(8 * y + 4)], 1);
    }
  }
  const auto scene = make_render_scene(two_colours(4.3125f, glm::vec3(1), glm::vec3(0)));
  const BlockResult r = render_small(*scene, mitchell(256));
  for (int y = 0; y < 8; ++y) EXPECT_NEAR(red_at(r, 4, y), 0.3125f, 1e-6);
}

// The contrast of 0.6 and 1.2 is a third. Neutral shows them as 0.56 and 0.9, AgX as 0.46 and
// 0.63: contrasts below the threshold of 0.3.
TEST(Mitchell, ACurveLessensTheContrastThatCounts) {
  const auto scene = make_render_scene(two_colours(4.5f, glm::vec3(0.6f), glm::vec3(1.2f)));
  RenderSettings settings = mitchell(16);
  EXPECT_EQ(render_small(*scene, settings).statistics.split_pixels, 8u);
  for (const ToneCurve curve : {ToneCurve::neutral, ToneCurve::agx}) {
    settings.judged_tone = curve;
    EXPECT_EQ(render_small(*scene, settings).statistics.split_pixels, 0u);
  }
}

TEST(Mitchell, EachChannelHasItsThreshold) {
  const double thresholds[] = {0.4, 0.3, 0.6};
  for (int channel = 0; channel < 3; ++channel) {
    for (const double scale : {1.0, 0.5}) {
      for (const double contrast : {0.98, 1.02}) {
        const double c = contrast * scale * thresholds[channel];
        glm::vec3 left(0.5f), right(0.5f);
        left[channel] = static_cast<float>(0.5 * (1.0 - c));
        right[channel] = static_cast<float>(0.5 * (1.0 + c));
        const auto scene = make_render_scene(two_colours(4.5f, left, right));
        EXPECT_EQ(render_small(*scene, mitchell(9, scale)).statistics.split_pixels,
                  contrast > 1.0 ? 8u : 0u)
            << channel << ' ' << scale << ' ' << contrast;
      }
    }
  }
}

TEST(Mitchell, EqualsSobolAtEitherEnd) {
  FlattenedScene still = still_life();
  still.lights.push_back(make_bulb({1, 3, 2}, 20.0f, 0.5));
  const auto scene = make_render_scene(std::move(still));
  const Camera camera = look_at({2, 2, 5}, {0, 0.7, 0}, 0.7);
  const auto expect_sobol = [&](double scale, int spp) {
    RenderSettings settings = mitchell(9, scale);
    settings.width = settings.height = 20;
    settings.texture.filter = TextureFilter::point;
    settings.seed = 3;
    const Picture found = render_picture(*scene, camera, settings);
    settings.method = Method::sobol;
    settings.sampling.spp = spp;
    const Picture expected = render_picture(*scene, camera, settings);
    EXPECT_EQ(found.statistics.eye_rays, expected.statistics.eye_rays);
    EXPECT_EQ(found.statistics.shadow_rays, expected.statistics.shadow_rays);
    for (std::size_t i = 0; i < found.film.radiance.size(); ++i)
      EXPECT_NEAR(found.film.radiance[i].g, expected.film.radiance[i].g, 1e-5) << i;
  };
  expect_sobol(0.0, 9);
  expect_sobol(4.0, 4);
}

}  // namespace
}  // namespace asos::test::mitchell_test
