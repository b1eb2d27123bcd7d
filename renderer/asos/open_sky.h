#pragma once

#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

namespace asos {

/// All of the sky's light that a surface sends to its viewer, if nothing hides any of it, to within
/// `error` of radiance: in closed form where one is known (open_sky), else by what rays would carry
/// that need not be sent. `leaf`: a sequence of which other places are taken than rays take.
[[nodiscard]] glm::vec3 open_sky_within(const SkyLitPoint& point, const SobolPixel& leaf,
                                        double error);

}  // namespace asos
