#pragma once

#include "renderer/geometry/lens.h"
#include "renderer/gltf/tinygltf.h"
#include "renderer/gltf/warnings.h"

namespace asos::gltf {

/// Returns the lens in a perspective camera's extras (docs/manual/lens.md); a pinhole if there is
/// none. Errors describe the fault.
[[nodiscard]] Checked<Lens> read_lens(const tinygltf::Value& extras, double fov_y_rad);

}  // namespace asos::gltf
