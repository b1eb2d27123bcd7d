#include "renderer/lights/form_factor.h"
#include "renderer/lights/light_math.h"
#include "renderer/lights/prepared_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

using std::numbers::pi;
using LightShape = PreparedLight::Shape;

/// A point light of one candela; 0 below either horizon.
double point_form(glm::dvec3 to_light, const Receiver& receiver) {
  const double distance2 = glm::dot(to_light, to_light);
  if (!(distance2 > 0.0)) return 0.0;
  return cosine_above(to_light / std::sqrt(distance2), receiver) / distance2;
}

/// The published rule for a flat light: all of it at its centre, with the cosine there.
double middle_form(const PreparedLight& light, const Receiver& receiver) {
  const glm::dvec3 to_light = light.position - receiver.position;
  const double distance = glm::length(to_light);
  if (!(distance > 0.0)) return 0.0;
  const double cosine = -glm::dot(to_light, light.towards) / distance;
  const double seen = light.two_sided ? std::abs(cosine) : std::max(0.0, cosine);
  return light.area * seen * point_form(to_light, receiver);
}

double outlines_form(const PreparedLight& light, const Receiver& receiver) {
  const double height = glm::dot(receiver.position - light.position, light.towards);
  if (!light.faces(height)) return 0.0;
  double form = 0.0;
  for (const std::vector<glm::dvec3>& outline : light.outlines)
    form += polygon_form(outline, receiver);
  return std::max(0.0, height < 0.0 ? -form : form);
}

double flat_form(const PreparedLight& light, const Receiver& receiver) {
  if (light.rule == LightRule::published) return middle_form(light, receiver);
  if (light.shape == LightShape::polygon) return outlines_form(light, receiver);
  const double height = glm::dot(receiver.position - light.position, light.towards);
  if (!light.faces(height)) return 0.0;
  const bool behind = height < 0.0;
  return disk_form(light.position, behind ? -light.towards : light.towards, light.radius, receiver);
}

double sun_form(const PreparedLight& light, const Receiver& receiver) {
  if (light.rule == LightRule::published)
    return pi * light.radius * light.radius * cosine_above(light.towards, receiver);
  const double cosine = 1.0 / std::sqrt(1.0 + light.radius * light.radius);
  return cone_form(light.towards, light.radius * cosine, cosine, receiver);
}

double ball_light_form(const PreparedLight& light, const Receiver& receiver) {
  if (light.rule == LightRule::physical) return ball_form(light.position, light.radius, receiver);
  return pi * light.radius * light.radius *
         point_form(light.position - receiver.position, receiver);
}

}  // namespace

double attenuation(const PreparedLight& light, glm::dvec3 position) {
  if (light.inverse_range == 0.0 && light.cone_scale == 0.0) return 1.0;
  const glm::dvec3 to_light = light.position - position;
  const double distance = glm::length(to_light);
  const double r = std::min(distance * light.inverse_range, 1.0);
  double factor = 1.0 - r * r * r * r;
  if (light.cone_scale > 0.0 && distance > 0.0) {
    const double cosine = glm::dot(to_light, light.towards) / distance;
    const double cone = std::clamp(cosine * light.cone_scale + light.cone_offset, 0.0, 1.0);
    factor *= cone * cone;
  }
  return factor;
}

glm::vec3 segment_irradiance(const PreparedLight& light, const Receiver& receiver, double t0,
                             double t1) {
  const double form =
      line_form(light.position + t0 * light.half_u, light.position + t1 * light.half_u,
                light.rule == LightRule::physical, receiver);
  return irradiance_of(light.power, form);
}

glm::vec3 unshadowed_irradiance(const PreparedLight& light, const Receiver& receiver) {
  double form = 0.0;
  switch (light.shape) {
    case LightShape::point:
      form = point_form(light.position - receiver.position, receiver) *
             attenuation(light, receiver.position);
      break;
    case LightShape::ball:
      form = ball_light_form(light, receiver) * attenuation(light, receiver.position);
      break;
    case LightShape::distant:
      form = cosine_above(light.towards, receiver);
      break;
    case LightShape::sun:
      form = sun_form(light, receiver);
      break;
    case LightShape::segment:
      return segment_irradiance(light, receiver, -1.0, 1.0);
    case LightShape::polygon:
    case LightShape::disk:
      form = flat_form(light, receiver);
      break;
  }
  return irradiance_of(light.power, form);
}

}  // namespace asos
