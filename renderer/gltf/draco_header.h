#pragma once

#include "renderer/gltf/document.h"

#include <cstdint>

namespace asos::gltf {

/// Returns the number of faces that a Draco stream claims to contain. The decoder allocates memory
/// for the claim before it finds out that data is missing, so the claim is read first. Faults: not
/// a mesh of bitstream version 2, or cut off.
[[nodiscard]] Checked<std::uint64_t> claimed_draco_faces(Bytes stream);

}  // namespace asos::gltf
