#pragma once

#include "renderer/gltf/tinygltf.h"
#include "renderer/gltf/warnings.h"
#include "renderer/scene/scene.h"

#include <optional>

namespace asos::gltf {

/// How a material's extras say that its reflections are blurred (MATERIALS.md): nothing where they
/// do not, an error in words where they say anything that is not a Dfr.
[[nodiscard]] Checked<std::optional<Dfr>> read_dfr(const tinygltf::Value& extras);

}  // namespace asos::gltf
