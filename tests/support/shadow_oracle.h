#pragma once

#include "renderer/lights/form_factor.h"
#include "renderer/lights/receiver.h"
#include "renderer/world/world.h"
#include "tests/support/tiny_world.h"

#include <glm/glm.hpp>

#include <cmath>
#include <vector>

// The part of a flat light that a receiver sees between convex occluders, by clipping the light.

namespace asos::test {

using Polygon3 = std::vector<glm::dvec3>;

/// The part of a convex polygon where dot(normal, p - origin) >= 0.
[[nodiscard]] inline Polygon3 clip(const Polygon3& polygon, glm::dvec3 normal, glm::dvec3 origin) {
  Polygon3 kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 p = polygon[i];
    const glm::dvec3 q = polygon[(i + 1) % polygon.size()];
    const double hp = glm::dot(normal, p - origin), hq = glm::dot(normal, q - origin);
    if (hp >= 0.0) kept.push_back(p);
    if ((hp < 0.0) != (hq < 0.0)) kept.push_back(p + hp / (hp - hq) * (q - p));
  }
  return kept;
}

/// The part of a convex polygon that a convex flat occluder hides from `eye`.
[[nodiscard]] inline Polygon3 hidden_part(Polygon3 polygon, const Polygon3& occluder,
                                          glm::dvec3 eye) {
  const glm::dvec3 face = glm::cross(occluder[1] - occluder[0], occluder[2] - occluder[0]);
  const double side = glm::dot(face, eye - occluder[0]) > 0.0 ? 1.0 : -1.0;
  polygon = clip(polygon, -side * face, occluder[0]);
  for (std::size_t i = 0; i < occluder.size(); ++i) {
    const glm::dvec3 a = occluder[i] - eye;
    const glm::dvec3 b = occluder[(i + 1) % occluder.size()] - eye;
    polygon = clip(polygon, -side * glm::cross(a, b), eye);
  }
  return polygon;
}

/// Projected solid angle, without sign.
[[nodiscard]] inline double form_of(const Polygon3& polygon, const Receiver& receiver) {
  return polygon.size() < 3 ? 0.0 : std::abs(polygon_form(polygon, receiver));
}

/// Projected solid angle of the rest of a convex polygon behind the occluders from number `first`
/// on: inclusion and exclusion, so that they may overlap.
[[nodiscard]] inline double seen_form(const Polygon3& polygon,
                                      const std::vector<Polygon3>& occluders,
                                      const Receiver& receiver, std::size_t first = 0) {
  if (polygon.size() < 3) return 0.0;
  double form = form_of(polygon, receiver);
  for (std::size_t i = first; i < occluders.size(); ++i)
    form -= seen_form(hidden_part(polygon, occluders[i], receiver.position), occluders, receiver,
                      i + 1);
  return form;
}

/// Adds the parallelogram corner, + a, + a + b, + b to a world; returns its rounded corners.
inline Polygon3 add_occluder(World& world, glm::dvec3 corner, glm::dvec3 a, glm::dvec3 b) {
  const std::size_t first = world.positions.size();
  add_quad(world, glm::vec3(corner), glm::vec3(a), glm::vec3(b), matte({0.5f, 0.5f, 0.5f}));
  Polygon3 polygon;
  for (std::size_t i = first; i < world.positions.size(); ++i)
    polygon.emplace_back(world.positions[i]);
  return polygon;
}

/// The outline of the rectangle, counter-clockwise around half_u x half_v.
[[nodiscard]] inline Polygon3 corners_of(const Light& rectangle) {
  const glm::dvec3 c = rectangle.position, u = rectangle.half_u, v = rectangle.half_v;
  return {c - u - v, c + u - v, c + u + v, c - u + v};
}

}  // namespace asos::test
