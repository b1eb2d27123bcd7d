#pragma once

#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/light_transport.h"

#include <glm/glm.hpp>

namespace asos {

/// Returns the sky's radiance that a surface reflects to its viewer if nothing occludes the sky, to
/// within `error`. It uses the closed form where there is one (unoccluded_sky), and samples without
/// rays elsewhere. `leaf` is the leaf's Sobol sequence; the samples use other dimensions of it than
/// rays do.
[[nodiscard]] glm::vec3 unoccluded_sky_within(const SkyQuery& point, const SobolPixel& leaf,
                                              double error);

}  // namespace asos
