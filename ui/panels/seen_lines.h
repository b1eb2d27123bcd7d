#pragma once

#include "renderer/geometry/view.h"
#include "renderer/rays/ray_scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos::ui {

/// A part of a straight line, and whether a surface lies between it and the viewer.
struct LinePart {
  glm::dvec3 from, to;
  bool hidden = false;
};

/// The parts of the line from `a` to `b` within the picture as surfaces hide them, in their order;
/// none: it lies outside. Looked for at `places` places, evenly along it as it is seen, and where
/// two of them differ more closely. A surface that the line lies in hides nothing.
[[nodiscard]] std::vector<LinePart> seen_parts(const RayScene& rays, const View& view,
                                               Culling faces, glm::dvec3 a, glm::dvec3 b,
                                               int places = 100);

}  // namespace asos::ui
