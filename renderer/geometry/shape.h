#pragma once

#include <glm/glm.hpp>

#include <string>

namespace asos {

/// An analytic shape in its own space, as in KHR_implicit_shapes (gltf/SHAPES.md). Its centre is
/// the origin, and round shapes have the axis +Y. A cylinder with two different radii is a
/// truncated cone, or a cone if one of them is 0. A disk lies in the plane y = 0 and faces +Y; the
/// others are closed.
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

/// Returns why a shape is invalid; empty if it is valid. Sizes must be finite and above 0; one
/// radius of a cylinder may be 0.
[[nodiscard]] std::string validate_shape(const Shape& shape);

}  // namespace asos
