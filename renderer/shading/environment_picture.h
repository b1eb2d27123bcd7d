#pragma once

#include "renderer/shading/sky_choice.h"
#include "renderer/shading/sky_lobes.h"
#include "renderer/shading/sky_map.h"

#include <glm/glm.hpp>

#include <memory>

namespace asos {

/// Returns whether an environment has panels, windows or walls; a gradient describes the others.
[[nodiscard]] bool has_picture(Environment environment);

/// Returns the equirectangular picture of an environment that has one. It is painted at the first
/// call and then shared. Any thread.
[[nodiscard]] const SkyMap& environment_picture(Environment environment);

/// Returns what surfaces reflect of that picture, without painting it; null for an environment
/// without one. Likewise shared.
[[nodiscard]] std::shared_ptr<const SkyLobes> environment_lobes(Environment environment);

/// Radiance of an environment from a unit direction, without its picture: for thumbnails.
[[nodiscard]] glm::vec3 environment_radiance(Environment environment, glm::dvec3 direction);

}  // namespace asos
