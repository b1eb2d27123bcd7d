#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

namespace asos::gltf {

/// Converts channels by KHR_animation_pointer. Pointers to a node's translation, rotation, scale or
/// weights become ordinary channels. Pointers to a node's visibility or a single weight get that
/// node. Pointers to existing values of animated_values.h stay the same. All others are removed
/// with a warning. Channels without a node get the node -1, so that tinygltf keeps them and their
/// numbers are the file's. Must be called after the rest of the document was tidied.
void tidy_animations(nlohmann::json& root, Warnings& warnings);

/// Returns whether a tidied document has channels that move values.
[[nodiscard]] bool moves_values(const nlohmann::json& root);

}  // namespace asos::gltf
