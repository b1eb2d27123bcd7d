#pragma once

#include <string>
#include <string_view>

namespace asos::fuzz {

/// Mutates a glTF file (.glb, or .gltf as text) in its JSON or in the numbers of its binary chunk.
/// The result is still a container, often still a scene, with unusual values. Empty if the input is
/// no glTF file.
[[nodiscard]] std::string mutated_gltf(std::string_view file, unsigned seed);

}  // namespace asos::fuzz
