#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/world/hit_plane.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// Returns whether a ray along `direction` hits the back of a triangle. On the front, the corners
/// run counter-clockwise (glTF 2.0, section 3.7.2.1; `flatten` has turned the triangles of mirrored
/// instances). Double precision makes the result the same for all queries, even for triangles seen
/// almost edge-on. A triangle seen exactly edge-on, or without area, has no back.
[[nodiscard]] inline bool meets_back(const World& world, std::uint32_t triangle,
                                     glm::vec3 direction) {
  return glm::dot(plane_of_triangle(world, triangle).normal(), glm::dvec3(direction)) > 0.0;
}

/// Returns whether a ray meets the back at a hit. The front of an analytic shape is outside; of a
/// disk, towards +Y.
[[nodiscard]] inline bool meets_back(const World& world, const Hit& hit, glm::vec3 direction) {
  if (!world.is_face(hit.triangle)) return meets_back(world, hit.triangle, direction);
  const FacePoint at = face_point(world.face(hit.triangle), hit.b1, hit.b2);
  return glm::dot(at.normal, glm::dvec3(direction)) > 0.0;
}

}  // namespace asos
