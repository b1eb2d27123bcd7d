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
/// not compile. All have `form`, the projected solid angle times the spot's cone and range,
/// and `sample`. Shapes with an area have `add_patches` and `window`. Shapes with a
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
