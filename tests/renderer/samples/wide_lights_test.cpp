#include "tests/support/true_light.h"

#include <gtest/gtest.h>

// Highlights of lights that are wider than the lobe, by samples that look at several of their
// places and directions and send one ray for all.

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

}  // namespace
}  // namespace asos::test::wide_lights_test
