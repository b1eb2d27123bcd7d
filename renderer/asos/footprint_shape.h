#pragma once

#include "renderer/pyray/square.h"
#include "renderer/shading/footprint.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos {

/// Returns the shape that a leaf covers, relative to its sample at `at` in the leaf's frame. Whole
/// squares, and parts without area, have the shape of a square.
[[nodiscard]] FootprintShape footprint_shape(const LeafRegion& region, glm::vec2 at);

/// Appends the shapes of the parts of a region with a border, in a grid of n x n over its bounding
/// rectangle; n is at most 8. Parts of negligible area are left out. Appends nothing if the region
/// has no area.
void add_footprint_shapes(const LeafRegion& region, glm::vec2 at, int n,
                          std::vector<WeightedShape>& shapes);

}  // namespace asos
