#include "renderer/lights/lighting.h"

#include "renderer/lights/light_intersections.h"

#include <algorithm>
#include <utility>

namespace asos {
namespace {

std::vector<PreparedLight> prepared_by(std::span<const Light> lights, LightRule rule) {
  std::vector<PreparedLight> prepared;
  prepared.reserve(lights.size());
  for (const Light& light : lights) prepared.push_back(prepare_light(light, rule));
  return prepared;
}

}  // namespace

Lighting prepare_lighting(const World& world, std::vector<Light> lights) {
  Lighting lighting;
  lighting.emissive_lights = static_cast<std::size_t>(std::count_if(
      lights.begin(), lights.end(), [](const Light& light) { return light.own_part >= 0; }));
  lighting.needs = find_needs(lights);
  lighting.lights_without_geometry = find_lights_without_geometry(world, lights);
  for (const LightRule rule : {LightRule::physical, LightRule::published})
    lighting.by_rule[static_cast<std::size_t>(rule)] = prepared_by(lights, rule);
  // Where the intersections are does not depend on the rule.
  const LightIntersections intersections =
      find_light_intersections(world, lighting.prepared(LightRule::physical));
  for (std::vector<PreparedLight>& prepared : lighting.by_rule) {
    for (std::size_t i = 0; i < prepared.size(); ++i) prepared[i].intersections = intersections[i];
  }
  lighting.lights = std::move(lights);
  return lighting;
}

}  // namespace asos
