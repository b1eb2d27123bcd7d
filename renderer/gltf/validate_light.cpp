#include "renderer/gltf/validate_light.h"

#include "renderer/geometry/coordinates.h"
#include "renderer/geometry/finite.h"
#include "renderer/gltf/outlines.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asos::gltf {

namespace {

constexpr double huge = std::numeric_limits<float>::max();
using std::numbers::pi;
// Largest deviation of a light's axes from a right angle, as a cosine: rounding in single
// precision.
constexpr double square_tolerance = 1e-4;

bool within(double value, double lo, double hi) {
  return value >= lo && value <= hi;  // false for NaN
}

/// Returns whether two vectors with a length are perpendicular.
bool square(glm::dvec3 a, glm::dvec3 b) {
  return std::abs(glm::dot(a, b)) <= square_tolerance * glm::length(a) * glm::length(b);
}

bool has_length(glm::dvec3 v) {
  return finite(v) && glm::length(v) > 0.0 && std::isfinite(glm::length(v));
}

std::string rectangle_fault(const Light& light) {
  if (!has_length(light.half_u) || !has_length(light.half_v)) return "has a side of no length";
  const bool upright = square(light.half_u, light.half_v) &&
                       square(light.half_u, light.direction) &&
                       square(light.half_v, light.direction);
  return upright ? "" : "has sides and a direction that are not at right angles";
}

std::string polygon_fault(const Light& light) {
  Outlines relative = light.outlines;
  for (auto& outline : relative) {
    for (glm::dvec3& p : outline) p -= light.position;
  }
  const auto flat = flatten_outlines(std::move(relative));
  if (!flat) return flat.error();
  const bool agrees = glm::dot(flat->normal, light.direction) > 1.0 - square_tolerance;
  return agrees ? "" : "has an outline that does not run counter-clockwise about its direction";
}

/// Returns the fault of a radius that may be 0.
std::string radius_fault(const Light& light) {
  return within(light.radius, 0.0, huge) ? "" : "has a radius that is no positive number";
}

/// Returns the fault of a light's place, direction or size for its type; empty if none.
std::string validate_shape(const Light& light) {
  const bool directed = light.type != Light::Type::point && light.type != Light::Type::linear;
  if (directed && !within(glm::length(light.direction), 0.999, 1.001)) {
    return "has a direction that is not of unit length";
  }
  switch (light.type) {
    case Light::Type::spot:
      if (!(light.inner_cone_rad >= 0.0 && light.inner_cone_rad <= light.outer_cone_rad &&
            light.outer_cone_rad <= 1.5707973)) {
        return "has cone angles that are not in order between 0 and 90 degrees";
      }
      [[fallthrough]];
    case Light::Type::point:
      return radius_fault(light);
    case Light::Type::linear:
      return has_length(light.half_u) ? radius_fault(light) : "has no length";
    case Light::Type::directional: {
      const bool valid = light.angular_diameter_rad >= 0.0 && light.angular_diameter_rad < pi;
      return valid ? "" : "has an angular diameter outside 0 to 180 degrees";
    }
    case Light::Type::rectangle:
      return rectangle_fault(light);
    case Light::Type::disk:
      return light.radius > 0.0 && light.radius <= huge ? ""
                                                        : "has a radius that is no positive number";
    case Light::Type::polygon:
      return polygon_fault(light);
  }
  return "has an unknown type";
}

}  // namespace

std::string validate_light(const Light& light) {
  if (!within(light.intensity, 0.0, huge)) return "has an intensity that is no positive number";
  for (int i = 0; i < 3; ++i) {
    if (!within(light.color[i], 0.0, huge)) return "has a colour that is no positive number";
  }
  if (!finite(light.position)) return "has a position that is not finite";
  if (light.type != Light::Type::directional && !within_reach(light.position))
    return fmt::format("is farther away than {:g}", largest_coordinate);
  if (!(light.range > 0.0)) return "has a range that is no positive number";
  return validate_shape(light);
}

}  // namespace asos::gltf
