#include "renderer/lights/lights_without_geometry.h"

#include <algorithm>
#include <cmath>

namespace asos {

bool stands_in(const Part& part, const Light& light) {
  if (!part.shows_light || part.bounds.empty()) return false;
  const glm::dvec3 lo(part.bounds.lo), hi(part.bounds.hi);
  const double margin = 0.01 * glm::length(hi - lo);
  return glm::all(glm::greaterThan(light.position, lo - margin)) &&
         glm::all(glm::lessThan(light.position, hi + margin));
}

LightsWithoutGeometry find_lights_without_geometry(const World& world,
                                                   std::span<const Light> lights) {
  LightsWithoutGeometry found;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    if (light.own_part >= 0 || !traits_of(light_shape(light)).has_surface()) continue;
    const auto shown = [&](const Part& part) { return stands_in(part, light); };
    if (std::none_of(world.parts.begin(), world.parts.end(), shown)) found.push_back(i);
  }
  return found;
}

bool may_show(const PreparedLight& light, glm::dvec3 apex, glm::dvec3 axis, double half_angle) {
  if (!light.traits().has_surface()) return false;
  const double radius = light.radius + glm::length(light.half_u) + glm::length(light.half_v);
  const glm::dvec3 to_middle = light.position - apex;
  const double distance = glm::length(to_middle);
  if (!(distance > radius)) return true;
  const double away = std::acos(std::clamp(glm::dot(to_middle, axis) / distance, -1.0, 1.0));
  return away <= half_angle + std::asin(radius / distance);
}

}  // namespace asos
