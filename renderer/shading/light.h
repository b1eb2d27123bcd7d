#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

namespace asos {

/// A punctual light with what its evaluation needs computed once.
struct PreparedLight {
  Light::Type type = Light::Type::point;
  glm::vec3 position{0.0f};
  glm::vec3 towards{0.0f};  ///< unit: against the way that the light travels
  glm::vec3 power{0.0f};    ///< colour times intensity: candela, or lux
  float inverse_range = 0.0f;
  float cone_scale = 0.0f;  ///< spot: (scale * cos + offset)^2, clamped to 0..1
  float cone_offset = 1.0f;
  bool casts_shadows = true;
};

[[nodiscard]] PreparedLight prepare_light(const Light& light);

/// Light that falls on a point: `irradiance` is what a surface facing the light receives.
struct Incident {
  glm::vec3 irradiance{0.0f};
  glm::vec3 direction{0.0f};  ///< unit, to the light
};

/// KHR_lights_punctual: inverse square, the range's window, the cone's falloff. At the very
/// position of a point light the result is not finite.
[[nodiscard]] Incident incident_light(const PreparedLight& light, glm::vec3 position);

}  // namespace asos
