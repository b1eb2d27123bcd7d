#pragma once

#include "renderer/scene/surroundings.h"
#include "renderer/shading/sky_map.h"

namespace asos {

/// A cube's pictures as an equirectangular one: four times as wide as a side, up to 4096 texels,
/// each of which is the mean of four places. A texel that its alpha of 0 would make infinite is
/// black.
[[nodiscard]] SkyMap sky_map_of(const Surroundings& surroundings);

}  // namespace asos
