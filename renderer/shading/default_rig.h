#pragma once

#include "renderer/scene/scene.h"

#include <vector>

namespace asos {

/// Lights for a scene that has none of its own, as in a small studio: a key light from the upper
/// left in front (the only one that casts shadows), a fill light from the right, and a rim light
/// from behind. They turn with `camera` about +Y and not with its pitch, so that "above" stays
/// above. Together with the sky a white diffuse surface comes near white and stays below it.
[[nodiscard]] std::vector<Light> default_rig(const Camera& camera);

}  // namespace asos
