#include "renderer/lights/light_math.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/lights/spherical_rectangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

using std::numbers::pi;
using LightShape = PreparedLight::Shape;

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Maps the unit square onto the unit disk. Preserves areas and neighbourhoods (Shirley and Chiu
/// 1997).
glm::dvec2 concentric(double u, double v) {
  const double a = 2.0 * u - 1.0;
  const double b = 2.0 * v - 1.0;
  if (a == 0.0 && b == 0.0) return {0.0, 0.0};
  const bool wide = std::abs(a) > std::abs(b);
  const double r = wide ? a : b;
  const double angle = wide ? 0.25 * pi * (b / a) : 0.5 * pi - 0.25 * pi * (a / b);
  return {r * std::cos(angle), r * std::sin(angle)};
}

/// Returns a direction within the cone about `axis`, uniform by solid angle. one_less_cosine is 1 -
/// cos of the cone's half angle.
glm::dvec3 in_cone(glm::dvec3 axis, double one_less_cosine, double u, double v) {
  // 1 - cos of a cap is proportional to the disk's squared radius, and so is the disk's area.
  const glm::dvec2 p = concentric(u, v);
  const double drop = std::min(1.0, glm::dot(p, p)) * one_less_cosine;
  const double stretch = std::sqrt((2.0 - drop) * one_less_cosine);
  const glm::dvec3 x_axis = any_perpendicular(axis);
  return (1.0 - drop) * axis + stretch * (p.x * x_axis + p.y * glm::cross(axis, x_axis));
}

LightSample no_light(glm::dvec3 to_point) {
  LightSample sample;
  sample.distance = glm::length(to_point);
  if (sample.distance > 0.0) sample.direction = to_point / sample.distance;
  return sample;
}

/// Returns a sample of a flat light that was chosen by area.
LightSample area_sample(const PreparedLight& light, const Receiver& receiver, glm::dvec3 to_point) {
  LightSample sample = no_light(to_point);
  const double height = -glm::dot(to_point, light.towards);
  if (!(sample.distance > 0.0) || !light.faces(height)) return sample;
  const double seen = std::abs(height) / sample.distance;
  const double form = light.area * seen * cosine_above(sample.direction, receiver) /
                      (sample.distance * sample.distance);
  sample.irradiance = irradiance_of(light.power, form);
  return sample;
}

LightSample rectangle_sample(const PreparedLight& light, const Receiver& receiver, double u,
                             double v) {
  const glm::dvec3 middle = light.position - receiver.position;
  const double height = -glm::dot(middle, light.towards);
  if (light.faces(height)) {
    const std::array horizons{receiver.geometric, receiver.normal};
    const SphericalRectangle rectangle(middle, light.half_u, light.half_v, horizons);
    // Smaller solid angles have too few digits, and sampling by area is as good at that distance.
    constexpr double least = 1e-5;
    if (rectangle.solid_angle() > least) {
      LightSample sample = no_light(rectangle.point(u, v));
      const double form = rectangle.solid_angle() * cosine_above(sample.direction, receiver);
      sample.irradiance = irradiance_of(light.power, form);
      return sample;
    }
  }
  return area_sample(light, receiver,
                     middle + (2.0 * u - 1.0) * light.half_u + (2.0 * v - 1.0) * light.half_v);
}

LightSample polygon_sample(const PreparedLight& light, const Receiver& receiver, double u,
                           double v) {
  if (light.rectangle) return rectangle_sample(light, receiver, u, v);
  const glm::dvec2 p = light.rows.point(u, v);
  return area_sample(light, receiver,
                     light.position - receiver.position + p.x * glm::normalize(light.half_u) +
                         p.y * glm::normalize(light.half_v));
}

LightSample disk_sample(const PreparedLight& light, const Receiver& receiver, double u, double v) {
  const glm::dvec2 p = concentric(u, v);
  return area_sample(light, receiver,
                     light.position - receiver.position + p.x * light.half_u + p.y * light.half_v);
}

LightSample cone_sample(const PreparedLight& light, const Receiver& receiver, glm::dvec3 axis,
                        double one_less_cosine, double u, double v) {
  LightSample sample;
  sample.direction = in_cone(axis, one_less_cosine, u, v);
  sample.distance = kFar;
  const double form = 2.0 * pi * one_less_cosine * cosine_above(sample.direction, receiver);
  sample.irradiance = irradiance_of(light.power, form);
  return sample;
}

LightSample sun_sample(const PreparedLight& light, const Receiver& receiver, double u, double v) {
  const double cosine = 1.0 / std::sqrt(1.0 + light.radius * light.radius);
  const double sine = light.radius * cosine;
  return cone_sample(light, receiver, light.towards, sine * sine / (1.0 + cosine), u, v);
}

/// Samples a ball from the inside, where light arrives from all directions, by the cosine to the
/// receiver's normal.
LightSample inside_sample(const PreparedLight& light, const Receiver& receiver,
                          glm::dvec3 to_middle, double u, double v) {
  const glm::dvec2 p = concentric(u, v);
  const glm::dvec3 x_axis = any_perpendicular(receiver.normal);
  const double up = std::sqrt(std::max(0.0, 1.0 - glm::dot(p, p)));
  LightSample sample;
  sample.direction =
      p.x * x_axis + p.y * glm::cross(receiver.normal, x_axis) + up * receiver.normal;
  const double along = glm::dot(sample.direction, to_middle);
  const double power = light.radius * light.radius - glm::dot(to_middle, to_middle);
  sample.distance = along + std::sqrt(along * along + std::max(0.0, power));
  const bool above = glm::dot(sample.direction, receiver.geometric) > 0.0;
  sample.irradiance = irradiance_of(light.power, above ? pi : 0.0);
  return sample;
}

LightSample ball_sample(const PreparedLight& light, const Receiver& receiver, double u, double v) {
  const glm::dvec3 to_middle = light.position - receiver.position;
  const double distance = glm::length(to_middle);
  if (distance <= light.radius) return inside_sample(light, receiver, to_middle, u, v);
  const double sine = light.radius / distance;
  const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
  LightSample sample =
      cone_sample(light, receiver, to_middle / distance, sine * sine / (1.0 + cosine), u, v);
  // Choose the near side of the ball. At its rim the root rounds to either side of 0.
  const double along = glm::dot(sample.direction, to_middle);
  const glm::dvec3 beside = to_middle - along * sample.direction;
  sample.distance =
      along - std::sqrt(std::max(0.0, light.radius * light.radius - glm::dot(beside, beside)));
  return sample;
}

/// Samples a segment by the angle at the receiver (Kulla and Fajardo 2012, "equi-angular"), which
/// cancels the squared distance.
LightSample segment_sample(const PreparedLight& light, const Receiver& receiver, double u) {
  const glm::dvec3 to_middle = light.position - receiver.position;
  const double half = glm::length(light.half_u);
  const glm::dvec3 along = light.half_u / half;
  const double s0 = glm::dot(to_middle, along) - half;
  const double s1 = s0 + 2.0 * half;
  const glm::dvec3 foot = to_middle - glm::dot(to_middle, along) * along;
  const double height = glm::length(foot);
  const double angle = std::atan2(height * 2.0 * half, height * height + s0 * s1);

  double s = s0 + 2.0 * half * u;
  double measure = 2.0 * half;  // ds / du
  if (angle > 1e-4) {
    s = std::clamp(height * std::tan(std::atan2(s0, height) + u * angle), s0, s1);
    measure = angle / height * (height * height + s * s);
  }
  LightSample sample = no_light(foot + s * along);
  if (!(sample.distance > 0.0)) return sample;
  const double sine = light.rule == LightRule::physical ? height / sample.distance : 1.0;
  const double form = measure * sine * cosine_above(sample.direction, receiver) /
                      (sample.distance * sample.distance);
  sample.irradiance = irradiance_of(light.power, form);
  return sample;
}

}  // namespace

LightSample sample_light(const PreparedLight& light, const Receiver& receiver, double u, double v) {
  LightSample sample;
  switch (light.shape) {
    case LightShape::point:
      sample = no_light(light.position - receiver.position);
      sample.irradiance = unshadowed_irradiance(light, receiver);
      break;
    case LightShape::distant:
      sample = {light.towards, kFar, unshadowed_irradiance(light, receiver)};
      break;
    case LightShape::sun:
      sample = sun_sample(light, receiver, u, v);
      break;
    case LightShape::ball:
      sample = ball_sample(light, receiver, u, v);
      sample.irradiance *= static_cast<float>(attenuation(light, receiver.position));
      break;
    case LightShape::segment:
      sample = segment_sample(light, receiver, u);
      break;
    case LightShape::polygon:
      sample = polygon_sample(light, receiver, u, v);
      break;
    case LightShape::disk:
      sample = disk_sample(light, receiver, u, v);
      break;
  }
  return sample;
}

}  // namespace asos
