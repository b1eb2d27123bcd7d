#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

namespace asos {

/// The camera turned by frame / count of a whole turn about the vertical through `middle`,
/// counter-clockwise as seen from above; frame 0 is the camera itself, to the bit.
[[nodiscard]] Camera turned_camera(const Camera& camera, glm::dvec3 middle, int frame, int count);

}  // namespace asos
