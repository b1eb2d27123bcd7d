#pragma once

#include "renderer/geometry/ellipse_arc.h"
#include "renderer/geometry/frame.h"
#include "renderer/geometry/shape_face.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <vector>

namespace asos {

struct FeatureEdge;

/// A boundary of an analytic shape that is no straight edge. It is an arc that does not depend on
/// the viewpoint (a rim), or the outline of a curved face, which does.
struct FeatureCurve {
  static constexpr std::uint32_t none = 0xffffffffu;

  EllipseArc arc;             ///< of a rim
  bool outline = false;       ///< the outline of `face`, instead of `arc`
  std::uint32_t face = none;  ///< index into World::faces: the side whose end is this rim
  Box box;

  /// Returns a curve that does not depend on the viewpoint.
  static FeatureCurve of(const EllipseArc& arc);
};

/// A face's outline from one place (design section 3). It is an ellipse in the plane of the polar,
/// or the two lines along which planes through the apex touch a cone's side. The lines end on its
/// rims, at two of the rims' angles. Empty from inside.
struct FaceOutline {
  bool has_arc = false;
  EllipseArc arc;
  int line_count = 0;
  double angle[2] = {0.0, 0.0};  ///< the rims' angles where the lines end
};

/// Returns the outline seen from the frame's apex, or along its direction.
[[nodiscard]] FaceOutline face_outline(const ShapeFace& face, const Frame& frame);

/// Boundaries of a world's analytic shapes: each face's possible outline and its rims. The edges'
/// curve() indexes `curves`.
struct ShapeFeatures {
  std::vector<FeatureCurve> curves;
  std::vector<FeatureEdge> edges;
};
[[nodiscard]] ShapeFeatures shape_features(const World& world);

/// Returns how far, in world units, a face deviates from its tangent plane at `position` within
/// `reach`; at most its size.
[[nodiscard]] double face_deviation(const ShapeFace& face, glm::dvec3 position, double reach);

/// Returns the deviation of a face from its tangent plane in an oblique view, relative to a sphere
/// of the same width: 1 for spheres and round cylinders, 0 for disks.
[[nodiscard]] double face_stretch(const ShapeFace& face);

}  // namespace asos
