#pragma once

#include "renderer/shading/sky_choice.h"
#include "renderer/shading/sky_map.h"

#include <glm/glm.hpp>

#include <memory>

namespace asos {

/// The equirectangular picture of an environment that has panels, windows or walls; null for one
/// that its gradient describes. Painted at the first call and shared from then on. Any thread.
[[nodiscard]] std::shared_ptr<const SkyMap> environment_picture(Environment environment);

/// Radiance of an environment from a unit direction, without its picture: for thumbnails.
[[nodiscard]] glm::vec3 environment_radiance(Environment environment, glm::dvec3 direction);

}  // namespace asos
