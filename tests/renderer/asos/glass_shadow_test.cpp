#include "tests/renderer/asos/glass_world.h"
#include "tests/support/make_light.h"
#include "tests/support/sample_lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

// Shadows of glass are straight. They have the transmittance of its interfaces and of its volume.

namespace asos::test::glass_shadow_test {
namespace {

using glass::add_solid;
using glass::clear;
using glass::mean;
using glass::picture;

constexpr double thickness = 0.4, distance = 0.7;

Material green() {
  Material m = clear(1.5f);
  m.specular = 1.0f;
  m.base_color = {0.9f, 1.0f, 0.8f, 1.0f};
  m.volume.attenuation_color = {0.25f, 0.9f, 0.5f};
  m.volume.attenuation_distance = static_cast<float>(distance);
  return m;
}

/// Transmittance of a green plate at an angle of incidence.
glm::dvec3 through(double cosine) {
  const double left = 0.96 * (1.0 - std::pow(1.0 - cosine, 5.0));
  const double way = thickness / cosine / distance;
  return left * left * glm::dvec3(0.81, 1.0, 0.64) *
         glm::dvec3(std::pow(0.25, way), std::pow(0.9, way), std::pow(0.5, way));
}

/// A white diffuse floor below a plate, with the camera between the two.
World floor_below_plate() {
  World world;
  Material floor = matte(glm::vec3(1.0f));
  floor.specular = 0.0f;
  add_quad(world, {-30, 0, 30}, {60, 0, 0}, {0, 0, -60}, floor);
  const auto corner = [](double x, double y, double z) { return glm::vec3(x, y, z); };
  std::vector<glm::vec3> low, high;
  for (const auto& [x, z] : {std::pair{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}) {
    low.push_back(corner(x, 1.0, z));
    high.push_back(corner(x, 1.0 + thickness, z));
  }
  std::vector<std::vector<glm::vec3>> faces{low, high};
  for (std::size_t i = 0; i < 4; ++i)
    faces.push_back({low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]});
  add_solid(world, faces, {0.0f, 1.0f + 0.5f * static_cast<float>(thickness), 0.0f}, green());
  return world;
}

Camera below_plate() {
  return look_at({0, 0.5, 0.5}, {0, 0, 0}, 0.02);
}

glm::dvec3 seen_of_floor(const std::vector<Light>& lights, Method method) {
  const auto scene = make_render_scene(floor_below_plate(), lights);
  const auto black = std::make_shared<const Sky>(glm::vec3(0.0f));
  return mean(picture(*scene, below_plate(), method, black));
}

void expect_near(glm::dvec3 found, glm::dvec3 expected, double relative, Method method) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(found[c], expected[c], relative * expected[c])
        << "colour " << c << ", method " << static_cast<int>(method);
}

TEST(GlassShadow, PlateTransmitsByInterfacesAndThickness) {
  for (const double angle : {0.0, 0.6, 1.1}) {
    const Light sun = make_sun({std::sin(angle), -std::cos(angle), 0.0}, 2.0f);
    const glm::dvec3 expected =
        2.0 * std::cos(angle) * std::numbers::inv_pi * through(std::cos(angle));
    for (const Method method :
         {Method::asos, Method::sobol, Method::sobol_adaptive, Method::stochastic, Method::whitted})
      expect_near(seen_of_floor({sun}, method), expected, 4e-3, method);
  }
}

TEST(GlassShadow, AveragesOverAreaLights) {
  Light lamp = rectangle_light();
  lamp.position = {0.5, 3.0, 0.0};
  lamp.direction = {0, -1, 0};
  lamp.color = glm::vec3(1.0f);
  lamp.intensity = 5.0f;
  lamp.half_u = {0.8, 0, 0};
  lamp.half_v = {0, 0, 0.6};
  glm::dvec3 expected(0.0);
  constexpr int n = 64;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const glm::dvec3 at = lamp.position + ((2 * i + 1.0) / n - 1.0) * lamp.half_u +
                            ((2 * k + 1.0) / n - 1.0) * lamp.half_v;
      const double d2 = glm::dot(at, at), cosine = at.y / std::sqrt(d2);
      const double area = 4.0 * 0.8 * 0.6 / (n * n);
      expected += 5.0 * std::numbers::inv_pi * cosine * cosine * area / d2 * through(cosine);
    }
  }
  for (const Method method : {Method::asos, Method::sobol})
    expect_near(seen_of_floor({lamp}, method), expected, 1e-2, method);
}

}  // namespace
}  // namespace asos::test::glass_shadow_test
