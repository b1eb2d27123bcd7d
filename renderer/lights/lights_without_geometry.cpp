#include "renderer/lights/lights_without_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

using LightShape = PreparedLight::Shape;

bool has_area(const Light& light) {
  switch (light.type) {
    case Light::Type::rectangle:
    case Light::Type::disk:
    case Light::Type::polygon:
      return true;
    case Light::Type::point:
    case Light::Type::spot:
      return light.radius > 0.0;
    default:
      return false;
  }
}

bool odd_winding(const std::vector<std::vector<glm::dvec3>>& outlines, const PreparedLight& light,
                 glm::dvec3 p) {
  const glm::dvec3 u = glm::normalize(light.half_u), v = glm::normalize(light.half_v);
  const auto flat = [&](glm::dvec3 q) {
    return glm::dvec2(glm::dot(q - p, u), glm::dot(q - p, v));
  };
  bool in = false;
  for (const auto& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 a = flat(outline[i]), b = flat(outline[(i + 1) % outline.size()]);
      if ((a.y > 0.0) != (b.y > 0.0) && a.x - a.y * (b.x - a.x) / (b.y - a.y) > 0.0) in = !in;
    }
  }
  return in;
}

bool holds(const PreparedLight& light, glm::dvec3 p) {
  const glm::dvec3 d = p - light.position;
  if (light.shape == LightShape::disk) return glm::dot(d, d) <= light.radius * light.radius;
  if (!light.rectangle) return odd_winding(light.outlines, light, p);
  return std::abs(glm::dot(d, light.half_u)) <= glm::dot(light.half_u, light.half_u) &&
         std::abs(glm::dot(d, light.half_v)) <= glm::dot(light.half_v, light.half_v);
}

std::vector<glm::dvec3> circle(glm::dvec3 middle, glm::dvec3 u, glm::dvec3 v) {
  std::vector<glm::dvec3> points;
  // Enlarge the polygon so that its area is the circle's.
  const double step = 2.0 * std::numbers::pi / circle_points;
  const double wider = std::sqrt(step / std::sin(step));
  for (int i = 0; i < circle_points; ++i)
    points.push_back(middle + wider * (std::cos(i * step) * u + std::sin(i * step) * v));
  return points;
}

}  // namespace

bool stands_in(const Part& part, const Light& light) {
  if (!part.shows_light || part.bounds.empty()) return false;
  const glm::dvec3 lo(part.bounds.lo), hi(part.bounds.hi);
  const double margin = 0.01 * glm::length(hi - lo);
  return glm::all(glm::greaterThan(light.position, lo - margin)) &&
         glm::all(glm::lessThan(light.position, hi + margin));
}

LightsWithoutGeometry find_lights_without_geometry(const World& world,
                                                   std::span<const Light> lights) {
  LightsWithoutGeometry found;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const Light& light = lights[i];
    if (light.own_part >= 0 || !has_area(light)) continue;
    const auto shown = [&](const Part& part) { return stands_in(part, light); };
    if (std::none_of(world.parts.begin(), world.parts.end(), shown)) found.push_back(i);
  }
  return found;
}

std::optional<LightHit> meet_light(const PreparedLight& light, const Ray& ray) {
  const glm::dvec3 origin(ray.origin), direction(ray.direction);
  double t = 0.0;
  if (light.shape == LightShape::ball) {
    const glm::dvec3 to_middle = light.position - origin;
    const double along = glm::dot(to_middle, direction);
    const double under =
        light.radius * light.radius - glm::dot(to_middle, to_middle) + along * along;
    // From inside, the ball is invisible.
    if (!(under > 0.0)) return std::nullopt;
    t = along - std::sqrt(under);
  } else if (light.shape == LightShape::polygon || light.shape == LightShape::disk) {
    const double slope = glm::dot(direction, light.towards);
    if (slope == 0.0 || (slope > 0.0 && !light.two_sided)) return std::nullopt;
    t = glm::dot(light.position - origin, light.towards) / slope;
    if (!(t > 0.0) || !holds(light, origin + t * direction)) return std::nullopt;
  } else {
    return std::nullopt;
  }
  if (!(t >= static_cast<double>(ray.t_near) && t <= static_cast<double>(ray.t_far)))
    return std::nullopt;
  const auto shown = static_cast<float>(attenuation(light, origin));
  return LightHit{static_cast<float>(t), shown * light.power};
}

std::vector<std::vector<glm::dvec3>> light_outlines(const PreparedLight& light,
                                                    std::optional<glm::dvec3> apex,
                                                    glm::dvec3 direction) {
  if (light.shape == LightShape::polygon) {
    if (!light.rectangle) return light.outlines;
    const glm::dvec3 p = light.position, u = light.half_u, v = light.half_v;
    return {{p - u - v, p + u - v, p + u + v, p - u + v}};
  }
  if (light.shape == LightShape::disk) return {circle(light.position, light.half_u, light.half_v)};
  if (light.shape != LightShape::ball) return {};
  const glm::dvec3 to_middle = apex ? light.position - *apex : direction;
  const double distance = glm::length(to_middle);
  const glm::dvec3 axis = to_middle / distance;
  // The circle in which the cone from the apex touches the ball.
  double back = 0.0, radius = light.radius;
  if (apex) {
    if (!(distance > light.radius)) return {};
    back = light.radius * light.radius / distance;
    radius = light.radius * std::sqrt(1.0 - back / distance);
  }
  const glm::dvec3 u = glm::normalize(
      glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  return {circle(light.position - back * axis, radius * u, radius * glm::cross(axis, u))};
}

bool may_show(const PreparedLight& light, glm::dvec3 apex, glm::dvec3 axis, double half_angle) {
  if (light.shape != LightShape::polygon && light.shape != LightShape::disk &&
      light.shape != LightShape::ball)
    return false;
  const double radius = light.radius + glm::length(light.half_u) + glm::length(light.half_v);
  const glm::dvec3 to_middle = light.position - apex;
  const double distance = glm::length(to_middle);
  if (!(distance > radius)) return true;
  const double away = std::acos(std::clamp(glm::dot(to_middle, axis) / distance, -1.0, 1.0));
  return away <= half_angle + std::asin(radius / distance);
}

}  // namespace asos
