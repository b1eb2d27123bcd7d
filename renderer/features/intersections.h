#pragma once

#include "renderer/scene/world.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos {

/// A straight piece of a line along which two triangles pass through each other.
struct IntersectionLine {
  glm::vec3 a;
  glm::vec3 b;
  std::uint32_t first_triangle = 0;
  std::uint32_t second_triangle = 0;
};

struct Intersections {
  std::vector<IntersectionLine> lines;  ///< ordered by their triangles
  bool complete = true;  ///< false: more than the budget; `lines` is empty, and the safety net has
                         ///< to find what the samples show of them
};

/// Finds where surfaces of a world pass through each other (design section 3): no mesh edge marks
/// these lines. Triangles that only touch or overlap in one plane have none, and neighbours in a
/// mesh are passed over. Pairs are found by Embree's collision of bounding hierarchies. The
/// result does not depend on threads. `max_lines` bounds the memory for scenes that are nothing
/// but intersections.
[[nodiscard]] Intersections find_intersections(const World& world, std::size_t max_lines);

}  // namespace asos
