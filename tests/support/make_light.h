#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

namespace asos::test {

/// A light from infinitely far.
inline Light make_sun(glm::dvec3 direction, float intensity = 1.0f) {
  Light light;
  light.type = Light::Type::directional;
  light.direction = direction;
  light.intensity = intensity;
  return light;
}

/// A point that shines all round, or a ball.
inline Light make_bulb(glm::dvec3 position, float intensity = 1.0f, double radius = 0.0) {
  Light light;
  light.position = position;
  light.intensity = intensity;
  light.radius = radius;
  return light;
}

/// A rectangle that shines along `direction`.
inline Light make_panel(glm::dvec3 position, glm::dvec3 direction, glm::dvec3 half_u,
                        glm::dvec3 half_v, float intensity = 1.0f) {
  Light light;
  light.type = Light::Type::rectangle;
  light.position = position;
  light.direction = direction;
  light.half_u = half_u;
  light.half_v = half_v;
  light.intensity = intensity;
  return light;
}

}  // namespace asos::test
