#pragma once

#include "renderer/geometry/shape_face.h"

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// How the circular cone around a pyray meets an object (GI'93, "Detection Phase").
enum class ConeMeeting {
  none,      ///< misses the object
  marginal,  ///< meets its boundary, or the test cannot decide
  covered    ///< meets only the object's inside: the object covers the whole cone
};

/// A right circular cone that is narrower than a right angle, by its half angle's sine and cosine.
struct PyrayCone {
  glm::dvec3 apex{0.0};
  glm::dvec3 axis{0, 0, -1};  ///< unit
  double sine = 0.0;
  double cosine = 1.0;
};

// In-out tests of a cone against GI'93's primitives, all seen from outside. The results `covered`
// and `none` are always right; `marginal` may be too cautious.

/// Exact, for a sphere.
[[nodiscard]] ConeMeeting meet_sphere(const PyrayCone& cone, glm::dvec3 centre, double radius);

/// Exact, for a convex polygon in a plane.
[[nodiscard]] ConeMeeting meet_polygon(const PyrayCone& cone, std::span<const glm::dvec3> corners);

/// Tests a disk with a circular rim (a uniform scale).
[[nodiscard]] ConeMeeting meet_disk(const PyrayCone& cone, const ShapeFace& face);
/// Tests a side with circular rims, and its disks. A hidden rim counts as a boundary, too.
[[nodiscard]] ConeMeeting meet_cylinder(const PyrayCone& cone, const ShapeFace& side);

/// Tests an axis-parallel box; an edge counts if it is part of the outline from the apex.
[[nodiscard]] ConeMeeting meet_box(const PyrayCone& cone, glm::dvec3 lo, glm::dvec3 hi);

}  // namespace asos
