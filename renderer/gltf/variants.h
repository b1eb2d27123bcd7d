#pragma once

#include "renderer/gltf/document.h"

#include <string>

namespace asos::gltf {

/// Gives the document's primitives the materials of one of its variants (KHR_materials_variants);
/// primitives without a mapping keep their own. Mappings with invalid references are left out with
/// a warning. Fault: there is no variant of that name; the message lists the existing ones.
[[nodiscard]] Checked<void> choose_variant(Document& document, const std::string& name);

}  // namespace asos::gltf
