#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

// Objects much smaller than a pixel at its centre, where its sample is taken.

namespace asos::test {
namespace {

constexpr float fov = 0.8f;

/// Fraction of a single-pixel picture that a white world covers.
double share_of_pixel(const World& world, const Camera& camera, int max_level) {
  RenderSettings settings = make_settings(1, 1);
  settings.asos.max_level = max_level;
  const auto scene = make_render_scene(world);
  const double background = static_cast<double>(
      render_picture(*make_render_scene(World{}), camera, settings).film.radiance[0].x);
  const auto found =
      static_cast<double>(render_picture(*scene, camera, settings).film.radiance[0].x);
  return (found - background) / (1.0 - background);
}

TEST(Speck, AddsItsAreaOrNothing) {
  World card;
  add_quad(card, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, unlit({1.0f, 1.0f, 1.0f}));
  for (const double distance : {1e2, 1e4, 1e5, 3e5, 1e6, 3e6, 1e7, 1e8, 1e9}) {
    const double height = 2.0 * distance * std::tan(0.5 * static_cast<double>(fov));
    const double area = 4.0 / (height * height);
    for (const int max_level : {1, 3}) {
      const double found =
          share_of_pixel(card, look_at({0, 0, distance}, {0, 0, 0}, fov), max_level);
      EXPECT_NEAR(found, area, 2e-7 + 1e-4 * area) << distance << ' ' << max_level;
    }
  }
}

// More pieces than the limit for separate outlines.
TEST(Speck, OfManyPiecesAddsItsAreaOrNothing) {
  World crowd;
  add_sphere(crowd, {0, 0, 0}, 1.0f, 24, unlit({1.0f, 1.0f, 1.0f}));
  for (int i = 0; i < 200; ++i) {
    const auto turn = static_cast<float>(i);
    add_quad(crowd, glm::vec3(std::cos(turn), std::sin(turn), 1.5f) * 0.5f, {0.1f, 0, 0},
             {0, 0.1f, 0}, unlit({1.0f, 1.0f, 1.0f}));
  }
  for (const double distance : {1e5, 1e6, 1e7, 1e8}) {
    for (const int max_level : {1, 3}) {
      EXPECT_NEAR(share_of_pixel(crowd, look_at({0, 0, distance}, {0, 0, 0}, fov), max_level), 0.0,
                  1e-6)
          << distance << ' ' << max_level;
    }
  }
}

}  // namespace
}  // namespace asos::test
