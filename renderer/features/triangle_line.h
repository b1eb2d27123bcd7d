#pragma once

#include <glm/glm.hpp>

#include <array>
#include <optional>

namespace asos {

using TriangleCorners = std::array<glm::dvec3, 3>;

/// A straight piece of a line.
struct Stretch {
  glm::dvec3 p, q;
};

/// The stretch along which two triangles pass through each other. None where they only touch or
/// lie in one plane, up to the rounding of coordinates that were written as floats of `origin` plus
/// the corners. Does not depend on how either is wound.
[[nodiscard]] std::optional<Stretch> common_line(const TriangleCorners& s, const TriangleCorners& t,
                                                 glm::dvec3 origin);

}  // namespace asos
