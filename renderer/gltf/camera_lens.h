#pragma once

#include "renderer/geometry/lens.h"
#include "renderer/gltf/tinygltf.h"
#include "renderer/gltf/warnings.h"

namespace asos::gltf {

/// The lens that a perspective camera has in its extras (docs/manual/lens.md); a pinhole where
/// there is none. Errors: what is wrong with it.
[[nodiscard]] Checked<Lens> read_lens(const tinygltf::Value& extras, double fov_y_rad);

}  // namespace asos::gltf
