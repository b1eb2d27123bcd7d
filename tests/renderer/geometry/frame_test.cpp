#include "renderer/geometry/frame.h"

#include "renderer/geometry/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace asos {
namespace {

TEST(Frame, ProjectAndWorldAreInverse) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 apex = 100.0 * vector();
    for (const Frame& frame : {Frame::pyramid(apex, vector(), vector(), vector()),
                               Frame::prism(apex, glm::normalize(vector()), vector(), vector())}) {
      const FramePoint p{unit(random), unit(random), 0.5 + 0.4 * unit(random)};
      const FramePoint q = frame.project(frame.homogeneous(frame.world(p)));
      // If the matrix is nearly singular, its inverse loses digits accordingly.
      EXPECT_NEAR(q.u, p.u, 1e-8);
      EXPECT_NEAR(q.v, p.v, 1e-8);
      EXPECT_NEAR(q.nearness, p.nearness, 1e-8);
    }
  }
}

TEST(Frame, NearnessIsLinearAlongALineInTheSquare) {
  const Frame frame = Frame::pyramid({1, 2, 3}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0});
  const glm::dvec3 a(1.5, 2.5, 0.0), b(4.0, 3.0, -7.0);
  const FramePoint p = frame.project(frame.homogeneous(a));
  const FramePoint q = frame.project(frame.homogeneous(b));
  const FramePoint m = frame.project(frame.homogeneous(0.25 * a + 0.75 * b));
  const double t = (m.u - p.u) / (q.u - p.u);
  EXPECT_NEAR(m.v, p.v + t * (q.v - p.v), 1e-12);
  EXPECT_NEAR(m.nearness, p.nearness + t * (q.nearness - p.nearness), 1e-12);
}

Camera camera_of(Camera::Type type) {
  Camera camera{.type = type, .fov_y_rad = 1.0, .height = 2.0};
  // The camera is at (1, 2, 3) and looks along -X.
  camera.world_from_camera = glm::dmat4(glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
                                        glm::dvec4(1, 0, 0, 0), glm::dvec4(1, 2, 3, 1));
  return camera;
}

TEST(View, TheMiddleRayLooksForwardAndTheTopOneUp) {
  const View view(camera_of(Camera::Type::perspective), 200, 100);
  const Ray middle = view.ray(100, 50);
  EXPECT_NEAR(glm::distance(middle.direction, glm::vec3(-1, 0, 0)), 0.0f, 1e-6f);
  EXPECT_EQ(middle.origin, glm::vec3(1, 2, 3));
  const Ray top = view.ray(100, 0);
  EXPECT_NEAR(std::atan2(top.direction.y, -top.direction.x), 0.5f, 1e-6f);
  // The camera's right vector is the world's -Z here.
  EXPECT_LT(view.ray(200, 50).direction.z, 0.0f);
}

TEST(View, OrthographicRaysAreParallelAndSpanTheHeight) {
  const View view(camera_of(Camera::Type::orthographic), 200, 100);
  const Ray top = view.ray(100, 0), bottom = view.ray(100, 100);
  EXPECT_EQ(top.direction, bottom.direction);
  EXPECT_NEAR(top.origin.y - bottom.origin.y, 2.0f, 1e-6f);
}

TEST(View, AFrameLooksWhereItsRaysDo) {
  for (const Camera::Type type : {Camera::Type::perspective, Camera::Type::orthographic}) {
    const View view(camera_of(type), 200, 100);
    const Frame frame = view.frame(40, 16, 8, 8);
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.25}, {0.5, 1.0}}) {
      const Ray ray = view.ray(40 + 8 * u, 16 + 8 * v);
      const FramePoint p = frame.project(frame.homogeneous(glm::dvec3(ray.at(7.0f))));
      EXPECT_NEAR(p.u, u, 2e-4);  // the ray is in single precision: 1e-7 over a pixel of 0.01
      EXPECT_NEAR(p.v, v, 2e-4);
    }
  }
}

}  // namespace
}  // namespace asos
