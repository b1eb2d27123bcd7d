#pragma once

#include "renderer/comparison/exact_visibility.h"

#include <glm/glm.hpp>

namespace asos {

/// Returns the exact area of the intersection of a convex polygon and a disk.
[[nodiscard]] double area_in_disk(const ConvexPolygon& polygon, glm::dvec2 centre, double radius);

}  // namespace asos
