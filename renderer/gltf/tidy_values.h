#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

namespace asos::gltf {

/// Warns about invalid values of cameras, samplers and morph targets, whether or not they are used.
/// `root`: after properties of wrong kinds were removed. Invalid filters and wrap modes are
/// removed, so that glTF's defaults apply.
void tidy_values(nlohmann::json& root, Warnings& warnings);

}  // namespace asos::gltf
