#include "renderer/geometry/view.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

// Rays start and end at the camera's near and far planes.

namespace asos::view_planes_test {
namespace {

Camera camera_of(Camera::Type type) {
  Camera camera{.type = type, .height = 4.0, .near_depth = 2.0, .far_depth = 7.0};
  camera.world_from_camera[3] = {0, 0, 5, 1};
  return camera;
}

TEST(ViewPlanes, RaysRunFromPlaneToPlane) {
  for (const auto type : {Camera::Type::perspective, Camera::Type::orthographic}) {
    const View view(camera_of(type), 10, 8, 4.0);
    for (const glm::dvec2 p : {glm::dvec2(0, 0), {5, 4}, {9, 2}}) {
      const Ray ray = view.ray(p.x, p.y);
      EXPECT_NEAR(ray.at(ray.t_near).z, 3.0f, 1e-6f);
      EXPECT_NEAR(ray.at(ray.t_far).z, -2.0f, 2e-6f);
    }
  }
}

TEST(ViewPlanes, ManyRaysAreThoseOneByOne) {
  const View view(camera_of(Camera::Type::perspective), 10, 8, 4.0);
  const std::array<glm::dvec2, 3> points{{{0, 0}, {5, 4}, {9.5, 2.25}}};
  std::array<Ray, 3> rays;
  view.rays(points, rays);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Ray one = view.ray(points[i].x, points[i].y);
    EXPECT_EQ(rays[i].t_near, one.t_near);
    EXPECT_EQ(rays[i].t_far, one.t_far);
  }
}

TEST(ViewPlanes, ThoseBeyondTheSceneAreLeftOut) {
  for (const auto type : {Camera::Type::perspective, Camera::Type::orthographic}) {
    Camera camera = camera_of(type);
    // The scene extends from 2.5 to 7.5 ahead.
    camera.near_depth = 2.4, camera.far_depth = 7.6;
    const View view(camera, 10, 8, 2.5);
    EXPECT_EQ(view.near_depth(), 0.0);
    EXPECT_TRUE(std::isinf(view.far_depth()));
    EXPECT_EQ(view.ray(1, 1).t_near, 0.0f);
    EXPECT_TRUE(std::isinf(view.ray(1, 1).t_far));
    EXPECT_FALSE(view.before());
    camera.near_depth = 2.6, camera.far_depth = 7.4;
    EXPECT_EQ(View(camera, 10, 8, 2.5).near_depth(), 2.6);
    EXPECT_EQ(View(camera, 10, 8, 2.5).far_depth(), 7.4);
  }
}

TEST(ViewPlanes, ViewsFromFarAwayStartThereToo) {
  for (const auto type : {Camera::Type::perspective, Camera::Type::orthographic}) {
    Camera camera = camera_of(type);
    camera.world_from_camera[3] = {0, 0, 1e6, 1};
    camera.near_depth = 1e6 - 0.5;
    camera.far_depth = 1e6 + 0.25;
    const View view(camera, 8, 8, 2.0);
    ASSERT_GT(view.start(), 0.0);
    const Ray ray = view.ray(4, 4);
    EXPECT_NEAR(ray.at(ray.t_near).z, 0.5f, 1e-6f);
    EXPECT_NEAR(ray.at(ray.t_far).z, -0.25f, 1e-6f);
  }
}

}  // namespace
}  // namespace asos::view_planes_test
