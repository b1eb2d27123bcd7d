#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

namespace asos::gltf {

/// Converts channels by KHR_animation_pointer. Pointers to a node's translation, rotation, scale or
/// weights become ordinary channels. Channels that point to a node's visibility or a single weight
/// get that node as target. Pointers to existing values of animated_values.h stay the same. All
/// others are removed with a warning. Channels without a node get the node -1, so that tinygltf
/// keeps them and all channels keep the file's indices. Must be called after the rest of the
/// document was tidied.
void tidy_animations(nlohmann::json& root, Warnings& warnings);

/// Returns whether a tidied document has channels that move values of animated_values.h.
[[nodiscard]] bool moves_values(const nlohmann::json& root);

}  // namespace asos::gltf
