#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos::gltf {

/// Returns whether a primitive's mode is points or lines.
[[nodiscard]] constexpr bool is_line_or_point(int mode) {
  return mode >= 0 && mode <= 3;
}

/// Returns the triangles of glTF's modes 4 to 6 (triangles, strip, fan) over `indices`, all with
/// the winding of the specification. Extra vertices are ignored. In modes 0 to 3 (points, lines,
/// loop, strip), a segment is a triangle whose last two corners are equal, and a point is one whose
/// three corners are equal.
[[nodiscard]] std::vector<glm::uvec3> triangles_of(int mode,
                                                   const std::vector<std::uint32_t>& indices);

}  // namespace asos::gltf
