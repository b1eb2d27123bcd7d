#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace asos::gltf {

/// The triangles of glTF's modes 4 to 6 (triangles, strip, fan) over `indices`, all turned the way
/// that the specification says. Left-over vertices are ignored.
[[nodiscard]] std::vector<glm::uvec3> triangles_of(int mode,
                                                   const std::vector<std::uint32_t>& indices);

}  // namespace asos::gltf
