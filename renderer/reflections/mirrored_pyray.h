#pragma once

#include "renderer/geometry/view.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// A pyray that meets a surface: the part of a picture that a leaf, or a sample, stands for.
struct IncidentPyray {
  bool perspective = true;
  glm::dvec3 axis{0, 0, -1};  ///< from the apex through its middle, `forward` one unit ahead
  glm::dvec3 right{0.0};      ///< its edges, where it is one unit ahead; parallel rays: anywhere
  glm::dvec3 down{0.0};
  double distance = 0.0;  ///< axis times this leads from the apex to the surface
};

/// The surface where the axis meets it.
struct MirrorSurface {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0, 0, 1};     ///< unit, that mirrors; towards the viewer
  glm::dvec3 geometric{0, 0, 1};  ///< unit, of the plane that reflected rays have to leave
  double clearance = 0.0;         ///< how far above that plane they start
  double hit_tolerance = 0.0;     ///< MirrorPlane's; 0: not a plane
  double rise = 0.0;   ///< by how much a hollow one is higher at the corners of the pyray's patch
  double fall = 0.0;   ///< by how much a bulging one is lower there
  double ratio = 0.0;  ///< of the indices before and behind it, by which it refracts; 0: it mirrors
  glm::dvec3 turn_right{0.0};  ///< turn of the unit normal across the pyray's patch; 0: flat
  glm::dvec3 turn_down{0.0};

  [[nodiscard]] bool bent() const {
    return turn_right != glm::dvec3(0.0) || turn_down != glm::dvec3(0.0);
  }
};

/// A square of directions around the mirrored one, over which a blurred reflection is the mean.
/// `width`: the length of a side, one unit ahead.
struct MirrorLobe {
  glm::dvec3 right{1, 0, 0};  ///< unit, square to the mirrored direction and to each other
  glm::dvec3 down{0, 1, 0};
  double width = 0.0;
};

/// The same surface where it lets rays through, bent by Snell's law: what was below it is above.
[[nodiscard]] MirrorSurface refracting(MirrorSurface surface, double ratio);

/// What of a vector is square to a unit axis.
[[nodiscard]] inline glm::dvec3 across(glm::dvec3 v, glm::dvec3 unit_axis) {
  return v - glm::dot(v, unit_axis) * unit_axis;
}

/// The direction in which the surface mirrors, or refracts, `direction` (any length): unit, and
/// above the plane of the geometric normal. A direction that a bent normal mirrors below it is
/// raised to it. Beyond the critical angle it is the last that is refracted.
[[nodiscard]] glm::dvec3 mirrored_direction(const MirrorSurface& surface, glm::dvec3 direction);

/// The lobe's square around the mirrored direction, turned like the picture that is mirrored.
[[nodiscard]] MirrorLobe lobe_around(const MirrorSurface& surface, glm::dvec3 mirrored,
                                     glm::dvec3 picture_right, double width);

/// The patch that the pyray cuts out of the tangent plane, by its edges: no longer than 64 times
/// its width, see patch_on_plane.
struct MirrorPatch {
  glm::dvec3 right{0.0};
  glm::dvec3 down{0.0};
};
[[nodiscard]] MirrorPatch patch_of(const IncidentPyray& pyray, glm::dvec3 normal);

/// How the mirrored, or refracted, unit direction changes where a unit direction changes by `edge`
/// and the normal by `turn`.
[[nodiscard]] glm::dvec3 mirrored_edge(const MirrorSurface& surface, glm::dvec3 unit_axis,
                                       glm::dvec3 edge, glm::dvec3 turn);

/// A reflected pyray.
struct MirroredPyray {
  PyrayPicture picture;
  double apex_distance = 0.0;  ///< from the apex to the surface; infinite: parallel rays
  /// Share of the pyray's width far from the surface that is not the lobe's: right and down.
  glm::dvec2 sharp_share{1.0};
};

/// A pyray mirrored by a surface. A plane mirrors it exactly, by mirroring its apex (CGF'98 section
/// 5); on a bent one it is the pyramid through the patch that comes nearest to the reflected rays,
/// whose apex has the least sum of squared distances to them, to first order of how the normal
/// turns (5.2.1). A lobe widens it and moves its apex towards the surface, as a defocusing ratio
/// does (5.1). A bent mirror that makes rays meet in front of it is taken for its tangent plane
/// (5.2.2). Nothing where the pyray has no extent or its numbers are not finite.
[[nodiscard]] std::optional<MirroredPyray> mirrored(const IncidentPyray& pyray,
                                                    const MirrorSurface& surface,
                                                    const MirrorLobe& lobe);

/// The angle between the farthest of the reflected corner rays, in radians, without any lobe
/// (CGF'98 sections 5.2.1 and 5.2.4).
[[nodiscard]] double reflected_angle(const IncidentPyray& pyray, const MirrorSurface& surface);

}  // namespace asos
