#pragma once

#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

namespace asos {

/// Returns the background's radiance along a ray that hits nothing.
[[nodiscard]] glm::vec3 background_along(const ShadingSettings& settings, const ViewedRay& seen);

}  // namespace asos
