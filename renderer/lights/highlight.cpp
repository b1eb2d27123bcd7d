#include "renderer/lights/prepared_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

using LightShape = PreparedLight::Shape;

/// Returns the point where the mirrored ray hits the light's plane, relative to `to_middle`. If the
/// ray hits the plane beyond the whole light, or not at all, the ray's far end is used instead, so
/// that the point moves continuously as the ray turns away.
glm::dvec3 plane_hit(const PreparedLight& light, glm::dvec3 to_middle, glm::dvec3 ray) {
  const double far = glm::length(to_middle) + glm::length(light.half_u) + glm::length(light.half_v);
  const double along = glm::dot(to_middle, light.towards);
  const double slope = glm::dot(ray, light.towards);
  const bool hits = along * slope > 0.0 && std::abs(along) < far * std::abs(slope);
  return ray * (hits ? along / slope : far) - to_middle;
}

glm::dvec3 nearest_of_rectangle(const PreparedLight& light, glm::dvec3 hit) {
  const double u = glm::dot(hit, light.half_u) / glm::dot(light.half_u, light.half_u);
  const double v = glm::dot(hit, light.half_v) / glm::dot(light.half_v, light.half_v);
  return std::clamp(u, -1.0, 1.0) * light.half_u + std::clamp(v, -1.0, 1.0) * light.half_v;
}

glm::dvec3 nearest_of_disk(const PreparedLight& light, glm::dvec3 hit) {
  const glm::dvec3 flat = hit - glm::dot(hit, light.towards) * light.towards;
  const double length = glm::length(flat);
  return length > light.radius ? flat * (light.radius / length) : flat;
}

/// Returns the nearest point of a ball (or of a sun at the distance 1): at most a radius from its
/// centre towards the ray.
glm::dvec3 nearest_of_ball(glm::dvec3 to_middle, double radius, glm::dvec3 ray) {
  // A ray that leads away is nearest where it starts.
  const double along = std::max(0.0, glm::dot(to_middle, ray));
  const glm::dvec3 to_ray = along * ray - to_middle;
  const double length = glm::length(to_ray);
  return to_middle + to_ray * (length > radius ? radius / length : 1.0);
}

/// Returns the point of a segment with the least distance to the ray's line.
glm::dvec3 nearest_of_segment(const PreparedLight& light, glm::dvec3 to_middle, glm::dvec3 ray) {
  const double ray_middle = glm::dot(ray, to_middle);
  const double ray_half = glm::dot(ray, light.half_u);
  const double across2 = glm::dot(light.half_u, light.half_u) - ray_half * ray_half;
  const double wanted = ray_middle * ray_half - glm::dot(to_middle, light.half_u);
  const double t = across2 > 0.0 ? std::clamp(wanted / across2, -1.0, 1.0) : 0.0;
  return to_middle + t * light.half_u;
}

Highlight towards_point(glm::dvec3 to_point, double radius, glm::dvec3 ray) {
  const double distance = glm::length(to_point);
  Highlight highlight;
  highlight.direction = glm::vec3(distance > 0.0 ? to_point / distance : ray);
  highlight.distance = static_cast<float>(distance);
  // Points inside of the radius are treated as on the surface of a ball.
  highlight.half_angle_tangent =
      radius > 0.0 ? static_cast<float>(radius / std::max(distance, radius)) : 0.0f;
  return highlight;
}

Highlight ball_highlight(const PreparedLight& light, glm::dvec3 to_middle, glm::dvec3 ray) {
  const double distance = glm::length(to_middle);
  if (distance <= light.radius) return {glm::vec3(ray), 1.0f, 0.0f};
  Highlight highlight =
      towards_point(nearest_of_ball(to_middle, light.radius, ray), light.radius, ray);
  highlight.half_angle_tangent = static_cast<float>(light.radius / distance);
  highlight.distance = static_cast<float>(distance - light.radius);
  return highlight;
}

}  // namespace

Highlight highlight_of(const PreparedLight& light, glm::dvec3 position, glm::dvec3 mirrored_view) {
  const glm::dvec3 to_middle = light.position - position;
  switch (light.shape) {
    case LightShape::point:
      return towards_point(to_middle, 0.0, mirrored_view);
    case LightShape::distant:
      return {glm::vec3(light.towards), 0.0f};
    case LightShape::sun: {
      Highlight highlight = towards_point(
          nearest_of_ball(light.towards, light.radius, mirrored_view), 0.0, mirrored_view);
      highlight.half_angle_tangent = static_cast<float>(light.radius);
      highlight.distance = std::numeric_limits<float>::infinity();
      return highlight;
    }
    case LightShape::ball:
      return ball_highlight(light, to_middle, mirrored_view);
    case LightShape::segment:
      return towards_point(nearest_of_segment(light, to_middle, mirrored_view),
                           glm::length(light.half_u), mirrored_view);
    case LightShape::polygon:
    case LightShape::disk: {
      const glm::dvec3 hit = plane_hit(light, to_middle, mirrored_view);
      const glm::dvec3 nearest = light.shape == LightShape::disk ? nearest_of_disk(light, hit)
                                                                 : nearest_of_rectangle(light, hit);
      // The radius of the disk with the same area.
      const double radius = std::sqrt(light.area * std::numbers::inv_pi);
      return towards_point(to_middle + nearest, radius, mirrored_view);
    }
  }
  return {};
}

}  // namespace asos
