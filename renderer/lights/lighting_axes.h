#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cmath>

namespace asos {

/// Returns right, up and back to the viewer for default lights that turn with a camera about +Y.
[[nodiscard]] inline glm::dmat3 lighting_axes(const Camera& camera) {
  const glm::dmat4& m = camera.world_from_camera;
  // A camera that looks straight down or up has no "behind" on the ground, so its up vector is
  // used.
  glm::dvec3 back(m[2].x, 0.0, m[2].z);
  if (!(glm::length(back) > 1e-3)) back = {-m[1].x, 0.0, -m[1].z};
  if (!(glm::length(back) > 1e-3)) back = {0.0, 0.0, 1.0};
  back = glm::normalize(back);
  const glm::dvec3 up(0.0, 1.0, 0.0);
  return {glm::cross(up, back), up, back};
}

/// Returns a one-sided rectangle of 1 nit that casts shadows. `direction` is unit. `right` is any
/// vector not parallel to it; the first sides follow it.
[[nodiscard]] inline Light lighting_rectangle(const char* name, glm::dvec3 middle,
                                              glm::dvec3 direction, glm::dvec3 right,
                                              double half_width, double half_height) {
  Light light;
  light.name = name;
  light.type = Light::Type::rectangle;
  light.position = middle;
  light.direction = direction;
  const glm::dvec3 v = glm::normalize(glm::cross(direction, right));
  light.half_u = half_width * glm::cross(v, direction);
  light.half_v = half_height * v;
  return light;
}

/// Returns the unshadowed irradiance of a surface from a light of 1 nit.
[[nodiscard]] inline double irradiance_of_unit(const Light& light, glm::dvec3 position,
                                               glm::dvec3 normal) {
  return unshadowed_irradiance(prepare_light(light), Receiver{position, normal, normal}).x;
}

}  // namespace asos
