#pragma once

#include "renderer/geometry/shape_face.h"

#include <glm/glm.hpp>

namespace asos {

/// Where a line meets a face of an analytic shape: at origin + t * direction, by ascending t.
struct FaceCrossings {
  int count = 0;
  double t[2] = {0.0, 0.0};
  glm::dvec3 unit[2] = {glm::dvec3(0.0), glm::dvec3(0.0)};  ///< on the unit surface
};

/// In double precision; the discriminant of quadrics is found from the line's distance from the
/// axis or the centre, so that an origin far away costs no digits (Haines, Ray Tracing Gems, 2019,
/// chapter 7). A line that only touches a face meets it nowhere.
[[nodiscard]] FaceCrossings cross(const ShapeFace& face, glm::dvec3 origin, glm::dvec3 direction);

}  // namespace asos
