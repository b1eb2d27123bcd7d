#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <utility>
#include <vector>

namespace asos {

/// Returns a directional light that travels along a unit vector; with a diameter, a sun.
[[nodiscard]] inline Light make_sun(glm::dvec3 direction, float lux = 1.0f,
                                    double angular_diameter_rad = 0.0) {
  Light light;
  light.type = Light::Type::directional;
  light.direction = direction;
  light.intensity = lux;
  light.angular_diameter_rad = angular_diameter_rad;
  return light;
}

/// Returns a point light; with a radius, a ball.
[[nodiscard]] inline Light make_bulb(glm::dvec3 position, float candela = 1.0f,
                                     double radius = 0.0) {
  Light light;
  light.type = Light::Type::point;
  light.position = position;
  light.intensity = candela;
  light.radius = radius;
  return light;
}

/// Returns a spot light with a cone about a unit vector.
[[nodiscard]] inline Light make_spot(glm::dvec3 position, glm::dvec3 direction,
                                     double outer_cone_rad, double inner_cone_rad,
                                     float candela = 1.0f) {
  Light light = make_bulb(position, candela);
  light.type = Light::Type::spot;
  light.direction = direction;
  light.outer_cone_rad = outer_cone_rad;
  light.inner_cone_rad = inner_cone_rad;
  return light;
}

/// Returns a linear light from position - half_u to position + half_u.
[[nodiscard]] inline Light make_tube(glm::dvec3 position, glm::dvec3 half_u, float candela = 1.0f) {
  Light light = make_bulb(position, candela);
  light.type = Light::Type::linear;
  light.half_u = half_u;
  return light;
}

/// Returns a rectangle that emits along a unit vector.
[[nodiscard]] inline Light make_panel(glm::dvec3 position, glm::dvec3 direction, glm::dvec3 half_u,
                                      glm::dvec3 half_v, float nits = 1.0f) {
  Light light;
  light.type = Light::Type::rectangle;
  light.position = position;
  light.direction = direction;
  light.half_u = half_u;
  light.half_v = half_v;
  light.intensity = nits;
  return light;
}

/// Returns a disk that emits along a unit vector.
[[nodiscard]] inline Light make_disk(glm::dvec3 position, glm::dvec3 direction, double radius,
                                     float nits = 1.0f) {
  Light light = make_panel(position, direction, {}, {}, nits);
  light.type = Light::Type::disk;
  light.radius = radius;
  return light;
}

/// Returns a polygon that emits along a unit vector; `outlines` as in Light.
[[nodiscard]] inline Light make_polygon(glm::dvec3 direction,
                                        std::vector<std::vector<glm::dvec3>> outlines,
                                        float nits = 1.0f) {
  Light light = make_panel(outlines.front().front(), direction, {}, {}, nits);
  light.type = Light::Type::polygon;
  light.outlines = std::move(outlines);
  return light;
}

}  // namespace asos
