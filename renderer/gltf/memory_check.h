#pragma once

#include "renderer/gltf/warnings.h"

#include <cstdint>

namespace asos::gltf {

/// Bytes of memory that this machine has.
[[nodiscard]] std::uint64_t memory_of_machine();

/// Why so many triangles in so many objects cannot be shown with `most` bytes of memory, where the
/// system would end the program. What they take is estimated from below.
[[nodiscard]] Checked<void> check_memory(std::uint64_t triangles, std::uint64_t objects,
                                         std::uint64_t most);

}  // namespace asos::gltf
