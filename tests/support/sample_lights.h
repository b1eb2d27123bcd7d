#pragma once

#include "renderer/lights/prepared_light.h"

#include <glm/glm.hpp>

#include <utility>
#include <vector>

namespace asos::test {

/// A light of each type about 2 above the origin, facing down, about 1 in size.
[[nodiscard]] inline Light light_above_origin(const char* name, Light::Type type,
                                              double radius = 0.0) {
  return {.name = name,
          .type = type,
          .color = {1.0f, 0.5f, 0.25f},
          .intensity = 5.0f,
          .position = {0, 2, 0},
          .direction = {0, -1, 0},
          .radius = radius};
}
[[nodiscard]] inline Light point_light() {
  return light_above_origin("point", Light::Type::point);
}
[[nodiscard]] inline Light spot_light() {
  Light light = light_above_origin("spot", Light::Type::spot);
  light.range = 9.0;
  light.inner_cone_rad = 0.3;
  light.outer_cone_rad = 1.2;
  return light;
}
[[nodiscard]] inline Light ball_light(double radius = 0.6) {
  return light_above_origin("ball", Light::Type::point, radius);
}
[[nodiscard]] inline Light distant_light() {
  return light_above_origin("distant", Light::Type::directional);
}
[[nodiscard]] inline Light sun_light(double angular_diameter_rad = 0.5) {
  Light light = light_above_origin("sun", Light::Type::directional);
  light.angular_diameter_rad = angular_diameter_rad;
  return light;
}
[[nodiscard]] inline Light linear_light() {
  Light light = light_above_origin("linear", Light::Type::linear);
  light.half_u = {0.9, 0.2, 0};
  return light;
}
[[nodiscard]] inline Light capsule_light(double radius = 0.3) {
  Light light = linear_light();
  light.name = "capsule";
  light.radius = radius;
  return light;
}
[[nodiscard]] inline Light rectangle_light() {
  Light light = light_above_origin("rectangle", Light::Type::rectangle);
  light.half_u = {0.8, 0, 0};
  light.half_v = {0, 0, -0.5};
  return light;
}
[[nodiscard]] inline Light disk_light() {
  return light_above_origin("disk", Light::Type::disk, 0.7);
}
/// An L with a hole in its corner, starting at x = z = -0.6.
[[nodiscard]] inline Light polygon_light() {
  Light light = light_above_origin("polygon", Light::Type::polygon);
  light.outlines = {
      {{-0.6, 2, -0.6}, {0.8, 2, -0.6}, {0.8, 2, 0}, {0, 2, 0.1}, {0, 2, 1}, {-0.6, 2, 1}},
      {{-0.4, 2, -0.4}, {-0.4, 2, -0.1}, {-0.1, 2, -0.3}}};
  return light;
}

[[nodiscard]] inline std::vector<Light> all_lights() {
  return {point_light(),  spot_light(),    ball_light(),      distant_light(), sun_light(),
          linear_light(), capsule_light(), rectangle_light(), disk_light(),    polygon_light()};
}

/// The light for a world scaled by `scale`, with the same irradiance.
[[nodiscard]] inline Light scaled(Light light, double scale) {
  const bool candela = light.type == Light::Type::point || light.type == Light::Type::spot ||
                       light.type == Light::Type::linear;
  if (candela) light.intensity = static_cast<float>(light.intensity * scale * scale);
  light.position *= scale;
  light.range *= scale;
  light.radius *= scale;
  light.half_u *= scale;
  light.half_v *= scale;
  for (auto& outline : light.outlines) {
    for (glm::dvec3& corner : outline) corner *= scale;
  }
  return light;
}

}  // namespace asos::test
