#pragma once

#include "renderer/scene/world.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// Whether a ray along `direction` that meets a triangle meets its back. The front is where the
/// corners run counter-clockwise (glTF 2.0, section 3.7.2.1; `flatten` has turned the triangles of
/// mirrored instances). In double precision, so that triangles which face away by a hair are told
/// apart the same way however they were met; a triangle seen edge-on, or of no area, has no back.
[[nodiscard]] inline bool meets_back(const World& world, std::uint32_t triangle,
                                     glm::vec3 direction) {
  const glm::uvec3 corners = world.triangles[triangle];
  const glm::dvec3 p0(world.positions[corners.x]);
  const glm::dvec3 e1 = glm::dvec3(world.positions[corners.y]) - p0;
  const glm::dvec3 e2 = glm::dvec3(world.positions[corners.z]) - p0;
  return glm::dot(glm::cross(e1, e2), glm::dvec3(direction)) > 0.0;
}

}  // namespace asos
