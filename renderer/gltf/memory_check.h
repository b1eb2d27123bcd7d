#pragma once

#include "renderer/gltf/warnings.h"

#include <cstdint>

namespace asos::gltf {

/// Returns the bytes of memory of this machine.
[[nodiscard]] std::uint64_t memory_of_machine();

/// Returns an error if the triangles and objects need more than `most` bytes of memory, in which
/// case the system would end the program. The estimate is a lower bound.
[[nodiscard]] Checked<void> check_memory(std::uint64_t triangles, std::uint64_t objects,
                                         std::uint64_t most);

}  // namespace asos::gltf
