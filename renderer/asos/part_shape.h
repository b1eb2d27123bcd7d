#pragma once

#include "renderer/pyray/square.h"
#include "renderer/shading/footprint.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos {

/// The shape of what a leaf covers, around its sample at `at` in the leaf's frame. That of a square
/// for whole squares, and for parts that have no area.
[[nodiscard]] PartShape part_shape(const LeafRegion& region, glm::vec2 at);

/// The same of the parts of a region with a border in a grid of n x n over the rectangle around it,
/// but of those that are next to nothing; n is at most 8. Nothing where it has no area.
void add_part_shapes(const LeafRegion& region, glm::vec2 at, int n,
                     std::vector<SharedShape>& shapes);

}  // namespace asos
