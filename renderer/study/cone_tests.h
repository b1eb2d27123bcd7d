#pragma once

#include "renderer/geometry/shape_face.h"

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// How the circular cone that surrounds a pyray meets an object (GI'93, "Detection Phase").
enum class ConeMeeting {
  none,      ///< nothing of it
  marginal,  ///< its boundary, as far as the test can tell
  covered    ///< it and no boundary: the object covers the whole cone
};

/// A right circular cone that is narrower than a right angle, by its half angle's sine and cosine.
struct PyrayCone {
  glm::dvec3 apex{0.0};
  glm::dvec3 axis{0, 0, -1};  ///< unit
  double sine = 0.0;
  double cosine = 1.0;
};

// In-out tests of a cone against GI'93's primitives, all seen from outside. They err on one side
// only: what they call covered or none is.

/// Exact, of a sphere.
[[nodiscard]] ConeMeeting meet_sphere(const PyrayCone& cone, glm::dvec3 centre, double radius);

/// Exact, of a convex polygon in a plane.
[[nodiscard]] ConeMeeting meet_polygon(const PyrayCone& cone, std::span<const glm::dvec3> corners);

/// Tests a disk, or a side with circles for rims (a uniform scale). A rim counts as a boundary
/// where it is hidden by the side, too.
[[nodiscard]] ConeMeeting meet_disk(const PyrayCone& cone, const ShapeFace& face);
/// `side`, and the disks that close it.
[[nodiscard]] ConeMeeting meet_cylinder(const PyrayCone& cone, const ShapeFace& side);

/// An axis-parallel box; an edge counts where it is part of the outline from the apex.
[[nodiscard]] ConeMeeting meet_box(const PyrayCone& cone, glm::dvec3 lo, glm::dvec3 hi);

}  // namespace asos
