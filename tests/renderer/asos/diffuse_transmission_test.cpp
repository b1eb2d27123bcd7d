#include "renderer/shading/sky.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

// Light that arrives on the far side of a leaf (KHR_materials_diffuse_transmission): Lambert's law.

namespace asos::test::diffuse_transmission_test {
namespace {

constexpr int leaf_side = 8;  // of a picture, in pixels
constexpr glm::vec3 leaf_colour{0.9f, 0.5f, 0.25f};

/// Transmits the fraction `share` of light, and has no specular reflection.
Material leaf(float share) {
  Material m = matte(glm::vec3(0.4f));
  m.specular = 0.0f;
  m.double_sided = true;
  m.diffuse_transmission.factor = share;
  m.diffuse_transmission.color = leaf_colour;
  return m;
}

Light sun_along(glm::dvec3 direction) {
  return make_sun(glm::normalize(direction), 2.0f);
}

glm::vec3 shown(const RenderScene& scene, Method method, glm::vec3 sky = glm::vec3(0.0f)) {
  RenderSettings settings = make_settings(leaf_side, leaf_side, method);
  settings.sky = std::make_shared<const Sky>(sky);
  const auto pixels = render_picture(scene, orthographic(1.0), settings).film.radiance;
  glm::vec3 sum(0.0f);
  for (const glm::vec3 p : pixels) sum += p;
  return sum / static_cast<float>(pixels.size());
}

void expect_near(glm::vec3 found, glm::vec3 expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 1e-4f) << c;
}

TEST(DiffuseTransmission, MixesTheLightOfBothSides) {
  constexpr float share = 0.6f, slope = 0.5f;
  for (const Method method : {Method::asos, Method::sobol, Method::whitted}) {
    SCOPED_TRACE(static_cast<int>(method));
    for (const bool from_behind : {false, true}) {
      World world;
      add_quad(world, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, leaf(share));
      const double z = from_behind ? 1.0 : -1.0;
      const auto scene = make_render_scene(std::move(world), {sun_along({slope, 0.0, z})});
      const float cosine = 1.0f / std::sqrt(1.0f + slope * slope);
      const float irradiance = 2.0f * cosine * std::numbers::inv_pi_v<float>;
      const glm::vec3 expected = from_behind ? share * leaf_colour : glm::vec3((1 - share) * 0.4f);
      expect_near(shown(*scene, method), irradiance * expected);
    }
  }
}

TEST(DiffuseTransmission, IsShadowedFromBehind) {
  for (const Method method : {Method::asos, Method::sobol}) {
    World world;
    add_quad(world, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, leaf(1.0f));
    // This card shades half of the view.
    add_quad(world, {0, -5, -1}, {5, 0, 0}, {0, 10, 0}, matte(glm::vec3(1.0f)));
    const auto scene = make_render_scene(std::move(world), {sun_along({0.0, 0.0, 1.0})});
    const float irradiance = 2.0f * std::numbers::inv_pi_v<float>;
    expect_near(shown(*scene, method), 0.5f * irradiance * leaf_colour);
  }
}

// Both sides see the same sky, so the transmitted fraction does not matter.
TEST(DiffuseTransmission, AddsNoLightUnderAnEvenSky) {
  for (const float share : {0.0f, 0.3f, 1.0f}) {
    World world;
    Material paper = leaf(share);
    paper.base_color = glm::vec4(1.0f);
    paper.diffuse_transmission.color = glm::vec3(1.0f);
    add_quad(world, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, paper);
    const auto scene = make_render_scene(std::move(world));
    Material opaque = leaf(0.0f);
    opaque.base_color = glm::vec4(1.0f);
    World plain;
    add_quad(plain, {-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, opaque);
    const auto reference = make_render_scene(std::move(plain));
    const glm::vec3 sky(0.7f);
    for (const Method method : {Method::asos, Method::sobol})
      expect_near(shown(*scene, method, sky), shown(*reference, method, sky));
  }
}

}  // namespace
}  // namespace asos::test::diffuse_transmission_test
