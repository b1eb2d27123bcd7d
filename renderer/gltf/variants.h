#pragma once

#include "renderer/gltf/document.h"

#include <string>

namespace asos::gltf {

/// Gives the document's primitives the materials of one of its variants (KHR_materials_variants);
/// those that it does not map keep their own. Mappings that name what does not exist are left out
/// with a warning. Fault: there is no variant of that name; it lists those that there are.
[[nodiscard]] Checked<void> choose_variant(Document& document, const std::string& name);

}  // namespace asos::gltf
