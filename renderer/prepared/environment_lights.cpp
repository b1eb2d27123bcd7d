#include "renderer/prepared/environment_lights.h"

#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace asos {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// `radiance` is what a white diffuse surface reflects that faces it.
Light sun(double elevation_deg, double angular_diameter_deg, glm::vec3 colour, double radiance) {
  constexpr double azimuth = -40.0 * degree;  // of the side that it shines from, about +Y from +Z
  const double elevation = elevation_deg * degree;
  Light light;
  light.name = "sun";
  light.type = Light::Type::directional;
  light.direction = -glm::dvec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                std::cos(azimuth) * std::cos(elevation));
  light.angular_diameter_rad = angular_diameter_deg * degree;
  light.color = colour;
  light.intensity = static_cast<float>(std::numbers::pi * radiance);
  return light;
}

/// In place of a rig; none: the rig stays.
std::optional<std::vector<Light>> lights_of(const Sky* sky) {
  if (!sky || !sky->choice().environment) return std::nullopt;
  switch (*sky->choice().environment) {
    case Environment::studio:
      break;
    case Environment::daylight:
      return std::vector{sun(45.0, 0.53, {1.0f, 0.95f, 0.87f}, 0.75)};
    case Environment::dusk:
      return std::vector{sun(12.0, 2.0, {1.0f, 0.55f, 0.28f}, 0.6)};
    case Environment::white:
    case Environment::grey:
      return std::vector<Light>{};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Light> lights_under(const RenderScene& scene, const Sky* sky) {
  std::vector<Light> lights = scene.own_lighting->lights;
  const Stage& stage = scene.geometry->stage;
  std::optional<std::vector<Light>> of_sky = lights_of(sky);
  if (!stage.lit_by_rig || !of_sky) return lights;
  // The rig comes last.
  lights.resize(lights.size() - stage.rig.size());
  std::move(of_sky->begin(), of_sky->end(), std::back_inserter(lights));
  return lights;
}

std::shared_ptr<const Sky> usual_sky(const RenderScene& scene) {
  return scene.geometry->stage.lit_by_rig ? std::make_shared<const Sky>(Environment::studio)
                                          : nullptr;
}

bool changes_lights(const RenderScene& scene, const Sky* sky) {
  return scene.geometry->stage.lit_by_rig && lights_of(sky);
}

Result<std::shared_ptr<const RenderScene>> lit_under(std::shared_ptr<const RenderScene> scene,
                                                     const Sky* sky) {
  if (!changes_lights(*scene, sky)) return scene;
  return with_lights(scene, lights_under(*scene, sky));
}

}  // namespace asos
