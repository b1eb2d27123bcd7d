#include "ui/orbit_camera.h"

#include "renderer/geometry/view.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace asos {
using namespace ui;
namespace {

constexpr double pi = std::numbers::pi;

Camera camera_at(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up) {
  Camera camera;
  camera.world_from_camera = glm::inverse(glm::lookAt(eye, target, up));
  return camera;
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
  double worst = 0.0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      worst = std::max(worst, std::abs(a[column][row] - b[column][row]));
    }
  }
  return worst;
}

glm::dvec3 eye_of(const OrbitCamera& orbit) {
  return glm::dvec3(orbit.camera().world_from_camera[3]);
}

TEST(OrbitCamera, TakesOverAnyCameraExactly) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 200; ++i) {
    const Camera camera = camera_at(10.0 * vector(), vector(), vector());
    OrbitCamera orbit;
    orbit.set(camera, 2.5, 1.0);
    EXPECT_LT(difference(orbit.camera().world_from_camera, camera.world_from_camera), 1e-12)
        << "camera " << i;
  }
}

TEST(OrbitCamera, TurnsToASide) {
  OrbitCamera orbit;
  orbit.set(camera_at({3, 4, 5}, {1, 2, 3}, {0.3, 1, 0.2}), 2.0, 1.0);
  const glm::dvec3 pivot = orbit.pivot();
  const auto expect_view = [&](double azimuth, double elevation, glm::dvec3 from, glm::dvec3 up) {
    orbit.turn_to(azimuth, elevation);
    EXPECT_LT(difference(orbit.camera().world_from_camera,
                         camera_at(pivot + 2.0 * from, pivot, up).world_from_camera),
              1e-12);
  };
  expect_view(0.0, 0.0, {0, 0, 1}, {0, 1, 0});
  expect_view(0.5 * pi, 0.0, {1, 0, 0}, {0, 1, 0});
  expect_view(pi, 0.0, {0, 0, -1}, {0, 1, 0});
  expect_view(0.0, 0.5 * pi, {0, 1, 0}, {0, 0, -1});
  expect_view(0.0, -0.5 * pi, {0, -1, 0}, {0, 0, 1});
}

// A point at the pivot's depth stays in its pixel.
TEST(OrbitCamera, ShowsThePivotsDepthAsLargeInEitherProjection) {
  OrbitCamera orbit;
  orbit.set(camera_at({0, 0, 5}, {0, 0, 3}, {0, 1, 0}), 2.0, 4.0);
  const auto height = [&] {
    const Ray ray = View(orbit.camera(), 100, 100).ray(50.0, 20.0);
    return ray.origin.y + ray.direction.y * (orbit.pivot().z - ray.origin.z) / ray.direction.z;
  };
  const double before = height();
  EXPECT_GT(before, 0.1);
  orbit.set_projection(Camera::Type::orthographic);
  EXPECT_EQ(orbit.camera().type, Camera::Type::orthographic);
  EXPECT_NEAR(height(), before, 1e-6);  // rays are floats
  EXPECT_GE(orbit.eye().z, 8.0) << "outside the scene, so that nothing is clipped";
  orbit.set_projection(Camera::Type::perspective);
  EXPECT_NEAR(height(), before, 1e-6);  // rays are floats
  EXPECT_NEAR(orbit.distance(), 2.0, 1e-12);
}

TEST(OrbitCamera, TakesAFieldOfViewThatIsOne) {
  OrbitCamera orbit;
  orbit.set(camera_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}), 5.0, 1.0);
  orbit.set_fov_y(1.25);
  EXPECT_EQ(orbit.camera().fov_y_rad, 1.25);
  for (const double bad : {0.0, -1.0, pi, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()})
    orbit.set_fov_y(bad);
  EXPECT_EQ(orbit.camera().fov_y_rad, 1.25);
}

TEST(OrbitCamera, TakesOverCamerasAtThePoles) {
  for (const double y : {1.0, -1.0}) {
    for (const glm::dvec3 up :
         {glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(0.6, 0, 0.8)}) {
      const Camera camera = camera_at({0, 4 * y, 0}, {0, 0, 0}, up);
      OrbitCamera orbit;
      orbit.set(camera, 4.0, 1.0);
      EXPECT_LT(difference(orbit.camera().world_from_camera, camera.world_from_camera), 1e-12);
    }
  }
}

