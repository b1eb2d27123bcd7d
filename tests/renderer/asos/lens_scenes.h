#pragma once

#include "renderer/shading/sky.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

// A camera with a lens, and pictures of it, for the tests of depth of field.

namespace asos::test::lens_test {

using std::numbers::pi;

inline constexpr int side = 16;
inline constexpr double pixel = 0.01;  ///< width of a pixel at distance 1 from the camera
inline constexpr double focus = 4.0;

/// Looks along -z from the origin.
inline Camera camera_with(double radius, int blades = 0) {
  return {.fov_y_rad = 2.0 * std::atan(0.5 * side * pixel), .lens = {radius, focus, blades, 0.25}};
}

/// Aperture radius for a circle of confusion of `pixels` at a depth.
inline double radius_for(double pixels, double depth) {
  return pixels * pixel / std::abs(1.0 / depth - 1.0 / focus);
}

inline RenderSettings settings_of(Method method, double eps = 1e-4) {
  RenderSettings settings = make_settings(side, side, method, 4096);
  settings.asos.max_level = 3;
  settings.asos.eps = eps;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return settings;
}

inline double rmse(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

inline std::vector<double> reds(const Picture& picture) {
  std::vector<double> values;
  for (const glm::vec3 c : picture.film.radiance) values.push_back(c.r);
  return values;
}

}  // namespace asos::test::lens_test
