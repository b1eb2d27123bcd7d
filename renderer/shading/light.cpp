#include "renderer/shading/light.h"

#include <algorithm>
#include <cmath>

namespace asos {

PreparedLight prepare_light(const Light& light) {
  PreparedLight prepared;
  prepared.type = light.type;
  prepared.position = glm::vec3(light.position);
  const double length = glm::length(light.direction);
  prepared.towards =
      length > 0.0 ? glm::vec3(-light.direction / length) : glm::vec3(0.0f, 0.0f, 1.0f);
  prepared.power = light.color * light.intensity;
  prepared.inverse_range = light.range > 0.0 ? static_cast<float>(1.0 / light.range) : 0.0f;
  prepared.casts_shadows = light.casts_shadows;
  if (light.type == Light::Type::spot) {
    // The extension's own formula, with its own guard against equal angles.
    const double cos_outer = std::cos(light.outer_cone_rad);
    const double scale = 1.0 / std::max(0.001, std::cos(light.inner_cone_rad) - cos_outer);
    prepared.cone_scale = static_cast<float>(scale);
    prepared.cone_offset = static_cast<float>(-cos_outer * scale);
  }
  return prepared;
}

Incident incident_light(const PreparedLight& light, glm::vec3 position) {
  if (light.type == Light::Type::directional) return {light.power, light.towards};

  const glm::vec3 to_light = light.position - position;
  const float distance2 = glm::dot(to_light, to_light);
  const float distance = std::sqrt(distance2);
  const glm::vec3 direction = to_light / distance;
  float factor = 1.0f / distance2;
  const float r = distance * light.inverse_range;
  factor *= std::clamp(1.0f - r * r * r * r, 0.0f, 1.0f);
  if (light.type == Light::Type::spot) {
    const float cone = std::clamp(
        glm::dot(direction, light.towards) * light.cone_scale + light.cone_offset, 0.0f, 1.0f);
    factor *= cone * cone;
  }
  return {light.power * factor, direction};
}

}  // namespace asos
