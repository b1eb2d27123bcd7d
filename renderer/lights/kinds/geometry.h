#pragma once

#include "renderer/lights/light_math.h"
#include "renderer/lights/light_patches.h"
#include "renderer/lights/light_window.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/lights/prepared_light.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

// Shared by the kinds of lights.

namespace asos {

/// The geometry of one shape. There is no general definition: a function that a shape lacks does
/// not compile. All have `form`, the projected solid angle times the spot's cone and range;
/// `sample`; and `highlight`. Shapes with an area have `add_patches` and `window`. Shapes with a
/// surface have `meet` and `outlines`, and `way` if they are not flat.
template <LightShape shape>
struct LightGeometry;

constexpr double infinitely_far = std::numeric_limits<double>::infinity();

/// Maps the unit square onto the unit disk. Preserves areas and neighbourhoods (Shirley and Chiu
/// 1997).
inline glm::dvec2 concentric(double u, double v) {
  const double a = 2.0 * u - 1.0;
  const double b = 2.0 * v - 1.0;
  if (a == 0.0 && b == 0.0) return {0.0, 0.0};
  const bool wide = std::abs(a) > std::abs(b);
  const double r = wide ? a : b;
  const double angle = wide ? 0.25 * std::numbers::pi * (b / a)
                            : 0.5 * std::numbers::pi - 0.25 * std::numbers::pi * (a / b);
  return {r * std::cos(angle), r * std::sin(angle)};
}

/// Returns a sample towards a point, without irradiance.
inline LightSample sample_towards(glm::dvec3 to_point) {
  LightSample sample;
  sample.distance = glm::length(to_point);
  if (sample.distance > 0.0) sample.direction = to_point / sample.distance;
  return sample;
}

/// Samples the directions within the cone about `axis`, uniformly by solid angle. one_less_cosine
/// is 1 - cos of the cone's half angle.
inline LightSample cone_sample(const PreparedLight& light, const Receiver& receiver,
                               glm::dvec3 axis, double one_less_cosine, double u, double v) {
  // 1 - cos of a cap is proportional to the disk's squared radius, and so is the disk's area.
  const glm::dvec2 p = concentric(u, v);
  const double drop = std::min(1.0, glm::dot(p, p)) * one_less_cosine;
  const double stretch = std::sqrt((2.0 - drop) * one_less_cosine);
  const glm::dvec3 x_axis = any_perpendicular(axis);
  LightSample sample;
  sample.direction =
      (1.0 - drop) * axis + stretch * (p.x * x_axis + p.y * glm::cross(axis, x_axis));
  sample.distance = infinitely_far;
  const double form =
      2.0 * std::numbers::pi * one_less_cosine * cosine_above(sample.direction, receiver);
  sample.irradiance = irradiance_of(light.power, form);
  return sample;
}

/// Returns 1 - cos of an angle, given its sine.
inline double one_less_cosine(double sine) {
  return sine * sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)));
}

/// Returns the form of a point light of one candela; 0 below either horizon.
inline double point_form(glm::dvec3 to_light, const Receiver& receiver) {
  const double distance2 = glm::dot(to_light, to_light);
  if (!(distance2 > 0.0)) return 0.0;
  return cosine_above(to_light / std::sqrt(distance2), receiver) / distance2;
}

/// Returns the highlight of a point with a radius.
inline Highlight highlight_towards(glm::dvec3 to_point, double radius, glm::dvec3 ray) {
  const double distance = glm::length(to_point);
  Highlight highlight;
  highlight.direction = glm::vec3(distance > 0.0 ? to_point / distance : ray);
  highlight.distance = static_cast<float>(distance);
  // Points inside of the radius are treated as on the surface of a ball.
  highlight.half_angle_tangent =
      radius > 0.0 ? static_cast<float>(radius / std::max(distance, radius)) : 0.0f;
  return highlight;
}

/// Returns the nearest point of a ball (or of a sun at the distance 1): at most a radius from its
/// centre towards the ray.
inline glm::dvec3 nearest_of_ball(glm::dvec3 to_middle, double radius, glm::dvec3 ray) {
  // A ray that leads away is nearest where it starts.
  const double along = std::max(0.0, glm::dot(to_middle, ray));
  const glm::dvec3 to_ray = along * ray - to_middle;
  const double length = glm::length(to_ray);
  return to_middle + to_ray * (length > radius ? radius / length : 1.0);
}

/// Returns the place, -1 to 1, on a segment about to_middle with the least distance to a ray's
/// line.
inline double nearest_to_ray(glm::dvec3 to_middle, glm::dvec3 half, glm::dvec3 ray) {
  const double ray_half = glm::dot(ray, half);
  const double across2 = glm::dot(half, half) - ray_half * ray_half;
  const double wanted = glm::dot(ray, to_middle) * ray_half - glm::dot(to_middle, half);
  return across2 > 0.0 ? std::clamp(wanted / across2, -1.0, 1.0) : 0.0;
}

/// Returns a circle as a polygon of the same area.
inline std::vector<glm::dvec3> circle_outline(glm::dvec3 middle, glm::dvec3 u, glm::dvec3 v) {
  std::vector<glm::dvec3> points;
  const double step = 2.0 * std::numbers::pi / circle_points;
  const double wider = std::sqrt(step / std::sin(step));
  for (int i = 0; i < circle_points; ++i)
    points.push_back(middle + wider * (std::cos(i * step) * u + std::sin(i * step) * v));
  return points;
}

}  // namespace asos
