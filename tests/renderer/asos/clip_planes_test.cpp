#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>

// The camera's near and far planes (glTF 2.0, 3.10.3) clip visible surfaces, but no shadows or
// reflections. The expected areas are closed forms.

namespace asos::test::clip_planes_test {
namespace {

constexpr int side = 24;
const glm::vec3 outer(0.9f, 0.0f, 0.0f), inner(0.0f, 0.0f, 0.7f), back(0.0f, 0.8f, 0.0f);

/// Looks along -z from the origin, 90 degrees wide, or 4 units if orthographic.
Camera camera_of(Camera::Type type) {
  return {.type = type, .fov_y_rad = 0.5 * std::numbers::pi, .height = 4.0};
}

Camera with_planes(Camera camera, std::optional<double> near, std::optional<double> far) {
  camera.near_depth = near;
  camera.far_depth = far;
  return camera;
}

RenderSettings settings_of(Method method) {
  RenderSettings settings = make_settings(side, side, method, 1024);
  settings.asos.max_level = 3;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return settings;
}

glm::dvec3 mean_of(const Picture& picture) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3 c : picture.film.radiance) sum += glm::dvec3(c);
  return sum / static_cast<double>(picture.film.radiance.size());
}

void expect_near(glm::dvec3 seen, glm::dvec3 expected, double tolerance) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], expected[i], tolerance) << "channel " << i;
}

Material card(glm::vec3 colour, float alpha = 1.0f) {
  Material material = unlit(colour, alpha);
  material.double_sided = true;
  return material;
}

/// A box from z = -2 to -5, 2 x 2 wide, around the view's axis: its front has the colour `outer`,
/// its sides `inner` and its end `back`.
World tunnel() {
  World world;
  add_quad(world, {-1, -1, -2}, {2, 0, 0}, {0, 2, 0}, card(outer));
  add_quad(world, {-1, -1, -5}, {2, 0, 0}, {0, 2, 0}, card(back));
  for (const float s : {-1.0f, 1.0f}) {
    add_quad(world, {s, -1, -2}, {0, 2, 0}, {0, 0, -3}, card(inner));
    add_quad(world, {-1, s, -2}, {2, 0, 0}, {0, 0, -3}, card(inner));
  }
  return world;
}

/// Projected areas of the tunnel if the near plane clips its front at depth `near`: its section and
/// its end are squares.
glm::dvec3 tunnel_from(double near) {
  const double whole = 1.0 / (near * near), end = 1.0 / 25.0;
  return (whole - end) * glm::dvec3(inner) + end * glm::dvec3(back);
}

TEST(ClipPlanes, NearPlaneOpensABoxInPerspective) {
  const auto scene = make_render_scene(tunnel());
  const Camera all = camera_of(Camera::Type::perspective);
  for (const double near : {2.5, 3.0, 4.1}) {
    const Camera camera = with_planes(all, near, {});
    for (const Method method : {Method::asos, Method::beam}) {
      const Picture picture = render_picture(*scene, camera, settings_of(method));
      expect_near(mean_of(picture), tunnel_from(near), 1e-4);
      EXPECT_EQ(picture.statistics.missed_splits, 0u);
    }
    for (const Method method : {Method::sobol, Method::whitted})
      expect_near(mean_of(render_picture(*scene, camera, settings_of(method))), tunnel_from(near),
                  2e-3);
  }
  expect_near(mean_of(render_picture(*scene, all, settings_of(Method::asos))),
              0.25 * glm::dvec3(outer), 1e-4);
}

TEST(ClipPlanes, FarPlaneEndsABoxInPerspective) {
  const auto scene = make_render_scene(tunnel());
  const Camera camera = with_planes(camera_of(Camera::Type::perspective), 2.5, 4.0);
  const double walls = 1.0 / (2.5 * 2.5) - 1.0 / 16.0;
  for (const Method method : {Method::asos, Method::beam})
    expect_near(mean_of(render_picture(*scene, camera, settings_of(method))),
                walls * glm::dvec3(inner), 1e-4);
  expect_near(mean_of(render_picture(*scene, camera, settings_of(Method::sobol))),
              walls * glm::dvec3(inner), 2e-3);
}

/// A box of height 2 at distance 5, with a square base and a corner towards the camera.
World turned_box() {
  const float r = std::numbers::sqrt2_v<float>;
  World world;
  const glm::vec3 front(0, -1, -5 + r), end(0, -1, -5 - r), left(-r, -1, -5), right(r, -1, -5);
  const glm::vec3 up(0, 2, 0);
  add_quad(world, front, left - front, up, card(outer));
  add_quad(world, front, right - front, up, card(outer));
  add_quad(world, end, left - end, up, card(inner));
  add_quad(world, end, right - end, up, card(inner));
  return world;
}

