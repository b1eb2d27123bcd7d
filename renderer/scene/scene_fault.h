#pragma once

#include "renderer/scene/scene.h"

#include <cstdint>
#include <string>

namespace asos {

/// As many vertices as 32 bits count, less what marks that there is none.
inline constexpr std::uint64_t largest_vertex_count = 0xfffffffeu;

/// The promises of scene.h that a scene breaks: indices in range, arrays of one length, sizes of
/// shapes. Empty if nothing.
[[nodiscard]] std::string scene_fault(const Scene& scene);

}  // namespace asos
