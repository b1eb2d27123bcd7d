#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/world/hit_plane.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// Whether a ray along `direction` that meets a triangle meets its back. The front is where the
/// corners run counter-clockwise (glTF 2.0, section 3.7.2.1; `flatten` has turned the triangles of
/// mirrored instances). In double precision, so that triangles which face away by a hair are told
/// apart the same way however they were met; a triangle seen edge-on, or of no area, has no back.
[[nodiscard]] inline bool meets_back(const World& world, std::uint32_t triangle,
                                     glm::vec3 direction) {
  return glm::dot(plane_of_triangle(world, triangle).normal(), glm::dvec3(direction)) > 0.0;
}

/// The same of what a ray met: the front of an analytic shape is outside, or towards +Y of a disk.
[[nodiscard]] inline bool meets_back(const World& world, const Hit& hit, glm::vec3 direction) {
  if (!world.is_face(hit.triangle)) return meets_back(world, hit.triangle, direction);
  const FacePoint at = face_point(world.face(hit.triangle), hit.b1, hit.b2);
  return glm::dot(at.normal, glm::dvec3(direction)) > 0.0;
}

}  // namespace asos