TEST(ClipPlanes, CutABoxInParallelProjection) {
  const auto scene = make_render_scene(turned_box());
  const Camera all = camera_of(Camera::Type::orthographic);
  const double r = std::numbers::sqrt2;
  // The near plane removes 0.6 of the depth, and so 1.2 of the width; the far plane 0.4 and 0.8.
  const double whole = 2.0 * 2.0 * r / 16.0, cut = 1.2 * 2.0 / 16.0;
  const Camera near = with_planes(all, 5.0 - r + 0.6, {});
  const Camera between = with_planes(all, 5.0 - r + 0.6, 5.0 + r - 0.4);
  const double through = 0.8 * 2.0 / 16.0;
  const glm::dvec3 opened = (whole - cut) * glm::dvec3(outer) + cut * glm::dvec3(inner);
  const glm::dvec3 both = opened - through * glm::dvec3(inner);
  for (const Method method : {Method::asos, Method::beam}) {
    const RenderSettings settings = settings_of(method);
    expect_near(mean_of(render_picture(*scene, all, settings)), whole * glm::dvec3(outer), 1e-4);
    expect_near(mean_of(render_picture(*scene, near, settings)), opened, 1e-4);
    expect_near(mean_of(render_picture(*scene, between, settings)), both, 1e-4);
  }
  expect_near(mean_of(render_picture(*scene, near, settings_of(Method::sobol))), opened, 2e-3);
}

// All pixels are exact along an oblique clipping line.
TEST(ClipPlanes, CutAPlaneAlongAnyLine) {
  World world;
  // The plane z = -3 + 0.3 x + 0.5 y, larger than the view.
  add_quad(world, {-50, -50, -43}, {100, 0, 30}, {0, 100, 50}, card(glm::vec3(0.5f)));
  const Camera camera = with_planes(camera_of(Camera::Type::perspective), 3.0, {});
  // The half-plane 0.3 x + 0.5 y < 0 of the picture remains.
  const Picture picture =
      render_picture(*make_render_scene(std::move(world)), camera, settings_of(Method::asos));
  EXPECT_NEAR(mean_of(picture).x, 0.25, 1e-4);
  EXPECT_EQ(picture.statistics.missed_splits, 0u);
}

TEST(ClipPlanes, ClippedSurfacesAppearInMirrors) {
  World world;
  Material mirror{.base_color = glm::vec4(1.0f), .metallic = 1.0f, .roughness = 0.0f};
  add_quad(world, {-9, -9, -5}, {18, 0, 0}, {0, 18, 0}, mirror);
  add_quad(world, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, card(outer));
  const auto scene = make_render_scene(std::move(world));
  // The reflection of the card, which is at distance 1, is at distance 9.
  const Camera camera = with_planes(camera_of(Camera::Type::perspective), 1.5, 6.0);
  expect_near(mean_of(render_picture(*scene, camera, settings_of(Method::asos))),
              1.0 / 81.0 * glm::dvec3(outer), 1e-4);
  expect_near(mean_of(render_picture(*scene, camera, settings_of(Method::sobol))),
              1.0 / 81.0 * glm::dvec3(outer), 1e-3);
}

TEST(ClipPlanes, ClippedSurfacesCastShadows) {
  const auto lit = [](bool with_card) {
    World world;
    add_quad(world, {-9, -9, -5}, {18, 0, 0}, {0, 18, 0}, matte(glm::vec3(0.5f)));
    if (with_card) add_quad(world, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, matte(outer));
    const Light sun = make_sun({0, 0, -1});
    return make_render_scene(std::move(world), {sun});
  };
  const Camera camera = with_planes(camera_of(Camera::Type::orthographic), 1.5, {});
  for (const Method method : {Method::asos, Method::sobol}) {
    const double tolerance = method == Method::asos ? 1e-4 : 2e-3;
    const double open = mean_of(render_picture(*lit(false), camera, settings_of(method))).x;
    ASSERT_GT(open, 0.01);
    // The shadow covers 2 x 2 of 4 x 4.
    EXPECT_NEAR(mean_of(render_picture(*lit(true), camera, settings_of(method))).x / open, 0.75,
                tolerance);
  }
}

TEST(ClipPlanes, BlendedSurfacesBeyondTheFarPlaneAreNotSeen) {
  World world;
  for (int i = 1; i <= 4; ++i)
    add_quad(world, {-9, -9, -i}, {18, 0, 0}, {0, 18, 0}, card(glm::vec3(1.0f), 0.5f));
  const auto scene = make_render_scene(std::move(world));
  const Camera camera = with_planes(camera_of(Camera::Type::perspective), 1.5, 3.5);
  // Two of the four cards remain.
  for (const Method method : {Method::asos, Method::sobol})
    expect_near(mean_of(render_picture(*scene, camera, settings_of(method))), glm::dvec3(0.75),
                1e-5);
}

TEST(ClipPlanes, ChangeNoBitIfTheyClipNothing) {
  World world = turned_box();
  add_sphere(world, {0.5f, 0.3f, -4}, 0.8f, 8, matte({0.4f, 0.5f, 0.6f}));
  const Light light = make_bulb({1, 2, 0}, 30.0f);
  const auto scene = make_render_scene(std::move(world), {light});
  for (const auto type : {Camera::Type::perspective, Camera::Type::orthographic}) {
    const Camera all = camera_of(type);
    for (const Method method : {Method::asos, Method::sobol, Method::whitted, Method::ray_bound}) {
      RenderSettings settings = settings_of(method);
      settings.sampling.spp = 16;
      const auto one = render_picture(*scene, all, settings);
      const auto other = render_picture(*scene, with_planes(all, 0.1, 50.0), settings);
      EXPECT_EQ(one.film.radiance, other.film.radiance);
    }
  }
}

}  // namespace
}  // namespace asos::test::clip_planes_test
