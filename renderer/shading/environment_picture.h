#pragma once

#include "renderer/shading/sky_choice.h"
#include "renderer/shading/sky_map.h"

#include <glm/glm.hpp>

#include <memory>

namespace asos {

/// Returns the equirectangular picture of an environment with panels, windows or walls; null for
/// one that a gradient describes. It is painted at the first call and then shared. Any thread.
[[nodiscard]] std::shared_ptr<const SkyMap> environment_picture(Environment environment);

/// Radiance of an environment from a unit direction, without its picture: for thumbnails.
[[nodiscard]] glm::vec3 environment_radiance(Environment environment, glm::dvec3 direction);

}  // namespace asos
