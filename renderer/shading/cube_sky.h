#pragma once

#include "renderer/scene/environment_cube.h"
#include "renderer/shading/sky_map.h"

namespace asos {

/// Converts a cube map to an equirectangular picture. It is four times as wide as a side of the
/// cube, up to 4096 texels, and each texel is the mean of four samples. A texel to be divided by an
/// alpha of 0 is black.
[[nodiscard]] SkyMap sky_map_of(const EnvironmentCube& surroundings);

}  // namespace asos
