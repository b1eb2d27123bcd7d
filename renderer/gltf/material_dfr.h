#pragma once

#include "renderer/gltf/tinygltf.h"
#include "renderer/gltf/warnings.h"
#include "renderer/scene/scene.h"

#include <optional>

namespace asos::gltf {

/// Returns the defocusing ratios in a material's extras (MATERIALS.md): nothing if there are none,
/// an error with a description if they are no valid Dfr.
[[nodiscard]] Checked<std::optional<Dfr>> read_dfr(const tinygltf::Value& extras);

}  // namespace asos::gltf
