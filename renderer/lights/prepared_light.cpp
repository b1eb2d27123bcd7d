#include "renderer/lights/prepared_light.h"

#include "renderer/lights/emitter_mesh.h"
#include "renderer/lights/light_math.h"
#include "renderer/lights/prepare_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

using std::numbers::pi;

/// Divides power by measure if the result fits a float. Returns false, without any change, if the
/// light is too small for that; then it counts as a point light.
bool spread(glm::vec3& power, double measure) {
  const glm::vec3 spread_power(glm::dvec3(power) / measure);
  const float sum = spread_power.x + spread_power.y + spread_power.z;
  if (!(measure > 0.0) || !std::isfinite(sum)) return false;
  power = spread_power;
  return true;
}

void prepare_ball(const Light& light, PreparedLight& prepared) {
  prepared.inverse_range = light.range > 0.0 ? 1.0 / light.range : 0.0;
  if (light.type == Light::Type::spot) {
    // The formula of KHR_lights_punctual, with its guard against equal angles.
    const double cos_outer = std::cos(light.outer_cone_rad);
    const double scale = 1.0 / std::max(0.001, std::cos(light.inner_cone_rad) - cos_outer);
    prepared.cone_scale = scale;
    prepared.cone_offset = -cos_outer * scale;
  }
  // A ball of radiance L looks like a disk of radius r from everywhere: L pi r^2 candela.
  if (light.radius > 0.0 && spread(prepared.power, pi * light.radius * light.radius)) {
    prepared.shape = LightShape::ball;
    prepared.radius = light.radius;
  }
}

void prepare_sun(const Light& light, PreparedLight& prepared) {
  prepared.shape = LightShape::distant;
  if (!(light.angular_diameter_rad > 0.0)) return;
  // A surface that faces a disk of half angle a and radiance L receives L pi sin^2 a.
  const double sine = std::sin(0.5 * light.angular_diameter_rad);
  if (!spread(prepared.power, pi * sine * sine)) return;
  prepared.shape = LightShape::sun;
  prepared.radius = std::tan(0.5 * light.angular_diameter_rad);
}

/// Returns whether a linear light is wider than a line by more than a float's rounding error.
bool is_wide(const Light& light) {
  constexpr double least = std::numeric_limits<float>::epsilon();
  return light.radius > least * glm::length(light.half_u);
}

void prepare_linear(const Light& light, PreparedLight& prepared) {
  const double half = glm::length(light.half_u), radius = light.radius;
  if (!(half > 0.0)) return prepare_ball(light, prepared);
  // Seen from the side, a capsule of radiance L looks like a rectangle between two half disks.
  const double area = (4.0 * half + pi * radius) * radius;
  if (is_wide(light) && spread(prepared.power, area)) {
    prepared.shape = LightShape::capsule;
    prepared.radius = radius;
    prepared.area = area;
  } else {
    if (!spread(prepared.power, 2.0 * half)) return;  // too short: a point light
    prepared.shape = LightShape::segment;
  }
  prepared.half_u = light.half_u;
}

bool prepare_rectangle(const Light& light, glm::dvec3 direction, PreparedLight& prepared) {
  const glm::dvec3 u = light.half_u;
  glm::dvec3 v = light.half_v;
  const double lengths = glm::length(u) * glm::length(v);
  glm::dvec3 across = glm::cross(u, v);
  if (!(glm::length(across) > 1e-13 * lengths)) return false;
  if (glm::dot(across, direction) < 0.0) {
    v = -v;
    across = -across;
  }
  const glm::dvec3 c = light.position;
  std::vector<std::vector<glm::dvec3>> outlines{{c - u - v, c + u - v, c + u + v, c - u + v}};
  // A sheared rectangle is prepared as a polygon.
  if (std::abs(glm::dot(u, v)) > 1e-6 * lengths)
    return prepare_polygon(outlines, direction, prepared);
  prepared.shape = LightShape::rectangle;
  prepared.outlines = std::move(outlines);
  prepared.towards = glm::normalize(across);
  prepared.half_u = u;
  prepared.half_v = v;
  prepared.area = 4.0 * glm::length(across);
  return true;
}

