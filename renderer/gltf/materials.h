#pragma once

#include "renderer/gltf/images.h"

#include <cstddef>
#include <set>
#include <vector>

namespace asos::gltf {

/// Takes over all of a document's materials, in the document's order. A value out of range is
/// brought into it with a warning. `moving`: those whose values change with time, which have all of
/// their textures whether these show or not.
[[nodiscard]] std::vector<Material> import_materials(Document& document, Textures& textures,
                                                     const std::set<std::size_t>& moving = {});

}  // namespace asos::gltf
