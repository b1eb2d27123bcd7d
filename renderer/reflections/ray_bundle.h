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
  /// What blur changes beside, as u and v do and without regard to them: it is uniform, too, over
  /// -1/2 to 1/2.
  glm::dvec3 lobe_right_at{0.0};
  glm::dvec3 lobe_down_at{0.0};
  glm::dvec3 lobe_right{0.0};
  glm::dvec3 lobe_down{0.0};

  /// Those of a part of a frame, or of the bundle's own square: both are 0 to 1 wide.
  [[nodiscard]] static RayBundle of(const Frame& frame, const Bounds2& part);
  [[nodiscard]] RayBundle part(const Bounds2& part) const;
  /// That which is left of a blurred pyramid: its rays to first order.
  [[nodiscard]] static RayBundle of(const MirroredPyray& pyray, glm::dvec3 position);

  [[nodiscard]] bool blurred() const {
    return lobe_right != glm::dvec3(0.0) || lobe_down != glm::dvec3(0.0);
  }
  /// What blur adds to the section.
  [[nodiscard]] MirrorPatch blur_of_section(double t) const {
    return {lobe_right_at + t * lobe_right, lobe_down_at + t * lobe_down};
  }
  /// The square over which the section and its blur are as widely spread together.
  [[nodiscard]] MirrorPatch whole_section(double t) const;
  /// Adds a lobe around the directions to the blur that there is. Two boxes stand for three then:
  /// of the same second moments of places and directions, and `t` from the origin, where it is to
  /// be seen, as nearly as can be of the same fourth cumulant, too.
  void add_lobe(const MirrorLobe& lobe, double t);
  /// Of a blurred one the rays through a part of the section `t` from the origin, which is as wide
  /// as the bundle and its blur together. What the place there tells of the direction is the part's
  /// `right` and `down`, by linear regression, and the rest of the variance its blur.
  [[nodiscard]] RayBundle blurred_part(const Bounds2& part, double t) const;

  /// What it cuts out of a plane across it, `t` from the origin: its edges.
  [[nodiscard]] MirrorPatch section(double t) const {
    return {right_at + t * right, down_at + t * down};
  }
};

/// The bundle that leaves a surface which it meets in `surface.position`.
[[nodiscard]] RayBundle mirrored(const RayBundle& bundle, const MirrorSurface& surface);

/// The pyramid that comes nearest to a bundle that left a surface: through its middle ray and, `t`
/// from there, through its corners, with the apex for which the patch on the surface fits best.
/// Where rays meet before `t` it is turned round, as they are there. Blur widens it, which then
/// leaves no more than the patch. Nothing where the numbers are not finite.
[[nodiscard]] std::optional<MirroredPyray> pyramid_around(const RayBundle& bundle,
                                                          const MirrorSurface& surface, double t);

}  // namespace asos
