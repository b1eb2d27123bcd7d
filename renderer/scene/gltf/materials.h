#pragma once

#include "renderer/scene/gltf/images.h"

namespace asos::gltf {

/// Takes over all of a document's materials, in the document's order. A value out of range is
/// brought into it with a warning.
void import_materials(Document& document, Textures& textures, Scene& scene);

}  // namespace asos::gltf
