#pragma once

#include "renderer/geometry/shape_face.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos {

/// A straight piece of the line along which two faces of analytic shapes pass through each other.
struct FaceCrossing {
  glm::vec3 a, b;
};

/// The contour of `other` on `face`, which is curved: the cells of a grid over its coordinates,
/// each cut where the other's equation changes sign. Ends are on both faces to single precision and
/// neighbours share them; pieces are a 256th of the way around long. A part of the contour that is
/// smaller than a cell may be missed. Where both coincide there is none.
[[nodiscard]] std::vector<FaceCrossing> face_contours(const ShapeFace& face,
                                                      const ShapeFace& other);

}  // namespace asos
