#pragma once

#include "renderer/geometry/bounds2.h"
#include "renderer/geometry/frame.h"
#include "renderer/reflections/mirrored_pyray.h"

#include <glm/glm.hpp>

#include <optional>

namespace asos {

/// The rays through a square, to first order in the coordinates u and v on it, -1/2 to 1/2 (ray
/// differentials: Igehy 1999). Unlike in a pyramid, rays need not meet in a point. Refracted ones
/// have two focal lines at different distances, often in front.
struct RayBundle {
  glm::dvec3 origin{0.0};          ///< of the central ray
  glm::dvec3 direction{0, 0, -1};  ///< unit
  glm::dvec3 right_at{0.0};        ///< change of the origin by u and v
  glm::dvec3 down_at{0.0};
  glm::dvec3 right{0.0};  ///< change of the direction, perpendicular to it
  glm::dvec3 down{0.0};
  /// Additional changes by blur, with its own coordinates, which are independent of u and v and
  /// uniform over -1/2 to 1/2, too.
  glm::dvec3 lobe_right_at{0.0};
  glm::dvec3 lobe_down_at{0.0};
  glm::dvec3 lobe_right{0.0};
  glm::dvec3 lobe_down{0.0};

  /// Returns the bundle of a part of a frame, or of a part of the bundle's own square. Both are 0
  /// to 1 wide.
  [[nodiscard]] static RayBundle of(const Frame& frame, const Bounds2& part);
  [[nodiscard]] RayBundle part(const Bounds2& part) const;
  /// Returns the bundle of the rays that leave a surface in a blurred pyramid, to first order.
  [[nodiscard]] static RayBundle of(const MirroredPyray& pyray, glm::dvec3 position);

  [[nodiscard]] bool blurred() const {
    return lobe_right != glm::dvec3(0.0) || lobe_down != glm::dvec3(0.0);
  }
  /// Returns the extent that blur adds to the section.
  [[nodiscard]] MirrorPatch blur_of_section(double t) const {
    return {lobe_right_at + t * lobe_right, lobe_down_at + t * lobe_down};
  }
  /// Returns the square with the variance of the section and its blur together.
  [[nodiscard]] MirrorPatch whole_section(double t) const;
  /// Adds a lobe around the directions to the existing blur. Two boxes then replace three. They
  /// have the same second moments of places and directions. At `t` from the origin, where the
  /// reflection is visible, they also have nearly the same fourth cumulant.
  void add_lobe(const MirrorLobe& lobe, double t);
  /// Returns the rays of a blurred bundle through a part of the section at `t` from the origin,
  /// which is as wide as the bundle and its blur together. The linear regression of direction on
  /// place gives the part's `right` and `down`, and the remaining variance its blur.
  [[nodiscard]] RayBundle blurred_part(const Bounds2& part, double t) const;

  /// Returns the section with a plane across it at `t` from the origin, by its edges.
  [[nodiscard]] MirrorPatch section(double t) const {
    return {right_at + t * right, down_at + t * down};
  }
};

/// Returns the bundle that leaves a surface after it hits `surface.position`.
[[nodiscard]] RayBundle mirrored(const RayBundle& bundle, const MirrorSurface& surface);

/// Returns the pyramid nearest to a bundle that left a surface. It passes through the central ray
/// and through the bundle's corners at `t`, and its apex fits the patch on the surface best. If
/// rays meet before `t`, it is inverted, as they are there. With blur, it is wider and leaves the
/// surface within the patch. Returns nothing if the numbers are not finite.
[[nodiscard]] std::optional<MirroredPyray> pyramid_around(const RayBundle& bundle,
                                                          const MirrorSurface& surface, double t);

}  // namespace asos
