#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

// What a mirror shows dimly is looked at by some samples only, which count for all.

namespace asos::test::sampled_reflections_test {
namespace {

constexpr float wall = 4.0f;

/// A black mirror that reflects so much, looked at straight on, before a wall of even radiance
/// behind the camera.
Picture mirror_of(float reflected, int seed) {
  World world;
  Material metal = matte(glm::vec3(reflected));
  metal.metallic = 1.0f;
  metal.roughness = 0.0f;
  add_quad(world, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, metal);
  Material bright = matte(glm::vec3(wall));
  bright.unlit = bright.double_sided = true;
  add_quad(world, {-9, -9, 30}, {18, 0, 0}, {0, 18, 0}, bright);
  RenderSettings settings;
  settings.width = settings.height = 16;
  settings.method = Method::sobol;
  settings.sampling.spp = 64;
  settings.seed = seed;
  return render_picture(*make_render_scene(std::move(world)), orthographic(4.0), settings);
}

struct Seen {
  double rays = 0.0;   // of reflections, for each from the eye
  double mean = 0.0;   // radiance
  double error = 0.0;  // of a pixel, root of the mean square
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
  // A quarter of the samples, for each counts by a 128th of white instead of a 32nd.
  const Seen seen = seen_of(1.0f / 128.0f);
  EXPECT_NEAR(seen.rays, 0.25, 0.01);
  EXPECT_NEAR(seen.mean, static_cast<double>(wall) / 128.0,
              0.01 * static_cast<double>(wall) / 128.0);
  // Independent choices would leave sqrt(3 / 64) of it; those of a sequence leave less.
  EXPECT_LT(seen.error, std::sqrt(3.0 / 64.0) * static_cast<double>(wall) / 128.0);
  EXPECT_GT(seen.error, 0.0);
}

}  // namespace
}  // namespace asos::test::sampled_reflections_test
