#pragma once

#include "renderer/scene/gltf/warnings.h"

#include <nlohmann/json.hpp>

namespace asos::gltf {

/// Writes the channels that KHR_animation_pointer aims at a node's translation, rotation, scale or
/// weights as ordinary ones; of those that it aims at anything else a warning says so. Gives
/// channels without a node the node -1, so that tinygltf keeps them and their numbers are the
/// file's. After the rest of the document was tidied.
void tidy_animations(nlohmann::json& root, Warnings& warnings);

}  // namespace asos::gltf
