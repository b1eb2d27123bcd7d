#pragma once

#include <string>
#include <string_view>

namespace asos::fuzz {

/// A glTF file (.glb, or .gltf as text) with some changes to its JSON or to the numbers in its
/// binary chunk: still a container, often still a scene, with values that nobody means. Empty where
/// the file is none to begin with.
[[nodiscard]] std::string mutated_gltf(std::string_view file, unsigned seed);

}  // namespace asos::fuzz
