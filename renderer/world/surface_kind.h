#pragma once

#include "renderer/scene/scene.h"

#include <cstdint>

namespace asos {

/// How rays interact with a material's surfaces.
enum class SurfaceKind : std::uint8_t {
  opaque,   ///< always hit; blocks all light
  masked,   ///< hit where its opacity reaches the material's cut-off
  blended,  ///< always hit; transmits light by its opacity
};

/// Transmission (KHR_materials_transmission, thin) is a separate transparency for any alpha mode.
/// For a masked material with transmission, alpha_at applies the cut-off.
[[nodiscard]] inline SurfaceKind surface_kind(const Material& material) {
  if (material.alpha_mode == AlphaMode::blend || material.transmission > 0.0f) {
    return SurfaceKind::blended;
  }
  return material.alpha_mode == AlphaMode::mask ? SurfaceKind::masked : SurfaceKind::opaque;
}

}  // namespace asos
