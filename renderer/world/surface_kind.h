#pragma once

#include "renderer/scene/scene.h"

#include <cstdint>

namespace asos {

/// How rays meet a material's surfaces.
enum class SurfaceKind : std::uint8_t {
  opaque,   ///< always met, and blocks all light
  masked,   ///< met where its opacity reaches the material's cut-off
  blended,  ///< always met, and lets the light through that its opacity leaves
};

/// Transmission (KHR_materials_transmission, thin) is transparency of its own, whatever the alpha
/// mode; a masked material that transmits has its cut-off applied within alpha_at.
[[nodiscard]] inline SurfaceKind surface_kind(const Material& material) {
  if (material.alpha_mode == AlphaMode::blend || material.transmission > 0.0f) {
    return SurfaceKind::blended;
  }
  return material.alpha_mode == AlphaMode::mask ? SurfaceKind::masked : SurfaceKind::opaque;
}

}  // namespace asos
