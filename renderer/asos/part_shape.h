#pragma once

#include "renderer/pyray/square.h"
#include "renderer/shading/footprint.h"

#include <glm/glm.hpp>

namespace asos {

/// The shape of what a leaf covers, around its sample at `at` in the leaf's frame. That of a square
/// for whole squares, and for parts that have no area.
[[nodiscard]] PartShape part_shape(const LeafRegion& region, glm::vec2 at);

}  // namespace asos
