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

/// Returns whether a texture varies the emission of a light's own part.
bool patterned(const World& world, const Light& light) {
  if (light.own_part < 0) return false;
  const Part& part = world.parts[static_cast<std::size_t>(light.own_part)];
  return world.materials[part.material].emissive_texture.used();
}

std::vector<std::uint8_t> parts_that_show(const World& world, std::span<const Light> lights) {
  std::vector<std::uint8_t> shows(world.parts.size(), 0);
  for (const Light& light : lights) {
    if (light.own_part >= 0) {
      if (!patterned(world, light)) shows[static_cast<std::size_t>(light.own_part)] = 1;
      continue;
    }
    for (std::size_t i = 0; i < shows.size(); ++i) {
      if (stands_in(world.parts[i], light)) shows[i] = 1;
    }
  }
  return shows;
}

}  // namespace

RenderFeatures find_render_features(std::span<const Light> lights) {
  RenderFeatures render_features;
  for (const Light& light : lights) {
    const LightTraits& traits = traits_of(light_shape(light));
    render_features.*traits.feature = true;
    render_features.shadows |= light.casts_shadows;
    render_features.soft_shadows |= light.casts_shadows && traits.extended;
  }
  return render_features;
}

Lighting prepare_lighting(const World& world, std::vector<Light> lights) {
  Lighting lighting;
  lighting.emissive_lights = static_cast<std::size_t>(std::count_if(
      lights.begin(), lights.end(), [](const Light& light) { return light.own_part >= 0; }));
  lighting.render_features = find_render_features(lights);
  lighting.lights_without_geometry = find_lights_without_geometry(world, lights);
  lighting.shows_even_light = parts_that_show(world, lights);
  for (const LightRule rule : {LightRule::physical, LightRule::published})
    lighting.by_rule[static_cast<std::size_t>(rule)] = prepared_by(lights, rule);
  // The intersections do not depend on the rule.
  const LightIntersections intersections =
      find_light_intersections(world, lighting.prepared(LightRule::physical));
  const std::vector<bool> entered =
      find_entered_balls(world, lighting.prepared(LightRule::physical));
  for (std::vector<PreparedLight>& prepared : lighting.by_rule) {
    for (std::size_t i = 0; i < prepared.size(); ++i) {
      prepared[i].intersections = intersections[i];
      prepared[i].entered = entered[i];
      prepared[i].patterned = patterned(world, lights[i]);
    }
  }
  lighting.lights = std::move(lights);
  return lighting;
}

}  // namespace asos
