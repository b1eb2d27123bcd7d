#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos::gltf {

/// Whether a primitive's mode is of points or lines.
[[nodiscard]] constexpr bool is_stroke(int mode) {
  return mode >= 0 && mode <= 3;
}

/// The triangles of glTF's modes 4 to 6 (triangles, strip, fan) over `indices`, all turned the way
/// that the specification says. Left-over vertices are ignored. Of modes 0 to 3 (points, lines,
/// loop, strip) a segment comes as a triangle whose last two corners are one, and a point as one
/// whose three are.
[[nodiscard]] std::vector<glm::uvec3> triangles_of(int mode,
                                                   const std::vector<std::uint32_t>& indices);

}  // namespace asos::gltf
