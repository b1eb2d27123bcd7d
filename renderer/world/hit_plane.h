#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// The plane of a hit's surface in the hit's coordinates (b1, b2): the point is corner + b1 * edge1
/// + b2 * edge2. For a triangle it is the triangle's plane. For a face of an analytic shape it is
/// the tangent plane at (b1, b2), where the point is on the face to double precision.
struct HitPlane {
  glm::dvec3 corner{0.0};
  glm::dvec3 edge1{0.0};
  glm::dvec3 edge2{0.0};

  /// Returns the normal, of any length; 0 for a triangle without area. A triangle's corners run
  /// counter-clockwise around its normal; a face's normal points outwards or inwards.
  [[nodiscard]] glm::dvec3 normal() const { return glm::cross(edge1, edge2); }
  [[nodiscard]] glm::dvec3 point(float b1, float b2) const {
    return corner + static_cast<double>(b1) * edge1 + static_cast<double>(b2) * edge2;
  }
};

[[nodiscard]] inline HitPlane plane_of_triangle(const World& world, std::uint32_t triangle) {
  const glm::uvec3 v = world.triangles[triangle];
  const glm::dvec3 p0(world.positions[v.x]);
  return {p0, glm::dvec3(world.positions[v.y]) - p0, glm::dvec3(world.positions[v.z]) - p0};
}

[[nodiscard]] inline HitPlane hit_plane(const World& world, const Hit& hit) {
  if (!world.is_face(hit.triangle)) return plane_of_triangle(world, hit.triangle);
  const double u = hit.b1, v = hit.b2;
  const FacePoint p = face_point(world.face(hit.triangle), u, v);
  return {p.position - u * p.along_u - v * p.along_v, p.along_u, p.along_v};
}

}  // namespace asos
