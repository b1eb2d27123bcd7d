#pragma once

#include "renderer/geometry/shape.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

/// One smooth face of an analytic shape, placed in the world by an affine map of a unit surface.
/// The unit surface is the sphere of radius 1, the disk of radius 1 in y = 0, or the side of a cone
/// around +Y between y = 0 and y = 1, whose larger radius is 1. Stretched shapes are therefore as
/// exact as others.
///
/// Its points have coordinates (u, v) from 0 to 1, which are also its texture coordinates: around
/// +Y and from the top down, or along x and z for a disk.
struct ShapeFace {
  enum class Kind : std::uint8_t { sphere, disk, side };

  Kind kind = Kind::sphere;
  double bottom = 1.0;  ///< side: radius at y = 0
  double top = 1.0;
  glm::dmat3 world_from_unit{1.0};
  glm::dvec3 origin{0.0};           ///< the unit surface's origin in the world
  glm::dmat3 unit_from_world{1.0};  ///< inverse of world_from_unit
  std::uint32_t part = 0;           ///< index into World::parts
  double size = 0.0;                ///< the largest side of its box

  [[nodiscard]] double radius_at(double y) const { return bottom + (top - bottom) * y; }
  [[nodiscard]] glm::dvec3 world(glm::dvec3 unit) const { return origin + world_from_unit * unit; }
  [[nodiscard]] glm::dvec3 unit(glm::dvec3 world) const {
    return unit_from_world * (world - origin);
  }
  /// Returns a unit surface's normal in the world; outward normals stay outward. Any length.
  [[nodiscard]] glm::dvec3 world_normal(glm::dvec3 n) const {
    return glm::transpose(unit_from_world) * n;
  }
  bool operator==(const ShapeFace&) const = default;
};

/// A point of a face with its derivatives by u and v, in world units. `normal` points outwards and
/// is unit. `normal_u` and `normal_v` are the derivatives of a vector that equals the normal there.
/// At a pole or an apex, `along_u` is not 0 but has the direction of its limit.
struct FacePoint {
  glm::dvec3 position{0.0};
  glm::dvec3 along_u{0.0}, along_v{0.0};
  glm::dvec3 normal{0.0};
  glm::dvec3 normal_u{0.0}, normal_v{0.0};
};
[[nodiscard]] FacePoint face_point(const ShapeFace& face, double u, double v);

/// Returns (u, v) of a point of the unit surface.
[[nodiscard]] glm::dvec2 face_coordinates(const ShapeFace& face, glm::dvec3 unit);

/// Returns the faces of a shape of any type but box, in an order that depends on its type only: a
/// cylinder's side, then its bottom and top if they have a radius. Empty if `world_from_shape` has
/// no inverse in double precision.
[[nodiscard]] std::vector<ShapeFace> place_shape(const Shape& shape,
                                                 const glm::dmat4& world_from_shape);

/// Returns the half extents, by coordinate, of the box around the ellipse origin + cos a + sin b.
[[nodiscard]] inline glm::dvec3 ellipse_reach(glm::dvec3 a, glm::dvec3 b) {
  return glm::sqrt(a * a + b * b);
}

/// Two opposite corners of the smallest axis-aligned box around a face.
struct FaceBounds {
  glm::dvec3 lo, hi;
};
[[nodiscard]] FaceBounds bounds_of(const ShapeFace& face);

}  // namespace asos