TEST(OrbitCamera, AQuarterTurnMovesTheEyeByAQuarterCircle) {
  OrbitCamera orbit;
  orbit.set(camera_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}), 5.0, 1.0);
  orbit.orbit(pi / 2, 0.0);
  EXPECT_NEAR(glm::length(eye_of(orbit) - glm::dvec3(5, 0, 0)), 0.0, 1e-12);
  orbit.orbit(0.0, pi / 6);
  EXPECT_NEAR(glm::length(eye_of(orbit) - glm::dvec3(5 * std::cos(pi / 6), 2.5, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(orbit.pivot()), 0.0, 1e-12);
}

TEST(OrbitCamera, StopsAtThePoleWithoutFlipping) {
  OrbitCamera orbit;
  orbit.set(camera_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}), 5.0, 1.0);
  for (int i = 0; i < 100; ++i) orbit.orbit(0.0, 0.1);
  EXPECT_NEAR(glm::length(eye_of(orbit) - glm::dvec3(0, 5, 0)), 0.0, 1e-12);
  const glm::dmat4 top = orbit.camera().world_from_camera;
  EXPECT_NEAR(glm::length(glm::dvec3(top[0]) - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
  EXPECT_NEAR(glm::length(glm::dvec3(top[1]) - glm::dvec3(0, 0, -1)), 0.0, 1e-12);

  // Turning at the pole rotates the picture about its centre, and turning back restores it.
  orbit.orbit(pi / 2, 0.0);
  EXPECT_NEAR(glm::length(glm::dvec3(orbit.camera().world_from_camera[0]) - glm::dvec3(0, 0, -1)),
              0.0, 1e-12);
  orbit.orbit(0.0, -pi / 2);
  EXPECT_NEAR(glm::length(eye_of(orbit) - glm::dvec3(5, 0, 0)), 0.0, 1e-12);
}

TEST(OrbitCamera, PanFollowsThePointerAtThePivotsDepth) {
  OrbitCamera orbit;
  orbit.set(camera_at({3, 2, 4}, {0.5, 0, 0}, {0, 1, 0}), 2.0, 1.0);
  const glm::dvec3 grabbed = orbit.pivot();
  orbit.pan(0.25, -0.125);

  // In a picture 80 pixels high the grabbed point is now 20 right of the centre and 10 above it.
  const View view(orbit.camera(), 120, 80);
  const glm::dvec3 h = view.frame(60 + 20, 40 - 10, 1, 1).homogeneous(grabbed);
  EXPECT_NEAR(h.x / h.z, 0.0, 1e-9);
  EXPECT_NEAR(h.y / h.z, 0.0, 1e-9);
}

TEST(OrbitCamera, DollyScalesTheDistanceWithinTheScenesRange) {
  OrbitCamera orbit;
  orbit.set(camera_at({0, 0, 8}, {0, 0, 0}, {0, 1, 0}), 8.0, 2.0);
  orbit.dolly(0.5);
  EXPECT_DOUBLE_EQ(orbit.distance(), 4.0);
  for (int i = 0; i < 200; ++i) orbit.dolly(0.5);
  EXPECT_DOUBLE_EQ(orbit.distance(), 2e-4);
  for (int i = 0; i < 200; ++i) orbit.dolly(2.0);
  EXPECT_DOUBLE_EQ(orbit.distance(), 2e3);
}

TEST(OrbitCamera, DollyOfAnOrthographicCameraChangesItsHeight) {
  Camera camera = camera_at({0, 0, 8}, {0, 0, 0}, {0, 1, 0});
  camera.type = Camera::Type::orthographic;
  camera.height = 3.0;
  OrbitCamera orbit;
  orbit.set(camera, 8.0, 2.0);
  orbit.dolly(0.5);
  EXPECT_DOUBLE_EQ(orbit.camera().height, 1.5);
  EXPECT_DOUBLE_EQ(orbit.distance(), 8.0);
}

TEST(OrbitCamera, IgnoresWhatIsNotANumber) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  OrbitCamera orbit;
  orbit.set(camera_at({1, 2, 3}, {0, 0, 0}, {0, 1, 0}), nan, -1.0);
  const std::uint64_t before = orbit.revision();
  const Camera camera = orbit.camera();
  orbit.orbit(nan, 0.0);
  orbit.orbit(0.0, infinity);
  orbit.pan(infinity, 0.0);
  orbit.dolly(nan);
  orbit.dolly(0.0);
  orbit.dolly(-2.0);
  orbit.look_at({0.0, nan, 0.0});
  orbit.look_around(nan, 0.0);
  orbit.fly(0.0, infinity, 0.0);
  EXPECT_EQ(orbit.revision(), before);
  EXPECT_EQ(difference(orbit.camera().world_from_camera, camera.world_from_camera), 0.0);
  EXPECT_DOUBLE_EQ(orbit.distance(), 1.0);
}

TEST(OrbitCamera, LooksAroundWhereItStands) {
  OrbitCamera orbit;
  orbit.set(camera_at({0, 1, 5}, {0, 1, 0}, {0, 1, 0}), 5.0, 2.0);
  orbit.look_around(0.5 * pi, 0.0);
  EXPECT_LT(glm::distance(eye_of(orbit), glm::dvec3(0, 1, 5)), 1e-12);
  EXPECT_LT(glm::distance(orbit.pivot(), glm::dvec3(-5, 1, 5)), 1e-12) << "to the left";
  orbit.look_around(0.0, 0.25 * pi);
  EXPECT_LT(glm::distance(eye_of(orbit), glm::dvec3(0, 1, 5)), 1e-12);
  EXPECT_GT(orbit.pivot().y, 4.0) << "up";
  orbit.look_around(0.0, 9.0);
  EXPECT_LT(glm::distance(orbit.pivot(), glm::dvec3(0, 6, 5)), 1e-9) << "no farther than up";
}

TEST(OrbitCamera, FliesByTheScenesSize) {
  OrbitCamera orbit;
  orbit.set(camera_at({0, 1, 5}, {0, 1, 0}, {0, 1, 0}), 5.0, 2.0);
  orbit.fly(0.5, 0.25, 1.0);
  EXPECT_LT(glm::distance(eye_of(orbit), glm::dvec3(1, 1.5, 3)), 1e-12);
  EXPECT_LT(glm::distance(orbit.pivot(), glm::dvec3(1, 1.5, -2)), 1e-12);
}

TEST(OrbitCamera, ARestoredCameraIsAChange) {
  OrbitCamera orbit;
  orbit.set(camera_at({0, 1, 5}, {0, 1, 0}, {0, 1, 0}), 5.0, 2.0);
  const OrbitCamera before = orbit;
  orbit.orbit(0.3, 0.2);
  const std::uint64_t revision = orbit.revision();
  orbit.restore(before);
  EXPECT_GT(orbit.revision(), revision);
  EXPECT_EQ(orbit.camera().world_from_camera, before.camera().world_from_camera);
}

}  // namespace
}  // namespace asos
