#pragma once

#include "renderer/scene/scene.h"

#include <cstdint>
#include <string>

namespace asos {

/// Largest number of vertices with 32-bit indices; the index 0xffffffff means none.
inline constexpr std::uint64_t largest_vertex_count = 0xfffffffeu;

/// Returns the first violated invariant of scene.h: indices in range, arrays of equal length, sizes
/// of shapes. Empty if there is none.
[[nodiscard]] std::string validate_scene(const Scene& scene);

}  // namespace asos
