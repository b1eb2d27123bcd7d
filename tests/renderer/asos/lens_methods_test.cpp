#include "tests/renderer/asos/lens_scenes.h"
#include "tests/support/make_light.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

// Depth of field in a lit scene: all methods give the same picture.

namespace asos::test::lens_test {
namespace {

/// A lit floor below the view, with spheres from near to far in front of a wall.
std::shared_ptr<const RenderScene> lit_scene() {
  World world;
  add_quad(world, {-10, -0.3f, 0}, {20, 0, 0}, {0, 0, -12}, matte(glm::vec3(0.7f)));
  add_quad(world, {-10, -0.3f, -12}, {20, 0, 0}, {0, 12, 0}, matte({0.3f, 0.5f, 0.7f}));
  add_sphere(world, {-0.1f, -0.05f, -2}, 0.06f, 24, matte({0.9f, 0.2f, 0.1f}));
  add_sphere(world, {0.15f, 0, -4}, 0.15f, 24, matte({0.2f, 0.8f, 0.1f}));
  const Light light = make_bulb({2, 5, 1}, 120.0f);
  return make_render_scene(std::move(world), {light});
}

TEST(Lens, MethodsAgreeInALitScene) {
  const auto scene = lit_scene();
  const Camera camera = camera_with(radius_for(1.5, 2.0), 6);
  const std::vector<double> reference =
      reds(render_picture(*scene, camera, settings_of(Method::sobol)));
  for (const Method method : {Method::asos, Method::sobol_adaptive, Method::stochastic,
                              Method::uniform, Method::mitchell, Method::ray_bound}) {
    RenderSettings settings = settings_of(method, 1e-3);
    settings.sampling.spp = 1024;
    settings.sampling.contrast_scale = 0.0;
    settings.asos.max_level = 4;
    EXPECT_LT(rmse(reds(render_picture(*scene, camera, settings)), reference), 3e-3)
        << row_of(method).name;
  }
}

/// Mean of rows 1 to side - 2, after smoothing with weights 1 2 1 in both directions.
double mean_of_smoothed(const std::vector<double>& values) {
  constexpr double weights[] = {0.25, 0.5, 0.25};
  double sum = 0.0;
  for (int y = 1; y < side - 1; ++y)
    for (int x = 1; x < side - 1; ++x)
      for (int k = 0; k < 9; ++k)
        sum += weights[k % 3] * weights[k / 3] *
               values[static_cast<std::size_t>((y + k / 3 - 1) * side + x + k % 3 - 1)];
  return sum / ((side - 2) * (side - 2));
}

double mean_inside(const std::vector<double>& values) {
  double sum = 0.0;
  for (int y = 1; y < side - 1; ++y)
    for (int x = 1; x < side - 1; ++x) sum += values[static_cast<std::size_t>(y * side + x)];
  return sum / ((side - 2) * (side - 2));
}

// These methods take few samples per pixel, so only means over many pictures can be compared.
TEST(Lens, MethodsOfFewSamplesAgreeOnTheMean) {
  const auto scene = lit_scene();
  const Camera camera = camera_with(radius_for(1.5, 2.0), 6);
  const std::vector<double> reference =
      reds(render_picture(*scene, camera, settings_of(Method::sobol)));
  for (const Method method : {Method::whitted, Method::average}) {
    double mean = 0.0;
    constexpr int seeds = 32;
    for (int seed = 0; seed < seeds; ++seed) {
      RenderSettings settings = settings_of(method, 1e-3);
      settings.seed = seed;
      settings.sampling.contrast = 0.0;  // whitted: no bias from choosing pixels to split
      mean += mean_inside(reds(render_picture(*scene, camera, settings))) / seeds;
    }
    const double expected =
        method == Method::average ? mean_of_smoothed(reference) : mean_inside(reference);
    EXPECT_NEAR(mean / expected, 1.0, 0.02) << row_of(method).name;
  }
}

TEST(Lens, EvenSurfacesOutOfFocusTakeOneLeaf) {
  const auto scene = lit_scene();
  const Picture picture = render_picture(*scene, camera_with(radius_for(1.0, 2.0)),
                                         settings_of(Method::asos, 1.0 / 256.0));
  int smooth = 0;
  for (const SplitCause cause : picture.film.cause) smooth += cause == SplitCause::none;
  EXPECT_GT(smooth, side * side / 3);
}

TEST(Lens, ApertureOfZeroChangesNoBit) {
  const auto scene = lit_scene();
  Camera pinhole = camera_with(0.0);
  pinhole.lens = {};
  for (const Method method : {Method::asos, Method::sobol, Method::sobol_adaptive}) {
    RenderSettings settings = settings_of(method, 1.0 / 256.0);
    settings.sampling.spp = 16;
    const Picture a = render_picture(*scene, pinhole, settings);
    const Picture b = render_picture(*scene, camera_with(0.0, 5), settings);
    EXPECT_EQ(a.film.radiance, b.film.radiance);
    EXPECT_EQ(a.statistics.rays(), b.statistics.rays());
  }
}

TEST(Lens, FocusIsOnTheMiddleUnlessGiven) {
  const auto scene = lit_scene();
  Camera camera = camera_with(0.1);
  camera.lens.focus.reset();
  const RenderSettings settings = settings_of(Method::asos);
  // The centre shows a sphere's silhouette or the wall.
  const Camera found = viewed_camera(*scene, camera, settings);
  ASSERT_TRUE(found.lens.focus);
  const View view(found, side, side);
  const Ray ray = view.ray(0.5 * side, 0.5 * side);
  EXPECT_NEAR(*found.lens.focus, view.depth(ray, scene->rays().closest(ray, Culling{}).t), 1e-4);
  camera.lens.focus = 7.5;
  EXPECT_EQ(viewed_camera(*scene, camera, settings).lens.focus, 7.5);
  RenderSettings beam = settings;
  beam.method = Method::beam;
  EXPECT_FALSE(viewed_camera(*scene, camera, beam).lens.blurs());
}

}  // namespace
}  // namespace asos::test::lens_test
