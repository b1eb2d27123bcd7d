#include "renderer/samples/sampled_reflections.h"

#include "renderer/samples/sobol_sampler.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

// Dim reflections are traced for some of the samples, with increased weight.

namespace asos::test::sampled_reflections_test {
namespace {

constexpr float wall = 4.0f;

/// A mirror with this reflectance, seen at right angles, opposite a wall of constant radiance.
Picture mirror_of(float reflected, int seed) {
  World world;
  Material metal = matte(glm::vec3(reflected));
  metal.metallic = 1.0f;
  metal.roughness = 0.0f;
  add_quad(world, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, metal);
  Material bright = matte(glm::vec3(wall));
  bright.unlit = bright.double_sided = true;
  add_quad(world, {-9, -9, 30}, {18, 0, 0}, {0, 18, 0}, bright);
  RenderSettings settings = make_settings(16, 16, Method::sobol, 64);
  settings.seed = seed;
  return render_picture(*make_render_scene(std::move(world)), orthographic(4.0), settings);
}

struct Seen {
  double rays = 0.0;   // reflection rays per eye ray
  double mean = 0.0;   // radiance
  double error = 0.0;  // RMS error of a pixel
};

Seen seen_of(float reflected) {
  const Picture picture = mirror_of(reflected, 5);
  Seen seen;
  seen.rays = static_cast<double>(picture.statistics.reflection_rays) /
              static_cast<double>(picture.statistics.eye_rays);
  double squares = 0.0;
  for (const glm::vec3& pixel : picture.film.radiance) {
    seen.mean += static_cast<double>(pixel.x);
    const double off = static_cast<double>(pixel.x - wall * reflected);
    squares += off * off;
  }
  const auto pixels = static_cast<double>(picture.film.radiance.size());
  seen.mean /= pixels;
  seen.error = std::sqrt(squares / pixels);
  return seen;
}

TEST(SampledReflections, AreAllFollowedWhereTheyShow) {
  const Seen seen = seen_of(1.0f / 16.0f);
  EXPECT_EQ(seen.rays, 1.0);
  EXPECT_NEAR(seen.mean, static_cast<double>(wall) / 16.0, 1e-6);
  EXPECT_LT(seen.error, 1e-6);
}

TEST(SampledReflections, ThatAreDimAreFollowedBySomeSamplesForAll) {
  // A quarter of the samples: the reflection has 1/128 of white instead of 1/32.
  const Seen seen = seen_of(1.0f / 128.0f);
  EXPECT_NEAR(seen.rays, 0.25, 0.01);
  EXPECT_NEAR(seen.mean, static_cast<double>(wall) / 128.0,
              0.01 * static_cast<double>(wall) / 128.0);
  // Independent selection would have an error of sqrt(3 / 64) of the mean; a sequence has less.
  EXPECT_LT(seen.error, std::sqrt(3.0 / 64.0) * static_cast<double>(wall) / 128.0);
  EXPECT_GT(seen.error, 0.0);
}

/// A pane in front of the viewer.
World pane() {
  World world;
  Material glass = matte(glm::vec3(0.5f));
  glass.alpha_mode = AlphaMode::blend;
  add_quad(world, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, glass);
  return world;
}

TEST(SampledReflections, GoOnBehindTransparentSurfaces) {
  const auto scene = make_render_scene(pane());
  const RenderSettings settings = make_settings(16, 16);
  const View view(orthographic(4.0), 16, 16);
  const Shader shader = shader_of(*scene, settings, view);
  SobolSampler places(1);
  SampledReflections rays(scene->world(), places);
  const Ray ray = view.ray(8.5, 8.5);
  const Hit hit = scene->rays().closest(ray);
  ViewedRay seen = shader.eye_ray(ray, hit, 0.5f);
  seen.bounces = 3;
  seen.passage.refractions = 2;
  const SurfacePoint point =
      surface_point(scene->world(), scene->render_features, hit, -ray.direction);
  VolumePath inside;
  inside.refractions = 3;
  RenderStatistics counts;
  const auto pass = [&](glm::vec3 left) {
    rays.pass(seen, point, {left, false, inside}, PointSample{}, glm::vec3(2.0f), shader, counts);
    return rays.take();
  };
  EXPECT_TRUE(pass(glm::vec3(1e-6f)).empty()) << "the rest is invisible";
  const std::vector<ReflectedSample> next = pass({0.5f, 0.25f, 0.125f});
  ASSERT_EQ(next.size(), 1u);
  const ViewedRay rest = next[0].viewed({});
  EXPECT_EQ(next[0].weight, glm::vec3(1.0f, 0.5f, 0.25f));
  EXPECT_TRUE(next[0].passes());
  EXPECT_GT(rest.ray.t_near, hit.t);
  EXPECT_EQ(rest.start(), hit.t);
  EXPECT_EQ(rest.bounces, 3);
  EXPECT_TRUE(rest.reflected()) << "a straight way is no refraction";
  EXPECT_EQ(rest.throughput, 0.5f);
  EXPECT_EQ(rest.passed.left, 0.5f);
  EXPECT_EQ(rest.passed.count.layers(), 1);
}

}  // namespace
}  // namespace asos::test::sampled_reflections_test
