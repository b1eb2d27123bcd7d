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
  Part part{.first_triangle = static_cast<std::uint32_t>(world.triangles.size()),
            .material = static_cast<std::uint32_t>(world.materials.size())};
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
  return {.type = Shape::Type::sphere, .radius = radius};
}

inline Shape disk(double radius) {
  Shape shape = sphere(radius);
  shape.type = Shape::Type::disk;
  return shape;
}

inline Shape cylinder(double height, double bottom, double top) {
  return {
      .type = Shape::Type::cylinder, .height = height, .radius_bottom = bottom, .radius_top = top};
}

}  // namespace asos::test
