#pragma once

#include "renderer/scene/scene.h"

#include <string>

namespace asos::gltf {

/// Returns why `light` does not satisfy the requirements of its type in scene.h, in words that
/// follow its name; empty if it does. The lights that the importer adds and those that the exporter
/// writes have no fault.
[[nodiscard]] std::string validate_light(const Light& light);

}  // namespace asos::gltf
