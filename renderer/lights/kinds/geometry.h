#pragma once

#include "renderer/lights/kinds/shared.h"
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
/// not compile. All have `form`, the projected solid angle times the spot's cone and range.
/// Shapes with Sampling::lanes_or_scalar have `numbers`. Shapes with an area have `add_patches` and
/// `window`. Shapes with a surface have `meet` and `outlines`, and `way` if they are not flat.
template <LightShape shape>
struct LightGeometry;

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

/// A sample of a light in double precision, for SharedGeometry; u and v are 0 to 1.
template <LightShape shape>
struct SampleQuery {
  const PreparedLight& light;
  const Receiver& receiver;
  glm::dvec2 uv;
  glm::dvec3 middle = light.position - receiver.position;

  [[nodiscard]] double u() const { return 2.0 * uv.x - 1.0; }
  [[nodiscard]] double v() const { return 2.0 * uv.y - 1.0; }
  [[nodiscard]] glm::dvec2 on_disk() const { return concentric(uv.x, uv.y); }
  [[nodiscard]] static glm::dvec3 vector(glm::dvec3 v) { return v; }
  [[nodiscard]] Numbers<double> numbers() const {
    if constexpr (traits_of(shape).sampling != Sampling::lanes_or_scalar) {
      return SharedGeometry<shape>::numbers(light, receiver, middle, uv.x, uv.y);
    } else {
      const glm::dvec4 n = LightGeometry<shape>::numbers(light, receiver, uv.x, uv.y);
      return {n.x, n.y, n.z, n.w};
    }
  }
};

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
