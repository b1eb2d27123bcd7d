#pragma once

#include "renderer/geometry/view.h"
#include "renderer/rays/ray_scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos::ui {

/// A part of a straight line, and whether a surface hides it.
struct LinePart {
  glm::dvec3 from, to;
  bool hidden = false;
};

/// Splits the line from `a` to `b` within the picture into visible and hidden parts, in order;
/// empty: it is outside. Tests `places` points, evenly spaced in the picture, and bisects between
/// two that differ. A surface that contains the line does not hide it.
[[nodiscard]] std::vector<LinePart> seen_parts(const RayScene& rays, const View& view,
                                               Culling faces, glm::dvec3 a, glm::dvec3 b,
                                               int places = 100);

}  // namespace asos::ui
