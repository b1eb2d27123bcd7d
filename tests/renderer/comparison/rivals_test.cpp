#include "tests/renderer/comparison/rival_scenes.h"
#include "tests/support/make_light.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

// Properties that all adaptive methods except ASOS share.

namespace asos::test::rivals_test {
namespace {

constexpr std::array rivals{Method::sobol_adaptive, Method::whitted, Method::mitchell,
                            Method::ray_bound, Method::average};

std::shared_ptr<const RenderScene> lit_still_life() {
  FlattenedScene still = still_life();
  still.lights.push_back(make_bulb({1, 3, 2}, 20.0f, 0.3));
  return make_render_scene(std::move(still));
}

const Camera& camera() {
  static const Camera c = look_at({2, 2, 5}, {0, 0.7, 0}, 0.7);
  return c;
}

TEST(Rivals, StopWhenAsked) {
  const auto scene = lit_still_life();
  const View view(camera(), 32, 32);
  std::stop_source stop;
  stop.request_stop();
  for (const Method method : rivals) {
    RenderSettings settings = settings_for(method, 65536, 32);
    settings.sampling.depth = 8;
    settings.sampling.contrast = settings.sampling.contrast_scale = 0.0;
    const PixelRect block{0, 0, block_side(settings), block_side(settings)};
    const BlockResult r = render_block(*scene, view, settings, block, stop.get_token());
    EXPECT_LT(r.statistics.eye_rays, 1200u) << row_of(method).name;
  }
}

TEST(Rivals, CountShadowRaysByLightAndTellNoCause) {
  const auto scene = lit_still_life();
  for (const Method method : rivals) {
    SCOPED_TRACE(row_of(method).name);
    const Picture picture = render_picture(*scene, camera(), settings_for(method, 9, 24));
    const RenderStatistics& counts = picture.statistics;
    EXPECT_GT(counts.of_light(0).shadow_rays, 0u);
    EXPECT_GT(counts.of_light(1).shadow_rays, 0u);
    EXPECT_EQ(counts.of_light(0).shadow_rays + counts.of_light(1).shadow_rays, counts.shadow_rays);
    // A sample tests at most one point of each light.
    EXPECT_LE(counts.of_light(1).shadow_rays, counts.eye_rays);
    EXPECT_EQ(counts.rejected_samples, 0u);
    for (const SplitCause cause : picture.film.cause) EXPECT_EQ(cause, SplitCause::none);
  }
}

TEST(Rivals, LeaveOutAndCountWhatIsNotFinite) {
  // Red is NaN right of the centre.
  World world = two_colours(4.0f, glm::vec3(1), glm::vec3(1));
  world.colors.assign(8, glm::vec4(1));
  for (std::size_t i = 4; i < 8; ++i) world.colors[i].r = std::numeric_limits<float>::quiet_NaN();
  const auto scene = make_render_scene(std::move(world));
  for (const Method method : rivals) {
    SCOPED_TRACE(row_of(method).name);
    const BlockResult r = render_small(*scene, settings_for(method));
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        if (x == 4 && (method == Method::whitted || method == Method::average)) continue;
        EXPECT_EQ(red_at(r, x, y), x < 4 ? 1.0f : 0.0f) << x;
      }
    }
    EXPECT_GE(r.statistics.rejected_samples, 32u);
  }
}

/// Error against `sobol` with so many samples that its noise is negligible.
double rms_error(const RenderScene& scene, RenderSettings settings) {
  settings.width = settings.height = 24;
  const Picture picture = render_picture(scene, camera(), settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 1024;
  settings.seed = 1;
  const Picture reference = render_picture(scene, camera(), settings);
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.film.radiance.size(); ++i) {
    const glm::dvec3 d(picture.film.radiance[i] - reference.film.radiance[i]);
    sum += glm::dot(d, d) / (3.0 * static_cast<double>(picture.film.radiance.size()));
  }
  return std::sqrt(sum);
}

TEST(Rivals, ErrFarLessWithMoreSamples) {
  const auto scene = make_render_scene(still_life());
  RenderSettings coarse = settings_for(Method::whitted), fine = coarse;
  coarse.sampling.depth = 0;
  fine.sampling.depth = 5;
  fine.sampling.contrast = 0.0;
  EXPECT_LT(rms_error(*scene, fine), 0.25 * rms_error(*scene, coarse));
  coarse = settings_for(Method::mitchell, 4);
  fine = settings_for(Method::mitchell, 256);
  EXPECT_LT(rms_error(*scene, fine), 0.5 * rms_error(*scene, coarse));
  coarse = settings_for(Method::ray_bound, 1);
  fine = settings_for(Method::ray_bound, 256);
  EXPECT_LT(rms_error(*scene, fine), 0.75 * rms_error(*scene, coarse));
  coarse = fine = settings_for(Method::sobol_adaptive);
  coarse.asos.eps = 1.0;
  fine.asos.eps = 1.0 / 256.0;
  EXPECT_LT(rms_error(*scene, fine), 0.5 * rms_error(*scene, coarse));
}

TEST(Rivals, SettingsOutOfRangeAreNamed) {
  const auto refused = [](auto change, const std::string& subject) {
    RenderSettings s;
    change(s);
    const auto result = validated(s);
    ASSERT_FALSE(result.has_value()) << subject;
    EXPECT_EQ(result.error().subject, subject);
    EXPECT_FALSE(result.error().reason.empty());
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](RenderSettings& s) { s.sampling.depth = -1; }, "depth");
  refused([](RenderSettings& s) { s.sampling.depth = 9; }, "depth");
  refused([](RenderSettings& s) { s.sampling.contrast = nan; }, "contrast");
  refused([](RenderSettings& s) { s.sampling.contrast = 1.01; }, "contrast");
  refused([](RenderSettings& s) { s.sampling.contrast_scale = -0.1; }, "contrast-scale");
  refused([](RenderSettings& s) { s.sampling.contrast_scale = 4.1; }, "contrast-scale");
  RenderSettings edges{.sampling = {.contrast = 1.0, .depth = 8, .contrast_scale = 0.0}};
  EXPECT_TRUE(validated(edges).has_value());
}

}  // namespace
}  // namespace asos::test::rivals_test
