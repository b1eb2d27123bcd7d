#include "renderer/samples/wide_lights.h"

#include "tests/support/true_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

// Highlights of lights wider than the lobe: samples evaluate several points and directions and send
// one ray for all.

namespace asos::test::wide_lights_test {
namespace {

using namespace true_light;

const Reflector metal{{0.9, 0.6, 0.3}, 1.0, 0.38};

Errors errors_of_samples(const std::string& kind, int samples, int seed) {
  const Light light = light_of(kind);
  const auto exact = truth(Subject::plane, metal, prepare_light(light), 2);
  const auto scene = make_render_scene(world_of(Subject::plane, metal), {light});
  RenderSettings settings = settings_for(Method::sobol);
  settings.sampling.spp = samples;
  settings.seed = seed;
  return errors_of(render_picture(*scene, camera_for(Subject::plane), settings).film, exact);
}

TEST(WideLights, HaveTheRenderingEquationsMean) {
  for (const char* kind : {"rectangle", "disk", "ball", "polygon"}) {
    const Errors e = errors_of_samples(kind, 1024, 3);
    EXPECT_LT(std::abs(e.bias), 4e-4) << kind;
    EXPECT_LT(e.rmse, 0.005) << kind;
    testing::Test::RecordProperty(
        kind, testing::PrintToString(e.rmse) + " bias " + testing::PrintToString(e.bias));
  }
}

TEST(WideLights, HaveLittleNoise) {
  const Errors e = errors_of_samples("rectangle", 4, 1);
  testing::Test::RecordProperty("rmse", testing::PrintToString(e.rmse));
  EXPECT_LT(e.rmse, 0.3);
}

// Each point keeps one of its nine rays, for a quarter of the light of all nine. The number of
// points that keep a ray is proportional to its light.
TEST(OnePicked, KeepsTheTotalAndPicksInProportion) {
  constexpr std::size_t rays_a_point = 9, points = 128;
  const auto carried_by = [](std::size_t ray) { return static_cast<float>(ray % 5 + 1) / 6.0f; };
  std::vector<ShadowRayBatch> rays(rays_a_point);
  double all = 0.0;
  for (std::size_t ray = 0; ray < rays_a_point; ++ray) {
    rays[ray].count = points;
    for (std::size_t i = 0; i < points; ++i) {
      rays[ray].point[i] = static_cast<std::uint32_t>(i);
      for (auto& channel : rays[ray].carried) channel[i] = carried_by(ray);
      rays[ray].t_far[i] = static_cast<float>(ray);
    }
    all += static_cast<double>(carried_by(ray));
  }
  const auto at = std::make_unique<LightPointBatch>();
  for (std::size_t i = 0; i < points; ++i)
    at->u[i] = static_cast<std::uint32_t>((i << 32) / points);
  const auto kept = std::make_unique<ShadowRayBatch>();
  std::vector<float> scratch;
  pick_one(points, rays, at->u, 0.25f, scratch, *kept);

  ASSERT_EQ(kept->count, points);
  std::vector<int> from(rays_a_point, 0), of(points, 0);
  for (std::size_t i = 0; i < kept->count; ++i) {
    EXPECT_NEAR(static_cast<double>(kept->carried[2][i]), 0.25 * all, 1e-5);
    ++from[static_cast<std::size_t>(kept->t_far[i])];
    ++of[kept->point[i]];
  }
  EXPECT_EQ(*std::min_element(of.begin(), of.end()), 1);
  for (std::size_t ray = 0; ray < rays_a_point; ++ray)
    EXPECT_NEAR(from[ray], static_cast<double>(carried_by(ray)) / all * points, 1.0) << ray;
}

}  // namespace
}  // namespace asos::test::wide_lights_test
