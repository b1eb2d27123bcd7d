#pragma once

#include <glm/glm.hpp>

#include <string>

namespace asos {

/// An analytic shape in its own space, as KHR_implicit_shapes has them (gltf/SHAPES.md): its
/// middle at the origin, round ones around +Y. A cylinder of two radii is a truncated cone, one of
/// which a radius is 0 a cone. A disk lies in the plane y = 0 and faces +Y; the others are closed.
struct Shape {
  enum class Type { sphere, disk, box, cylinder };

  Type type = Type::sphere;
  double radius = 0.5;          ///< sphere, disk
  glm::dvec3 size{1.0};         ///< box: full extents
  double height = 0.5;          ///< cylinder
  double radius_bottom = 0.25;  ///< cylinder: at y = -height / 2
  double radius_top = 0.25;

  bool operator==(const Shape&) const = default;
};

/// Why a shape is none; empty if it is one. Sizes must be finite and above 0; one radius of a
/// cylinder may be 0.
[[nodiscard]] std::string shape_fault(const Shape& shape);

}  // namespace asos
