#include "renderer/scene/tessellate.h"

#include "renderer/scene/builtin/shapes.h"

namespace asos {

Mesh tessellated(const Shape& shape) {
  constexpr int sides = 128;
  constexpr int sphere_rows = 24;
  Mesh mesh;
  const auto radius = static_cast<float>(shape.radius);
  const auto half_height = static_cast<float>(0.5 * shape.height);
  switch (shape.type) {
    case Shape::Type::sphere:
      builtin::add_sphere(mesh, glm::vec3(0.0f), radius, sphere_rows);
      break;
    case Shape::Type::disk:
      builtin::add_disk(mesh, glm::vec3(0.0f), {0, 1, 0}, radius, sides);
      break;
    case Shape::Type::box:
      builtin::add_box(mesh, glm::vec3(-0.5 * shape.size), glm::vec3(0.5 * shape.size));
      break;
    case Shape::Type::cylinder:
      builtin::add_frustum(mesh, {0, -half_height, 0}, {0, half_height, 0},
                           static_cast<float>(shape.radius_bottom),
                           static_cast<float>(shape.radius_top), sides);
      break;
  }
  return mesh;
}

}  // namespace asos
