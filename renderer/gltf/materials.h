#pragma once

#include "renderer/gltf/images.h"

#include <cstddef>
#include <set>
#include <vector>

namespace asos::gltf {

/// Imports all of a document's materials, in the document's order. A value out of range is clamped
/// with a warning. `moving` are those whose values change with time; all of their textures are
/// imported, even if they are not visible now.
[[nodiscard]] std::vector<Material> import_materials(Document& document, Textures& textures,
                                                     const std::set<std::size_t>& moving = {});

}  // namespace asos::gltf
