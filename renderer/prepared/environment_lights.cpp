#include "renderer/prepared/environment_lights.h"

#include "renderer/scene/make_light.h"
#include "renderer/world/ground.h"

#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace asos {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// A directional light of an environment.
struct Sun {
  const char* name;
  double elevation_deg, angular_diameter_deg;
  glm::vec3 colour;
  double radiance;  ///< radiance of a white diffuse surface that faces it
};

Light sun_of(const Sun& sun, const SkyChoice& sky) {
  // Azimuth of the light, about +Y from +Z.
  const double azimuth = (-40.0 + sky.turn_deg) * degree;
  const double elevation = sun.elevation_deg * degree;
  const glm::dvec3 direction =
      -glm::dvec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                  std::cos(azimuth) * std::cos(elevation));
  Light light =
      make_sun(direction, static_cast<float>(std::numbers::pi * sun.radiance * sky.brightness),
               sun.angular_diameter_deg * degree);
  light.name = sun.name;
  light.color = sun.colour;
  return light;
}

/// Turns a light about the vertical axis through a point, counter-clockwise seen from above.
void turn_about(Light& light, glm::dvec3 about, double turn_rad) {
  const double s = std::sin(turn_rad), c = std::cos(turn_rad);
  const auto turned = [&](glm::dvec3 v) {
    return glm::dvec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
  };
  light.position = about + turned(light.position - about);
  for (glm::dvec3* v : {&light.direction, &light.half_u, &light.half_v}) *v = turned(*v);
}

/// Returns the default lights for an environment that keeps them. An interior's are attached to its
/// walls and do not turn.
std::vector<Light> rig_under(const RenderScene& scene, const SkyChoice& sky) {
  const AnimationInvariants& stage = scene.geometry->stage;
  std::vector<Light> rig = stage.rig;
  const Box bounds = bounds_without_ground(scene.world());
  const glm::dvec3 middle = 0.5 * (glm::dvec3(bounds.lo) + glm::dvec3(bounds.hi));
  for (Light& light : rig) {
    light.intensity *= static_cast<float>(sky.brightness);
    if (!stage.default_lighting_inside && sky.turn_deg != 0.0)
      turn_about(light, middle, sky.turn_deg * degree);
  }
  return rig;
}

/// Returns the replacement of the default lights; none: they stay.
std::optional<std::vector<Light>> lights_of(const RenderScene& scene, const Sky* sky) {
  if (!sky || !sky->choice().environment) return std::nullopt;
  const SkyChoice& choice = sky->choice();
  switch (*choice.environment) {
    case Environment::softboxes:
    case Environment::studio:
      if (choice.turn_deg == 0.0 && choice.brightness == 1.0) return std::nullopt;
      return rig_under(scene, choice);
    case Environment::windows:
      return std::vector{sun_of({"window", 30.0, 14.0, {1.0f, 1.0f, 1.0f}, 0.55}, choice)};
    case Environment::daylight:
      return std::vector{sun_of({"sun", 45.0, 0.53, {1.0f, 0.95f, 0.87f}, 0.75}, choice)};
    case Environment::dusk:
      return std::vector{sun_of({"sun", 12.0, 2.0, {1.0f, 0.55f, 0.28f}, 0.6}, choice)};
    case Environment::white:
    case Environment::grey:
      return std::vector<Light>{};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Light> lights_under(const RenderScene& scene, const Sky* sky) {
  std::vector<Light> lights = scene.own_lighting->lights;
  const AnimationInvariants& stage = scene.geometry->stage;
  std::optional<std::vector<Light>> of_sky = lights_of(scene, sky);
  if (!stage.has_default_lighting || !of_sky) return lights;
  // The default lights come last.
  lights.resize(lights.size() - stage.rig.size());
  std::move(of_sky->begin(), of_sky->end(), std::back_inserter(lights));
  return lights;
}

bool changes_lights(const RenderScene& scene, const Sky* sky) {
  return scene.geometry->stage.has_default_lighting && lights_of(scene, sky);
}

Result<std::shared_ptr<const RenderScene>> lit_under(std::shared_ptr<const RenderScene> scene,
                                                     const Sky* sky) {
  if (!changes_lights(*scene, sky)) return scene;
  return with_lights(scene, lights_under(*scene, sky));
}

}  // namespace asos
