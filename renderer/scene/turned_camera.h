#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

namespace asos {

/// Returns the camera, turned by frame / count of a full turn about the vertical axis through
/// `middle`, counter-clockwise as seen from above. Frame 0 is bit-identical to the camera.
[[nodiscard]] Camera turned_camera(const Camera& camera, glm::dvec3 middle, int frame, int count);

}  // namespace asos
