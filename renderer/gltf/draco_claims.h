#pragma once

#include "renderer/gltf/document.h"

#include <cstdint>

namespace asos::gltf {

/// How many faces a Draco stream says that it holds. The decoder allocates what the stream claims
/// before it finds out that the data is not there, so the claim is read first. Faults: not a mesh
/// of bitstream version 2, or cut off.
[[nodiscard]] Checked<std::uint64_t> claimed_draco_faces(Bytes stream);

}  // namespace asos::gltf
