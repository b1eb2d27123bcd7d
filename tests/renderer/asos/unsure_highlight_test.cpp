#include "renderer/gltf/load.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/shared_dir.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// The highlight of a partially occluded light is sampled, and counted exactly once.

namespace asos::test::unsure_highlight_test {
namespace {

double mean_of(const Film& film) {
  double sum = 0.0;
  for (const glm::vec3& pixel : film.radiance) sum += static_cast<double>(pixel.y);
  return sum / static_cast<double>(film.radiance.size());
}

/// A panel behind and above the floor's centre, tilted towards it.
Light panel_of(float intensity) {
  Light panel;
  panel.type = Light::Type::rectangle;
  panel.position = {0, 2.5, -2.5};
  panel.direction = glm::normalize(glm::dvec3(0, -1, 0.6));
  panel.half_u = {0.8, 0, 0};
  panel.half_v = 0.4 * glm::normalize(glm::cross(panel.direction, panel.half_u));
  panel.intensity = intensity;
  return panel;
}

TEST(UnsureHighlight, CountsSkyLightOnce) {
  // A glossy floor under a panel that a board half covers.
  World world;
  Material floor = matte(glm::vec3(0.4f));
  floor.roughness = 0.3f;
  floor.specular = 1.0f;
  add_quad(world, {-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, floor);
  add_quad(world, {-0.2f, 1.0f, -2.5f}, {3, 0, 0}, {0, 0, 2.0f}, matte(glm::vec3(0.1f)));
  const Light panel = panel_of(6.0f);
  const auto scene = make_render_scene(std::move(world), {panel});
  RenderSettings settings = make_settings(32, 32);
  settings.shadow.sky = true;
  const Camera camera = look_at({0, 1.2, 2.5}, {0, 0, -0.6}, 0.7);
  const Picture asos = render_picture(*scene, camera, settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 256;
  const Picture truth = render_picture(*scene, camera, settings);
  ASSERT_GT(asos.statistics.sky_rays, 0u);
  EXPECT_NEAR(mean_of(asos.film), mean_of(truth.film), 5e-4);
}

// A bar hides 1/25 of a panel, but all of the part that the glossy floor reflects in the picture's
// centre. A highlight has the visibility of that part, not the light's mean visibility.
TEST(UnsureHighlight, IsHiddenWithItsPartOfTheLight) {
  World world;
  Material floor = matte(glm::vec3(0.2f));
  floor.roughness = 0.08f;
  add_quad(world, {-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, floor);
  const Light panel = panel_of(2.0f);
  const glm::vec3 along(2.2 * panel.half_v);
  const glm::vec3 middle(panel.position + 0.1 * panel.direction);
  Material dark = matte(glm::vec3(0.0f));
  dark.double_sided = true;
  add_quad(world, middle - 0.5f * along - glm::vec3(0.03f, 0, 0), {0.06f, 0, 0}, along, dark);
  const auto scene = make_render_scene(std::move(world), {panel});
  RenderSettings settings = make_settings(24, 24);
  settings.mirror.bounces = 0;
  const Camera camera = look_at({0, 1.2, 2.5}, {0, 0, 0.88}, 0.1);
  const Picture asos = render_picture(*scene, camera, settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 4096;
  const Picture truth = render_picture(*scene, camera, settings);
  // Means of columns, which run along the bar.
  double most = 0.0, darkest = 1.0, brightest = 0.0;
  for (int x = 0; x < settings.width; ++x) {
    double expected = 0.0, found = 0.0;
    for (int y = 0; y < settings.height; ++y) {
      expected += static_cast<double>(truth.film.radiance[truth.film.index(x, y)].y);
      found += static_cast<double>(asos.film.radiance[asos.film.index(x, y)].y);
    }
    expected /= settings.height, found /= settings.height;
    darkest = std::min(darkest, expected), brightest = std::max(brightest, expected);
    most = std::max(most, std::abs(found - expected));
  }
  ASSERT_GT(brightest - darkest, 8.0 * settings.asos.eps) << "the bar is mirrored";
  EXPECT_LT(most, 0.75 * settings.asos.eps) << darkest << " to " << brightest;
}

// Arrows whose heads occlude most of a panel for their shafts. The first few samples may all miss
// the panel's visible rest, and then agree on darkness.
TEST(UnsureHighlight, IsFoundEvenIfFirstSamplesMissIt) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << "no models: set ASOS_SHARED to a folder with scenes/";
  const auto loaded = load_scene(*shared / "scenes/OrientationTest/OrientationTest.glb");
  ASSERT_TRUE(loaded) << loaded.error().message();
  const auto scene = prepare(*loaded);
  ASSERT_TRUE(scene) << scene.error().message();
  const Camera camera = first_camera((*scene)->world(), 16.0 / 9.0);
  RenderSettings settings = make_settings(320, 180);
  settings.crop = {222, 76, 10, 18};
  const auto red = [&](Method method, int seed) {
    settings.method = method;
    settings.sampling.spp = 1024;
    settings.seed = seed;
    const Film film = render_picture(**scene, camera, settings).film;
    std::vector<float> pixels;
    for (int y = settings.crop.y; y < settings.crop.y + settings.crop.height; ++y)
      for (int x = settings.crop.x; x < settings.crop.x + settings.crop.width; ++x)
        pixels.push_back(std::min(1.0f, film.radiance[film.index(x, y)].x));
    return pixels;
  };
  const std::vector<float> truth = red(Method::sobol, 0);
  EXPECT_GT(std::count_if(truth.begin(), truth.end(), [](float r) { return r > 0.2f; }), 30);
  constexpr int seeds = 6;
  int dark = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    const std::vector<float> found = red(Method::asos, seed);
    for (std::size_t i = 0; i < truth.size(); ++i) dark += found[i] < truth[i] - 0.03f;
  }
  EXPECT_LE(dark, 2 * seeds);
  RecordProperty("dark", dark);
}

}  // namespace
}  // namespace asos::test::unsure_highlight_test
