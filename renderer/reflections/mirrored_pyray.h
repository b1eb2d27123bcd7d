#pragma once

#include "renderer/geometry/view.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// A pyray that hits a surface: the part of a picture that a leaf or a sample represents.
struct IncidentPyray {
  bool perspective = true;
  glm::dvec3 axis{0, 0, -1};  ///< from the apex through the pyray's centre, to depth 1
  glm::dvec3 right{0.0};      ///< the pyray's edges one unit ahead; for parallel rays, anywhere
  glm::dvec3 down{0.0};
  double distance = 0.0;  ///< factor of the axis from the apex to the surface
};

/// The surface at the hit of the axis.
struct MirrorSurface {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0, 0, 1};     ///< unit normal of the reflection, towards the viewer
  glm::dvec3 geometric{0, 0, 1};  ///< unit normal of the plane that reflected rays have to leave
  double clearance = 0.0;         ///< height above that plane at which reflected rays start
  double hit_tolerance = 0.0;     ///< as MirrorPlane's; 0: not a plane
  double rise = 0.0;   ///< height of a concave surface at the corners of the pyray's patch
  double fall = 0.0;   ///< depth of a convex surface at these corners
  double ratio = 0.0;  ///< ratio of the indices before and behind the surface; 0: reflection
  glm::dvec3 turn_right{0.0};  ///< turn of the unit normal across the pyray's patch; 0: flat
  glm::dvec3 turn_down{0.0};

  [[nodiscard]] bool bent() const {
    return turn_right != glm::dvec3(0.0) || turn_down != glm::dvec3(0.0);
  }
};

/// The square of directions around the mirrored one over which a blurred reflection is averaged.
/// `width` is the length of a side, one unit ahead.
struct MirrorLobe {
  glm::dvec3 right{1, 0, 0};  ///< unit, perpendicular to the mirrored direction and to each other
  glm::dvec3 down{0, 1, 0};
  double width = 0.0;
};

/// Returns the surface for refracted rays, by Snell's law. Its sides are swapped: the rays leave
/// below it.
[[nodiscard]] MirrorSurface refracting(MirrorSurface surface, double ratio);

/// Returns the part of a vector perpendicular to a unit axis.
[[nodiscard]] inline glm::dvec3 across(glm::dvec3 v, glm::dvec3 unit_axis) {
  return v - glm::dot(v, unit_axis) * unit_axis;
}

/// Reflects or refracts `direction` (any length). The result is unit and above the plane of the
/// geometric normal. A direction that a shading normal reflects below that plane is raised to it.
/// Beyond the critical angle it is the last refracted direction.
[[nodiscard]] glm::dvec3 mirrored_direction(const MirrorSurface& surface, glm::dvec3 direction);

/// Returns the lobe's square around the mirrored direction, oriented like the reflected picture.
[[nodiscard]] MirrorLobe lobe_around(const MirrorSurface& surface, glm::dvec3 mirrored,
                                     glm::dvec3 picture_right, double width);

/// The patch that the pyray cuts out of the tangent plane, by its edges. It is at most 64 times as
/// long as wide, see patch_on_plane.
struct MirrorPatch {
  glm::dvec3 right{0.0};
  glm::dvec3 down{0.0};
};
[[nodiscard]] MirrorPatch patch_of(const IncidentPyray& pyray, glm::dvec3 normal);

/// Returns the change of the reflected, or refracted, unit direction if a unit direction changes by
/// `edge` and the normal by `turn`.
[[nodiscard]] glm::dvec3 mirrored_edge(const MirrorSurface& surface, glm::dvec3 unit_axis,
                                       glm::dvec3 edge, glm::dvec3 turn);

/// A reflected pyray.
struct MirroredPyray {
  PyrayPicture picture;
  double apex_distance = 0.0;  ///< from the apex to the surface; infinite: parallel rays
  /// Fraction of the pyray's width, far from the surface, that it has without the lobe: right and
  /// down.
  glm::dvec2 sharp_share{1.0};
};

/// Reflects a pyray at a surface. A plane reflects it exactly, by mirroring its apex (CGF'98
/// section 5). At a curved surface it is the pyramid through the patch that is nearest to the
/// reflected rays. Its apex has the least sum of squared distances to them, to first order of the
/// turn of the normal (5.2.1). A lobe widens it and moves its apex towards the surface, as a
/// defocusing ratio does (5.1). If a curved mirror makes rays meet in front of it, its tangent
/// plane is used (5.2.2). Returns nothing if the pyray has no extent or its numbers are not finite.
[[nodiscard]] std::optional<MirroredPyray> mirrored(const IncidentPyray& pyray,
                                                    const MirrorSurface& surface,
                                                    const MirrorLobe& lobe);

/// Returns the angle between the farthest of the reflected corner rays, in radians, without any
/// lobe (CGF'98 sections 5.2.1 and 5.2.4).
[[nodiscard]] double reflected_angle(const IncidentPyray& pyray, const MirrorSurface& surface);

}  // namespace asos
