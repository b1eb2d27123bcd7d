#include "renderer/gltf/load.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// ASOS, which shares results between pixels, against independent samples of the same pictures.

namespace asos::test::light_noise_test {
namespace {

using Means = std::vector<double>;

RenderSettings tiny(Method method) {
  RenderSettings settings = make_settings(24, 16, method);
  settings.asos.max_level = 5;
  settings.asos.eps = 0.0;
  return settings;
}

Means brightness(const Picture& picture) {
  Means means;
  for (const glm::vec3& c : picture.film.radiance)
    means.push_back(static_cast<double>(c.x + c.y + c.z) / 3.0);
  return means;
}

/// Tolerance for ASOS's systematic errors: a leaf, and each light's shadow, is accepted while its
/// error against the mean of its patch is below this (RenderSettings::refine_shading).
constexpr double let_pass = 2.0 / 2048.0;

/// Uses sixteen seeds of sampling, because fewer do not estimate their own standard error well:
/// along silhouettes, the mean of four differed by three of their standard errors. The pooled
/// standard error is a lower limit.
void expect_same_picture(const RenderScene& scene, const Camera& camera, const std::string& name) {
  const Means found = brightness(render_picture(scene, camera, tiny(Method::asos)));
  constexpr int seeds = 16;
  std::vector<Means> runs;
  for (int seed = 0; seed < seeds; ++seed) {
    RenderSettings settings = tiny(Method::sobol);
    settings.sampling.spp = 256;
    settings.seed = seed;
    runs.push_back(brightness(render_picture(scene, camera, settings)));
  }
  double pooled = 0.0, off2 = 0.0, bias = 0.0;
  Means mean(found.size()), error2(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const Means& run : runs) mean[i] += run[i] / seeds;
    for (const Means& run : runs)
      error2[i] += (run[i] - mean[i]) * (run[i] - mean[i]) / (seeds * (seeds - 1));
    pooled += error2[i] / static_cast<double>(found.size());
  }
  int outside = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double off = found[i] - mean[i];
    off2 += off * off / static_cast<double>(found.size());
    bias += off / static_cast<double>(found.size());
    const double allowed = let_pass + 5.0 * std::sqrt(std::max(error2[i], pooled));
    outside += std::abs(off) > allowed;
    EXPECT_LT(std::abs(off), allowed)
        << name << ' ' << i % 24 << ' ' << i / 24 << ' ' << found[i] << " for " << mean[i];
  }
  testing::Test::RecordProperty(name, "rms " + testing::PrintToString(std::sqrt(off2)) + " noise " +
                                          testing::PrintToString(std::sqrt(pooled)) + " bias " +
                                          testing::PrintToString(bias) + " outside " +
                                          std::to_string(outside));
  EXPECT_LT(std::sqrt(off2), let_pass + 2.0 * std::sqrt(pooled)) << name;
  EXPECT_LT(std::abs(bias), 0.5 * let_pass) << name;
}

void expect_boxes(const std::vector<Light>& lights) {
  const Scene boxes = load_scene("builtin:boxes").value();
  for (const Light& light : lights) {
    Scene scene = boxes;
    scene.lights = {scaled(light, 2.0)};
    const auto prepared = prepare(scene).value();
    expect_same_picture(*prepared, prepared->world().cameras.front(), light.name);
  }
}

void expect_builtin(const std::string& name) {
  const auto prepared = prepare(load_scene("builtin:" + name).value()).value();
  std::string property = name;
  std::replace(property.begin(), property.end(), '-', '_');
  expect_same_picture(*prepared, prepared->world().cameras.front(), property);
}

TEST(LightNoise, BoxesLookAsSampled) {
  expect_boxes({point_light(), spot_light(), ball_light(), rectangle_light(), disk_light(),
                polygon_light()});
}

TEST(LightNoise, BoxesUnderADirectionalLightLookAsSampled) {
  expect_boxes({distant_light()});
}

TEST(LightNoise, BoxesUnderALineAndSunsLookAsSampled) {
  expect_boxes({linear_light(), sun_light()});
}

TEST(LightNoise, BoxesUnderCapsuleLookAsSampled) {
  expect_boxes({capsule_light()});
}

TEST(LightNoise, ShapesUnderALineLookAsSampled) {
  expect_builtin("primitives-linear");
}

TEST(LightNoise, ShapesUnderADirectionalLightLookAsSampled) {
  expect_builtin("primitives");
}

TEST(LightNoise, ShapesUnderLargeLightsLookAsSampled) {
  expect_builtin("primitives-ball");
  expect_builtin("primitives-rectangle");
}

}  // namespace
}  // namespace asos::test::light_noise_test
