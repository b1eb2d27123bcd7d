#pragma once

#include "renderer/lights/prepared_light.h"

namespace asos {

/// Fills in the data of a light with `outlines`: the outlines, flat and with the right orientation,
/// their plane and area, the smallest rectangle around them and the map for samples. Returns false,
/// without any change, if they enclose no area.
[[nodiscard]] bool prepare_polygon(const std::vector<std::vector<glm::dvec3>>& outlines,
                                   glm::dvec3 direction, PreparedLight& prepared);

}  // namespace asos
