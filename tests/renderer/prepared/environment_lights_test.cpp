#include "renderer/prepared/environment_lights.h"

#include "renderer/film/tone.h"
#include "renderer/gltf/load.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/environments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace asos {
namespace {

std::shared_ptr<const RenderScene> ready(const Scene& scene) {
  return prepare(scene).value();
}

/// A built-in scene without its lights.
Scene unlit(const std::string& source) {
  Scene scene = load_scene(source).value();
  scene.lights.clear();
  return scene;
}

TEST(EnvironmentLights, TakeThePlaceOfARigOnly) {
  const auto dark = ready(unlit("builtin:boxes"));
  const auto lit = ready(load_scene("builtin:boxes").value());
  ASSERT_EQ(dark->lights().size(), 2u);
  for (const EnvironmentRow& row : environments) {
    SCOPED_TRACE(row.name);
    const Sky sky(row.value);
    EXPECT_FALSE(changes_lights(*lit, &sky));
    EXPECT_EQ(lit_under(lit, &sky).value(), lit);
    const std::vector<Light> lights = lights_under(*dark, &sky);
    const bool keeps = row.value == Environment::studio || row.value == Environment::softboxes;
    EXPECT_EQ(changes_lights(*dark, &sky), !keeps);
    if (keeps) {
      EXPECT_EQ(lights.at(0).name, "Studio key");
      continue;
    }
    const std::string name = row.value == Environment::windows ? "window" : "sun";
    EXPECT_TRUE(std::ranges::all_of(lights, [&](const Light& l) { return l.name == name; }));
    EXPECT_EQ(lit_under(dark, &sky).value()->lights().size(), lights.size());
  }
  EXPECT_FALSE(changes_lights(*dark, nullptr));
  EXPECT_EQ(lit_under(dark, nullptr).value(), dark);
  const Sky colours(glm::vec3(0.1f), glm::vec3(0.9f));
  EXPECT_FALSE(changes_lights(*dark, &colours));
}

// A white diffuse surface that faces the sun, which contributes E / pi, with the sky behind it.
TEST(EnvironmentLights, SunsBringWhiteSurfacesNearWhite) {
  const auto dark = ready(unlit("builtin:boxes"));
  for (const Environment e : {Environment::windows, Environment::daylight, Environment::dusk}) {
    const Sky sky(e);
    const std::vector<Light> lights = lights_under(*dark, &sky);
    ASSERT_EQ(lights.size(), 1u);
    const glm::dvec3 to_sun = -lights[0].direction;
    EXPECT_NEAR(glm::length(to_sun), 1.0, 1e-12);
    EXPECT_GT(to_sun.y, 0.1) << "it is up";
    const Receiver receiver{glm::dvec3(0.0), to_sun, to_sun};
    const glm::dvec3 sun =
        glm::dvec3(unshadowed_irradiance(prepare_light(lights[0]), receiver)) / std::numbers::pi;
    const glm::dvec3 radiance = sun + glm::dvec3(sky.ambient(to_sun));
    EXPECT_NEAR(sun.x, static_cast<double>(lights[0].intensity) / std::numbers::pi, 1e-3);
    EXPECT_GT(radiance.x, 0.8);
    EXPECT_LT(radiance.x, 1.2);
  }
}

TEST(EnvironmentLights, FollowTheTurnAndBrightnessOfTheirSky) {
  const auto dark = ready(unlit("builtin:boxes"));
  const glm::dvec3 middle =
      0.5 * (glm::dvec3(dark->world().bounds.lo) + glm::dvec3(dark->world().bounds.hi));
  for (const EnvironmentRow& row : environments) {
    SCOPED_TRACE(row.name);
    const Sky sky(row.value), placed = sky.turned(90.0).brightened(2.5);
    const std::vector<Light> before = lights_under(*dark, &sky),
                             after = lights_under(*dark, &placed);
    ASSERT_EQ(before.size(), after.size());
    EXPECT_TRUE(changes_lights(*dark, &placed));
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_FLOAT_EQ(after[i].intensity, 2.5f * before[i].intensity);
      // Counter-clockwise seen from above: +Z goes to +X, and +X to -Z.
      const glm::dvec3 d = before[i].direction;
      EXPECT_NEAR(glm::distance(after[i].direction, glm::dvec3(d.z, d.y, -d.x)), 0.0, 1e-12);
      if (before[i].type == Light::Type::directional) continue;
      const glm::dvec3 p = before[i].position - middle;
      EXPECT_NEAR(glm::distance(after[i].position, middle + glm::dvec3(p.z, p.y, -p.x)), 0.0,
                  1e-9 * glm::length(p));
      const glm::dvec3 u = before[i].half_u;
      EXPECT_NEAR(glm::distance(after[i].half_u, glm::dvec3(u.z, u.y, -u.x)), 0.0,
                  1e-9 * glm::length(u));
    }
  }
}

// Surfaces facing the key light are about white. The background contrasts with white and with black
// in every direction except the ceiling.
TEST(EnvironmentLights, AStudioIsNeitherTooBrightNorTooDark) {
  const auto dark = ready(unlit("builtin:boxes"));
  const Sky sky(Environment::studio);
  const glm::dvec3 middle =
      0.5 * (glm::dvec3(dark->world().bounds.lo) + glm::dvec3(dark->world().bounds.hi));
  ASSERT_EQ(dark->lights().size(), 2u);
  const glm::dvec3 to_key = glm::normalize(dark->lights()[0].position - middle);
  const Receiver receiver{middle, to_key, to_key};
  glm::dvec3 radiance(sky.ambient(to_key));
  for (const Light& light : dark->lights())
    radiance +=
        glm::dvec3(unshadowed_irradiance(prepare_light(light), receiver)) / std::numbers::pi;
  EXPECT_GT(radiance.x, 0.9);
  EXPECT_LT(radiance.x, 1.05) << "points nearer to the light than the centre may be white";
  // Contrast of displayed colours (WCAG 2); 3 is the minimum for large text.
  const auto contrast = [](double bright, double dark_one) {
    const auto shown = [](double radiant) {
      return displayed_intensity(glm::dvec3(radiant), ToneCurve::neutral).g + 0.05;
    };
    return shown(bright) / shown(dark_one);
  };
  constexpr double black = 0.03;
  for (int elevation_deg = -60; elevation_deg <= 20; elevation_deg += 5) {
    const double elevation = elevation_deg * std::numbers::pi / 180.0;
    const auto behind =
        static_cast<double>(sky.radiance({0.0, std::sin(elevation), -std::cos(elevation)}).g);
    EXPECT_GT(contrast(radiance.x, behind), elevation_deg <= 0 ? 3.0 : 1.8) << elevation_deg;
    EXPECT_GT(contrast(behind, black), 2.4) << elevation_deg;
  }
  // Metal reflects a horizon: a step within a few degrees.
  EXPECT_GT(sky.radiance({0.0f, 0.07f, -1.0f}).g, 1.25f * sky.radiance({0.0f, -0.07f, -1.0f}).g);
}

}  // namespace
}  // namespace asos
