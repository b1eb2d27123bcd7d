#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

namespace asos::gltf {

/// Says which values of cameras, samplers and morph targets are none that glTF has, whether or not
/// anything uses them. `root`: after wrong kinds have been taken out. Filters and ways to wrap that
/// are none are taken out, too, so that glTF's defaults stand for them.
void tidy_values(nlohmann::json& root, Warnings& warnings);

}  // namespace asos::gltf
