#include "renderer/shading/environment.h"
#include "renderer/shading/sky.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asos::test::sky_picture_test {
namespace {

constexpr int sky_side = 16;

/// Waves of about 12 degrees and 3 degrees, which pixels of 4 degrees average.
std::shared_ptr<const Sky> wavy_sky() {
  constexpr int height = 256;
  std::vector<glm::vec3> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < 2 * height; ++x)
      texels.emplace_back(0.5f + 0.2f * std::sin(0.37f * static_cast<float>(x)),
                          0.5f + 0.2f * std::sin(1.6f * static_cast<float>(x + y)), 0.5f);
  return std::make_shared<const Sky>(SkyMap(2 * height, height, std::move(texels)), 0.0, "waves");
}

World speck() {
  World world;
  add_quad(world, {-0.001f, -0.001f, 50}, {0.002f, 0, 0}, {0, 0.002f, 0}, unlit(glm::vec3(1)));
  return world;
}

RenderSettings under(std::shared_ptr<const Sky> sky, Method method, int spp = 1) {
  RenderSettings settings = make_settings(sky_side, sky_side, method, spp);
  settings.sky = std::move(sky);
  return settings;
}

/// A scene without lights would get default lighting.
Light dark_light() {
  return make_sun({0, 1, 0}, 1e-6f);
}

TEST(SkyPicture, BackgroundIsThePixelsMean) {
  const auto scene = make_render_scene(speck());
  // Straight ahead, and straight up, where all columns of the picture meet.
  for (const glm::dvec3 target : {glm::dvec3(0, 0.2, -1), glm::dvec3(0.01, 1, 0.02)}) {
    const Camera camera = look_at({0, 0, 0}, target, 1.0);
    const Film found = render_picture(*scene, camera, under(wavy_sky(), Method::asos)).film;
    RenderSettings dense = under(wavy_sky(), Method::uniform, 256);
    dense.texture.filter = TextureFilter::point;
    const Film expected = render_picture(*scene, camera, dense).film;
    dense.sampling.spp = 1;
    const Film points = render_picture(*scene, camera, dense).film;
    double by_mean = 0.0, by_points = 0.0;
    for (std::size_t i = 0; i < found.radiance.size(); ++i) {
      by_mean += std::pow(glm::distance(found.radiance[i], expected.radiance[i]), 2.0f);
      by_points += std::pow(glm::distance(points.radiance[i], expected.radiance[i]), 2.0f);
    }
    EXPECT_LT(by_mean, by_points / 16.0) << "a quarter of the error of a sample a pixel";
  }
}

TEST(SkyPicture, AGreySkyIsTheNeutralOne) {
  const auto scene = make_render_scene(still_life());
  const Camera camera = look_at({2, 2, 5}, {0, 0.7, 0}, 0.7);
  const Film neutral = render_picture(*scene, camera, under(nullptr, Method::asos)).film;
  const auto grey = std::make_shared<const Sky>(glm::vec3(sky_radiance));
  const Film same = render_picture(*scene, camera, under(grey, Method::asos)).film;
  for (std::size_t i = 0; i < neutral.radiance.size(); ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(neutral.radiance[i][k], same.radiance[i][k],
                  1e-6f + 1e-5f * neutral.radiance[i][k]);
}

TEST(SkyPicture, LightsAMatteFloorByItsClosedForm) {
  World world;
  Material white = matte(glm::vec3(0.5f));
  white.specular = 0.0f;
  add_quad(world, {-9, 0, 9}, {18, 0, 0}, {0, 0, -18}, white);
  const auto scene = make_render_scene(std::move(world), {dark_light()});
  const auto sky = std::make_shared<const Sky>(glm::vec3(2, 1, 0), glm::vec3(0.5f));
  const Camera camera = look_at({0, 3, 0.5}, {0, 0, 0}, 0.3);
  for (const Method method : {Method::asos, Method::sobol}) {
    const Film film = render_picture(*scene, camera, under(sky, method)).film;
    const glm::vec3 c = film.radiance[film.index(8, 8)];
    // Two thirds of the difference between zenith and horizon.
    EXPECT_NEAR(c.r, 0.5f * sky_visibility * 1.5f, 1e-5f);
    EXPECT_NEAR(c.b, 0.5f * sky_visibility * (0.5f - 1.0f / 3.0f), 1e-5f);
  }
}

// Metal just too rough to be followed as a mirror is nearly as bright under an open sky as metal at
// the limit.
TEST(SkyPicture, RoughMetalMatchesMirrorsAtTheLimit) {
  const Camera camera = look_at({0, 3, 0.5}, {0, 0, 0}, 0.3);
  for (const Method method : {Method::asos, Method::sobol}) {
    const auto shown = [&](double roughness) {
      World world;
      Material metal = matte(glm::vec3(1.0f));
      metal.metallic = 1.0f;
      metal.roughness = static_cast<float>(roughness);
      add_quad(world, {-9, 0, 9}, {18, 0, 0}, {0, 0, -18}, metal);
      const auto scene = make_render_scene(std::move(world), {dark_light()});
      const Film film = render_picture(*scene, camera, under(nullptr, method, 16)).film;
      return film.radiance[film.index(8, 8)].r / sky_radiance;
    };
    const float mirror = shown(usual_roughest_mirror), beyond = shown(usual_roughest_mirror + 1e-3);
    EXPECT_NEAR(mirror, 1.0f, 0.02f);
    EXPECT_LT(beyond / mirror, 0.98f) << "either both are followed or neither";
    EXPECT_GT(beyond / mirror, 0.92f);
  }
}

}  // namespace
}  // namespace asos::test::sky_picture_test
