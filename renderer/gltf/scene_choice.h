#pragma once

#include "renderer/gltf/document.h"

#include <string>

namespace asos::gltf {

/// Returns the scene that a file selects, or else its first; -1 if it has none. Irregularities
/// become warnings of the document.
[[nodiscard]] int default_scene(Document& document);

/// Returns the scene with this number, from 0, or else the first with this name. The fault lists
/// the existing scenes.
[[nodiscard]] Checked<int> find_scene(const Document& document, const std::string& wanted);

}  // namespace asos::gltf
