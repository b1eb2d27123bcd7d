#pragma once

#include "renderer/gltf/document.h"

#include <string>

namespace asos::gltf {

/// The scene that a file names as its own, or else its first; -1 where it has none. What is odd
/// about that is said in the document's warnings.
[[nodiscard]] int default_scene(Document& document);

/// The scene of this number, from 0, or else the first of this name. The fault lists those that
/// there are.
[[nodiscard]] Checked<int> find_scene(const Document& document, const std::string& wanted);

}  // namespace asos::gltf
