#pragma once

#include "renderer/geometry/bounds2.h"
#include "renderer/geometry/frame.h"
#include "renderer/reflections/mirrored_pyray.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// The rays through a square, to first order in the places u and v on it, -1/2 to 1/2 (ray
/// differentials: Igehy 1999). Unlike a pyramid's they need not meet in a point: refracted ones
/// have their foci at two distances, and often in front.
struct RayBundle {
  glm::dvec3 origin{0.0};          ///< of the ray in the middle
  glm::dvec3 direction{0, 0, -1};  ///< unit
  glm::dvec3 right_at{0.0};        ///< what u and v change of the origin
  glm::dvec3 down_at{0.0};
  glm::dvec3 right{0.0};  ///< and of the direction, to which they are square
  glm::dvec3 down{0.0};

  /// Those of a part of a frame, or of the bundle's own square: both are 0 to 1 wide.
  [[nodiscard]] static RayBundle of(const Frame& frame, const Bounds2& part);
  [[nodiscard]] RayBundle part(const Bounds2& part) const;

  /// What it cuts out of a plane across it, `t` from the origin: its edges.
  [[nodiscard]] MirrorPatch section(double t) const {
    return {right_at + t * right, down_at + t * down};
  }
};

/// The bundle that leaves a surface which it meets in `surface.position`.
[[nodiscard]] RayBundle mirrored(const RayBundle& bundle, const MirrorSurface& surface);

/// The pyramid that comes nearest to a bundle that left a surface: through its middle ray and, `t`
/// from there, through its corners, with the apex for which the patch on the surface fits best.
/// Where rays meet before `t` it is turned round, as they are there. Nothing where the numbers are
/// not finite.
[[nodiscard]] std::optional<MirroredPyray> pyramid_around(const RayBundle& bundle,
                                                          const MirrorSurface& surface, double t);

}  // namespace asos
