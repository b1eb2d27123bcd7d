#pragma once

#include "renderer/world/world.h"
#include "tests/support/tiny_world.h"

#include <glm/glm.hpp>

#include <cstdint>

// Adds analytic shapes to worlds built by hand.

namespace asos::test {

/// Adds a shape; all triangles must precede.
inline void add_shape(World& world, const Shape& shape, const glm::dmat4& world_from_shape,
                      const Material& material) {
  Part part;
  part.first_triangle = static_cast<std::uint32_t>(world.triangles.size());
  part.material = static_cast<std::uint32_t>(world.materials.size());
  world.materials.push_back(material);
  for (ShapeFace face : place_shape(shape, world_from_shape)) {
    face.part = static_cast<std::uint32_t>(world.parts.size());
    world.triangle_part.push_back(face.part);
    world.faces.push_back(face);
    ++part.face_count;
    const FaceBounds box = bounds_of(face);
    part.bounds.grow(glm::vec3(box.lo));
    part.bounds.grow(glm::vec3(box.hi));
  }
  world.bounds.grow(part.bounds);
  world.parts.push_back(part);
}

inline Shape sphere(double radius) {
  Shape shape;
  shape.type = Shape::Type::sphere;
  shape.radius = radius;
  return shape;
}

inline Shape disk(double radius) {
  Shape shape = sphere(radius);
  shape.type = Shape::Type::disk;
  return shape;
}

inline Shape cylinder(double height, double bottom, double top) {
  Shape shape;
  shape.type = Shape::Type::cylinder;
  shape.height = height;
  shape.radius_bottom = bottom;
  shape.radius_top = top;
  return shape;
}

}  // namespace asos::test
