#include "renderer/scene/shape.h"

#include "renderer/scene/builtin/shapes.h"
#include "renderer/scene/scene.h"

#include <fmt/format.h>

#include <cmath>

namespace asos {
namespace {

bool positive(double x) {
  return std::isfinite(x) && x > 0.0;
}

std::string not_positive(const char* name, double value) {
  return fmt::format("{} is {:g}; it must be a finite number above 0", name, value);
}

}  // namespace

std::string shape_fault(const Shape& shape) {
  switch (shape.type) {
    case Shape::Type::sphere:
    case Shape::Type::disk:
      return positive(shape.radius) ? std::string() : not_positive("radius", shape.radius);
    case Shape::Type::box:
      for (int k = 0; k < 3; ++k)
        if (!positive(shape.size[k])) return not_positive("size", shape.size[k]);
      return {};
    case Shape::Type::cylinder:
      if (!positive(shape.height)) return not_positive("height", shape.height);
      if (shape.radius_bottom == 0.0 && shape.radius_top == 0.0) return "both radii are 0";
      if (shape.radius_bottom != 0.0 && !positive(shape.radius_bottom))
        return not_positive("radiusBottom", shape.radius_bottom);
      if (shape.radius_top != 0.0 && !positive(shape.radius_top))
        return not_positive("radiusTop", shape.radius_top);
      return {};
  }
  return {};
}

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
