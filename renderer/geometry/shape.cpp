#include "renderer/geometry/shape.h"

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

std::string validate_shape(const Shape& shape) {
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

}  // namespace asos
