#pragma once

#include "renderer/geometry/shape_face.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos {

/// A straight piece of the line along which two faces of analytic shapes pass through each other.
struct FaceCrossing {
  glm::vec3 a, b;
};

/// Returns the contour of `other` on `face`, which is curved. Each cell of a grid over its
/// coordinates is cut where the other's equation changes sign. Ends are on both faces to single
/// precision, and neighbours share them. The length of pieces is 1/256 of the way around. A part of
/// the contour smaller than a cell may be missed. If both faces coincide there is no contour.
[[nodiscard]] std::vector<FaceCrossing> face_contours(const ShapeFace& face,
                                                      const ShapeFace& other);

}  // namespace asos
