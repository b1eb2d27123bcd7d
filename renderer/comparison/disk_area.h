#pragma once

#include "renderer/comparison/exact_visibility.h"

#include <glm/glm.hpp>

namespace asos {

/// The area that a convex polygon and a disk share: exact.
[[nodiscard]] double area_in_disk(const ConvexPolygon& polygon, glm::dvec2 centre, double radius);

}  // namespace asos