bool prepare_disk(const Light& light, glm::dvec3 direction, PreparedLight& prepared) {
  if (!(light.radius > 0.0)) return false;
  const glm::dvec3 u = any_perpendicular(direction);
  prepared.towards = direction;
  prepared.radius = light.radius;
  prepared.half_u = light.radius * u;
  prepared.half_v = light.radius * glm::cross(direction, u);
  prepared.area = pi * light.radius * light.radius;
  return true;
}

bool prepare_shape(const Light& light, glm::dvec3 direction, PreparedLight& prepared) {
  if (light.type == Light::Type::disk) {
    prepared.shape = LightShape::disk;
    return prepare_disk(light, direction, prepared);
  }
  prepared.shape = LightShape::polygon;
  if (light.type == Light::Type::rectangle) return prepare_rectangle(light, direction, prepared);
  return prepare_polygon(light.outlines, direction, prepared);
}

/// Returns the thickness of the light's surface and its rounding error in single precision.
double thickness_of(const PreparedLight& light) {
  constexpr double single_precision = 4.0 * std::numeric_limits<float>::epsilon();
  const glm::dvec3 reach =
      glm::abs(light.position) + glm::abs(light.half_u) + glm::abs(light.half_v);
  const double rounded = single_precision * std::max({reach.x, reach.y, reach.z});
  if (light.own_part < 0) return rounded;
  const double longest = 2.0 * (glm::length(light.half_u) + glm::length(light.half_v));
  return rounded + flatness_of_emitters * longest;
}

bool prepare_flat(const Light& light, glm::dvec3 direction, PreparedLight& prepared) {
  prepared.two_sided = light.two_sided;
  if (!prepare_shape(light, direction, prepared)) return false;
  prepared.thickness = thickness_of(prepared);
  return true;
}

/// Sets the numbers that follow from others.
void derive(PreparedLight& light) {
  light.u_length = glm::length(light.half_u);
  light.v_length = glm::length(light.half_v);
  if (light.u_length > 0.0) light.u_axis = light.half_u / light.u_length;
  if (light.v_length > 0.0) light.v_axis = light.half_v / light.v_length;
  const double cosine = 1.0 / std::sqrt(1.0 + light.radius * light.radius);
  const double sine = light.radius * cosine;
  light.one_less_cosine = sine * sine / (1.0 + cosine);
  light.highlight_radius =
      light.traits().line ? light.u_length : std::sqrt(light.area * std::numbers::inv_pi);
}

}  // namespace

LightShape light_shape(const Light& light) {
  switch (light.type) {
    case Light::Type::point:
    case Light::Type::spot:
      return light.radius > 0.0 ? LightShape::ball : LightShape::point;
    case Light::Type::directional:
      return light.angular_diameter_rad > 0.0 ? LightShape::sun : LightShape::distant;
    case Light::Type::linear:
      return is_wide(light) ? LightShape::capsule : LightShape::segment;
    case Light::Type::rectangle:
      return LightShape::rectangle;
    case Light::Type::disk:
      return LightShape::disk;
    case Light::Type::polygon:
      break;
  }
  return LightShape::polygon;
}

PreparedLight prepare_light(const Light& light, LightRule rule) {
  PreparedLight prepared;
  prepared.rule = rule;
  prepared.position = light.position;
  prepared.casts_shadows = light.casts_shadows;
  prepared.own_part = light.own_part;
  prepared.power = light.color * light.intensity;
  const double length = glm::length(light.direction);
  const glm::dvec3 direction = length > 0.0 ? light.direction / length : glm::dvec3(0.0, 0.0, -1.0);
  prepared.towards = -direction;

  switch (light.type) {
    case Light::Type::point:
    case Light::Type::spot:
      prepare_ball(light, prepared);
      break;
    case Light::Type::directional:
      prepare_sun(light, prepared);
      break;
    case Light::Type::linear:
      prepare_linear(light, prepared);
      break;
    case Light::Type::rectangle:
    case Light::Type::disk:
    case Light::Type::polygon:
      if (!prepare_flat(light, direction, prepared)) {
        prepared.shape = LightShape::point;
        prepared.power = glm::vec3(0.0f);
      }
      break;
  }
  derive(prepared);
  return prepared;
}

}  // namespace asos
