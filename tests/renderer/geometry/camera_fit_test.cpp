#include "renderer/geometry/camera_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos {
namespace {

Camera perspective(double fov_y_rad, std::optional<double> aspect_ratio) {
  return {.fov_y_rad = fov_y_rad, .aspect_ratio = aspect_ratio};
}

double half_height(const Camera& camera) {
  return std::tan(0.5 * camera.fov_y_rad);
}

TEST(CameraFit, FitShowsAllThatTheCameraSees) {
  const Camera camera = perspective(0.7, 8.0 / 3.0);
  // A narrower picture keeps the horizontal field of view.
  for (const double picture : {16.0 / 9.0, 1.0, 0.5}) {
    const Camera fitted = fitted_camera(camera, picture, CameraFit::fit);
    EXPECT_NEAR(half_height(fitted) * picture, half_height(camera) * 8.0 / 3.0, 1e-12);
  }
  // A wider picture keeps the vertical field of view, bit for bit.
  EXPECT_EQ(fitted_camera(camera, 3.0, CameraFit::fit).fov_y_rad, 0.7);
  EXPECT_EQ(fitted_camera(camera, 8.0 / 3.0, CameraFit::fit).fov_y_rad, 0.7);
}

TEST(CameraFit, RoundedRatiosAreTheSame) {
  for (const CameraFit fit : {CameraFit::fit, CameraFit::fill})
    for (const double ratio : {1.7777777910232544, 1.778, 1.7773})
      EXPECT_EQ(fitted_camera(perspective(0.7, ratio), 16.0 / 9.0, fit).fov_y_rad, 0.7);
  EXPECT_GT(fitted_camera(perspective(0.7, 1.78), 16.0 / 9.0, CameraFit::fit).fov_y_rad, 0.7);
}

TEST(CameraFit, FillShowsNothingElse) {
  const Camera camera = perspective(0.7, 1.5);
  EXPECT_EQ(fitted_camera(camera, 1.0, CameraFit::fill).fov_y_rad, 0.7);
  const Camera filled = fitted_camera(camera, 2.0, CameraFit::fill);
  EXPECT_NEAR(half_height(filled) * 2.0, half_height(camera) * 1.5, 1e-12);
}

TEST(CameraFit, CropAndCamerasWithoutAspectRatioStay) {
  for (const double picture : {0.25, 1.0, 4.0}) {
    EXPECT_EQ(fitted_camera(perspective(0.7, 2.0), picture, CameraFit::crop).fov_y_rad, 0.7);
    for (const CameraFit fit : {CameraFit::crop, CameraFit::fit, CameraFit::fill})
      EXPECT_EQ(fitted_camera(perspective(0.7, std::nullopt), picture, fit).fov_y_rad, 0.7);
  }
}

TEST(CameraFit, OrthographicCamerasGrowByTheirHeight) {
  Camera camera{.type = Camera::Type::orthographic, .height = 3.0, .aspect_ratio = 2.0};
  EXPECT_DOUBLE_EQ(fitted_camera(camera, 1.0, CameraFit::fit).height, 6.0);
  EXPECT_DOUBLE_EQ(fitted_camera(camera, 4.0, CameraFit::fit).height, 3.0);
  EXPECT_DOUBLE_EQ(fitted_camera(camera, 4.0, CameraFit::fill).height, 1.5);
  EXPECT_EQ(fitted_camera(camera, 1.0, CameraFit::fit).fov_y_rad, camera.fov_y_rad);
}

// No angle below 180 degrees is that wide.
TEST(CameraFit, ExtremeRatiosAreNotFitted) {
  EXPECT_EQ(fitted_camera(perspective(3.0, 1e300), 1e-4, CameraFit::fit).fov_y_rad, 3.0);
  Camera camera{.type = Camera::Type::orthographic, .aspect_ratio = 1e300};
  EXPECT_EQ(fitted_camera(camera, 1e-9, CameraFit::fit).height, camera.height);
}

}  // namespace
}  // namespace asos
