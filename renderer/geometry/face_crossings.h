#pragma once

#include "renderer/geometry/shape_face.h"

#include <glm/glm.hpp>

namespace asos {

/// The crossings of a line and a face of an analytic shape: at origin + t * direction, by ascending
/// t.
struct FaceCrossings {
  int count = 0;
  double t[2] = {0.0, 0.0};
  glm::dvec3 unit[2] = {glm::dvec3(0.0), glm::dvec3(0.0)};  ///< on the unit surface
};

/// Returns the crossings of a line with a face, in double precision. The discriminant of quadrics
/// is computed from the line's distance from the axis or the centre, so a far origin loses no
/// digits (Haines, Ray Tracing Gems, 2019, chapter 7). A line that only touches a face does not
/// cross it.
[[nodiscard]] FaceCrossings cross(const ShapeFace& face, glm::dvec3 origin, glm::dvec3 direction);

}  // namespace asos
