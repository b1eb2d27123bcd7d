#pragma once

#include "renderer/lights/prepared_light.h"

namespace asos {

/// Fills in what a light with `outlines` needs: the outlines, flat and the right way round, their
/// plane and area, the smallest rectangle around them and the map for samples. False, with nothing
/// changed: they enclose no area.
[[nodiscard]] bool prepare_polygon(const std::vector<std::vector<glm::dvec3>>& outlines,
                                   glm::dvec3 direction, PreparedLight& prepared);

}  // namespace asos
