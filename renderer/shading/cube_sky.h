#pragma once

#include "renderer/scene/environment_cube.h"
#include "renderer/shading/sky_map.h"

namespace asos {

/// Converts a cube's pictures to an equirectangular one. It is four times as wide as a side, up to
/// 4096 texels, and each texel is the mean of four places. A texel whose alpha of 0 would make it
/// infinite is black.
[[nodiscard]] SkyMap sky_map_of(const EnvironmentCube& surroundings);

}  // namespace asos
