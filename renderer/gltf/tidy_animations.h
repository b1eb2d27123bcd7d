#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

namespace asos::gltf {

/// Writes the channels that KHR_animation_pointer aims at a node's translation, rotation, scale or
/// weights as ordinary ones. Those that it aims at a node's visibility or a single weight get that
/// node, and those at what moved_values.h knows and the document has stay as they are; of all
/// others a warning says that they are left, and their pointers are taken out. Gives channels
/// without a node the node -1, so that tinygltf keeps them and their numbers are the file's. After
/// the rest of the document was tidied.
void tidy_animations(nlohmann::json& root, Warnings& warnings);

/// Whether a tidied document has channels that aim at values.
[[nodiscard]] bool moves_values(const nlohmann::json& root);

}  // namespace asos::gltf
