#pragma once

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace asos {

using TriangleCorners = std::array<glm::dvec3, 3>;

/// A straight piece of a line.
struct LineSegment {
  glm::dvec3 p, q;
};

/// Returns the segment along which two triangles pass through each other. There is none where they
/// only touch or are coplanar, up to the rounding of coordinates that were floats relative to
/// `origin`. Does not depend on winding.
[[nodiscard]] std::optional<LineSegment> common_line(const TriangleCorners& s,
                                                     const TriangleCorners& t, glm::dvec3 origin);

}  // namespace asos
