#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

// Shadows on a surface that is seen through a blended one.

namespace asos::test::seen_through_shadow_test {
namespace {

constexpr int side = 24;
constexpr double view_height = 2.0;

// The card's edge, half a unit in front of the wall, outside the view.
constexpr double edge_below = 1.05, edge_above = 1.65;  // x at y = -2 and y = 2

/// A wall behind a wide pane of black glass; an opaque card between them, outside the view.
World wall_behind_a_pane() {
  World world;
  add_quad(world, {-9, -9, -1}, {18, 0, 0}, {0, 18, 0}, matte(glm::vec3(0.8f)));
  Material pane = unlit(glm::vec3(0.0f), 0.25f);
  pane.alpha_mode = AlphaMode::blend;
  pane.double_sided = true;
  add_quad(world, {-9.31f, -9, 0}, {18, 0, 0}, {0, 18, 0}, pane);
  Material card = matte(glm::vec3(0.5f));
  card.double_sided = true;
  const auto below = static_cast<float>(edge_below), above = static_cast<float>(edge_above);
  add_triangle(world, {below, -2, -0.5f}, {6, -2, -0.5f}, {above, 2, -0.5f}, card);
  add_triangle(world, {6, -2, -0.5f}, {6, 2, -0.5f}, {above, 2, -0.5f}, card);
  return world;
}

Film film_of(const RenderScene& scene, Method method) {
  RenderSettings settings = make_settings(side, side, method, 1024);
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return render_picture(scene, orthographic(view_height), settings).film;
}

// Light at 45 degrees: the edge of the shadow is shifted by half a unit.
TEST(SeenThroughShadow, OfAHardLightIsExact) {
  Light light = distant_light();
  light.direction = glm::normalize(glm::dvec3(-1.0, 0.0, -1.0));
  const auto scene = make_render_scene(wall_behind_a_pane(), {light});
  const Film film = film_of(*scene, Method::asos);
  const float lit = film.radiance[side / 2 * side].x;
  ASSERT_GT(lit, 0.1f);
  int crossed = 0;
  const double pixel = view_height / side;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      double share = 0.0;
      constexpr int steps = 64;
      for (int i = 0; i < steps; ++i) {
        const double at = 0.5 * view_height - (y + (i + 0.5) / steps) * pixel;
        const double edge = edge_below + (edge_above - edge_below) * (at + 2.0) / 4.0 - 0.5;
        share += std::clamp((edge + 0.5 * view_height) / pixel - x, 0.0, 1.0) / steps;
      }
      crossed += share > 0.02 && share < 0.98;
      EXPECT_NEAR(film.radiance[static_cast<std::size_t>(y * side + x)].x, lit * share, 0.002 * lit)
          << x << ',' << y;
    }
  }
  EXPECT_GE(crossed, side);
}

TEST(SeenThroughShadow, OfALightWithASizeIsAsManySamplesFindIt) {
  Light light = rectangle_light();
  light.position = {3.0, 0.0, 2.0};
  light.direction = glm::normalize(glm::dvec3(-1.0, 0.0, -1.0));
  light.half_u = {0.0, 0.05, 0.0};
  light.half_v = {0.04, 0.0, -0.04};
  light.intensity = 2000.0f;
  light.color = glm::vec3(1.0f);
  const auto scene = make_render_scene(wall_behind_a_pane(), {light});
  const Film asos = film_of(*scene, Method::asos);
  const Film truth = film_of(*scene, Method::sobol);
  double square = 0.0, brightest = 0.0;
  for (std::size_t i = 0; i < truth.radiance.size(); ++i) {
    const auto expected = static_cast<double>(truth.radiance[i].x);
    const double off = static_cast<double>(asos.radiance[i].x) - expected;
    square += off * off;
    brightest = std::max(brightest, expected);
  }
  ASSERT_GT(brightest, 0.1);
  EXPECT_LT(std::sqrt(square / static_cast<double>(truth.radiance.size())), 0.004 * brightest);
}

}  // namespace
}  // namespace asos::test::seen_through_shadow_test
