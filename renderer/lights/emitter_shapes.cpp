#include "renderer/lights/emitter_shapes.h"

#include "renderer/lights/light_math.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

using std::numbers::pi;

/// Sets colour and intensity. Returns nullopt if the intensity is 0 or does not fit a float.
std::optional<Light> shining(Light light, glm::dvec3 strength) {
  const double intensity = std::max({strength.x, strength.y, strength.z});
  light.intensity = static_cast<float>(intensity);
  if (!(light.intensity > 0.0f) || !std::isfinite(light.intensity)) return std::nullopt;
  light.color = glm::vec3(strength / intensity);
  return light;
}

/// A ball of radiance L and area A has A L / 4 candela: it looks like a disk of pi r^2, and its
/// area is 4 pi r^2.
std::optional<Light> ball(const Moments& moments, double sides) {
  Light light;
  light.type = Light::Type::point;
  light.position = moments.centre;
  light.radius = std::sqrt(moments.area / (4.0 * pi));
  return shining(light, sides * moments.power / 4.0);
}

/// A tube's extents along and across an axis through its centre.
struct TubeMeasures {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double outward = 0.0;  ///< mean of the normal's component away from the axis

  TubeMeasures(std::span<const EmitterTriangle> triangles, const Piece& piece, glm::dvec3 middle,
               glm::dvec3 axis) {
    double distance = 0.0;
    for (const std::uint32_t i : piece) {
      const EmitterTriangle& t = triangles[i];
      for (const glm::dvec3& p : t.corner) {
        low = std::min(low, glm::dot(p - middle, axis));
        high = std::max(high, glm::dot(p - middle, axis));
      }
      const glm::dvec3 d = t.middle() - middle;
      const glm::dvec3 across = d - glm::dot(d, axis) * axis;
      outward += t.area * glm::dot(t.normal, across);
      distance += t.area * glm::length(across);
    }
    outward = distance > 0.0 ? outward / distance : 0.0;
  }
};

}  // namespace

std::optional<Light> ball_light(const Moments& moments) {
  constexpr double most_open = 0.2;
  constexpr double least_outward = 0.8;
  if (glm::length(moments.area_vector) > most_open * moments.area) return std::nullopt;
  if (moments.outward < least_outward) return std::nullopt;
  const glm::dvec3 normals = principal_axes(moments.normals).value;
  const glm::dvec3 spread = principal_axes(moments.spread).value;
  // For a sphere each is a third. A ball is less than twice as long as wide.
  if (normals.x > 0.5 || normals.z < 0.2 || spread.z < 0.25 * spread.x) return std::nullopt;
  return ball(moments, 1.0);
}

std::optional<Light> tube_light(std::span<const EmitterTriangle> triangles, const Piece& piece,
                                const Moments& moments) {
  constexpr double least_slenderness = 4.0;  // length to diameter
  const PrincipalAxes spread = principal_axes(moments.spread);
  const glm::dvec3 axis = spread.axis[0];
  const TubeMeasures tube(triangles, piece, moments.centre, axis);
  const double length = tube.high - tube.low;
  const double radius = moments.area / (2.0 * pi * length);
  if (!(length >= least_slenderness * 2.0 * radius)) return std::nullopt;
  if (glm::length(moments.area_vector) > 0.2 * moments.area || tube.outward < 0.8)
    return std::nullopt;
  // A bent tube is farther from its axis than its radius, and a flat one faces two ways.
  const double off_axis = std::sqrt(spread.value.y + spread.value.z);
  if (!(off_axis < 1.3 * radius) || spread.value.z < 0.4 * spread.value.y) return std::nullopt;
  if (glm::dot(axis, moments.normals * axis) > 0.2) return std::nullopt;
  if (principal_axes(moments.normals).value.y < 0.25) return std::nullopt;

  Light light;
  light.type = Light::Type::linear;
  light.position = moments.centre + 0.5 * (tube.low + tube.high) * axis;
  light.half_u = 0.5 * length * axis;
  // A tube emits with the sine of the angle to the line, so its power is pi^2 candela. Hence pi L A
  // is A L / pi candela.
  return shining(light, moments.power / pi);
}

std::optional<Light> one_light(const Moments& moments, bool two_sided, Extent extent) {
  const double facing = glm::length(moments.area_vector);
  if (facing < 0.5 * moments.area) return ball(moments, two_sided ? 2.0 : 1.0);
  Light light;
  light.type = Light::Type::rectangle;
  light.position = moments.centre;
  light.direction = moments.area_vector / facing;
  light.two_sided = two_sided;

  // The spread within the rectangle's plane; a rectangle of sides 2 a has a variance of a^2 / 3.
  const glm::dmat3 flat = glm::dmat3(1.0) - glm::outerProduct(light.direction, light.direction);
  const PrincipalAxes axes = principal_axes(flat * moments.spread * flat);
  double half_u = std::sqrt(3.0 * std::max(0.0, axes.value.x));
  double half_v = std::sqrt(3.0 * std::max(0.0, axes.value.y));
  const glm::dvec3 u = axes.value.x > 0.0 ? axes.axis[0] : any_perpendicular(light.direction);
  if (!(half_u > 0.0)) half_u = std::sqrt(moments.area / 4.0);
  if (!(half_v > 0.0)) half_v = moments.area / (4.0 * half_u);
  const double spread_area = 4.0 * half_u * half_v;
  const double area = extent == Extent::spread ? std::max(moments.area, spread_area) : moments.area;
  const double grow = std::sqrt(area / spread_area);
  light.half_u = grow * half_u * u;
  light.half_v = grow * half_v * glm::cross(light.direction, u);
  return shining(light, moments.power / area);
}

}  // namespace asos
