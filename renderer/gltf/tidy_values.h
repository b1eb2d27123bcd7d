#pragma once

#include "renderer/gltf/warnings.h"

#include <nlohmann/json.hpp>

namespace asos::gltf {

/// Warns about invalid values of nodes, cameras, samplers, morph targets and positions, whether or
/// not they are used. Properties of wrong kinds must have been removed before. Invalid filters and
/// wrap modes are removed, so that glTF's defaults apply.
void tidy_values(nlohmann::json& root, Warnings& warnings);

}  // namespace asos::gltf
