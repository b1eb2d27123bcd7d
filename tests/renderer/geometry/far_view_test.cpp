#include "renderer/geometry/view.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos {
namespace {

// Distance of a ray from a point, in double.
double miss(const Ray& ray, glm::dvec3 point) {
  const glm::dvec3 d = glm::normalize(glm::dvec3(ray.direction));
  const glm::dvec3 to_point = point - glm::dvec3(ray.origin);
  return glm::length(to_point - glm::dot(to_point, d) * d);
}

TEST(FarView, RaysFromFarAwayPassTheSceneWhereTheyShould) {
  const glm::dvec3 eye = 1e7 * glm::normalize(glm::dvec3(0.3, 0.5, 0.81));
  const Camera camera = test::look_at(eye, {0, 0, 0}, 3e-7);
  const View view(camera, 8, 8, 1.5);
  // The centre of the picture is the origin; allows 16 roundings of the scene's size.
  EXPECT_LT(miss(view.ray(4, 4), {0, 0, 0}), 1.5 * 16.0 * 6e-8);
  // Without the scene's size, rounding to floats at the eye's distance moves the ray by up to half
  // a unit.
  EXPECT_GT(miss(View(camera, 8, 8).ray(4, 4), {0, 0, 0}), 1e-3);
}

TEST(FarView, ParallelRaysToo) {
  Camera camera = test::look_at({3e6, 4e6, 5e6}, {0, 0, 0}, 1.0);
  camera.type = Camera::Type::orthographic;
  camera.height = 3.0;
  EXPECT_LT(miss(View(camera, 8, 8, 1.5).ray(4, 4), {0, 0, 0}), 1.5 * 16.0 * 6e-8);
}

TEST(FarView, AnOrdinaryCameraIsLeftAsItIs) {
  const Camera camera = test::look_at({30, 40, 50}, {0, 0, 0}, 1.0);
  const View view(camera, 8, 8, 1.0);
  EXPECT_EQ(view.start(), 0.0);
  EXPECT_EQ(view.ray(1, 2).origin, glm::vec3(30, 40, 50));
}

TEST(FarView, TheStartLiesBeforeTheScene) {
  const View view(test::look_at({0, 0, 5000}, {0, 0, 0}, 1e-3), 8, 8, 2.0);
  EXPECT_EQ(view.start(), 4996.0);
  EXPECT_NEAR(view.ray(4, 4).origin.z, 4.0, 1e-6);
}

}  // namespace
}  // namespace asos
