#include "tests/support/true_light.h"

#include <gtest/gtest.h>

// Pictures of coated and sheeny surfaces against the rendering equation, pixel by pixel: by ASOS,
// and by samples.

namespace asos::test::layered_light_test {
namespace {

using namespace true_light;

Reflector coated(double metallic, double coat_roughness) {
  return {{0.9, 0.6, 0.3}, metallic, 0.7, 1.0, coat_roughness};
}
Reflector sheeny(double roughness) {
  return {{0.4, 0.1, 0.05}, 0.0, 0.8, 0.0, 0.0, {0.9, 0.3, 0.6}, roughness};
}

/// RMSE in display intensity of what ASOS and Sobol points show.
void expect_true(Subject subject, const Reflector& reflector, double asos, double sobol) {
  for (const char* kind : {"rectangle", "ball", "line", "sun"}) {
    const Light light = light_of(kind);
    const auto exact = truth(subject, reflector, prepare_light(light), 2);
    const auto scene = make_render_scene(world_of(subject, reflector), {light});
    for (const Method method : {Method::asos, Method::sobol}) {
      RenderSettings settings = true_light::settings_for(method);
      settings.asos.max_level = 4;
      settings.sampling.spp = 64;
      const Picture picture = render_picture(*scene, camera_for(subject), settings);
      const Errors e = errors_of(picture.film, exact);
      EXPECT_GT(e.mean, 1e-3);
      EXPECT_LT(e.rmse * e.mean, method == Method::asos ? asos : sobol)
          << kind << (method == Method::asos ? " asos" : " sobol") << ", bias " << e.bias
          << ", mean " << e.mean;
    }
  }
}

TEST(LayeredLight, OnACoatedSphere) {
  expect_true(Subject::sphere, coated(0.0, 0.3), 2e-3, 0.01);
}

TEST(LayeredLight, OnACoatedMetalPlane) {
  expect_true(Subject::plane, coated(1.0, 0.45), 2e-3, 0.01);
}

TEST(LayeredLight, OnASheenySphere) {
  expect_true(Subject::sphere, sheeny(0.5), 2e-3, 0.01);
}

TEST(LayeredLight, OnASheenyPlane) {
  expect_true(Subject::plane, sheeny(0.3), 2e-3, 0.01);
}

}  // namespace
}  // namespace asos::test::layered_light_test
