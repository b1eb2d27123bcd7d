#pragma once

#include "renderer/geometry/ellipse_arc.h"
#include "renderer/geometry/frame.h"
#include "renderer/geometry/shape_face.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <vector>

namespace asos {

struct FeatureEdge;

/// A boundary of an analytic shape that is no straight edge: an arc that is the same from
/// everywhere (a rim), or the outline of a curved face, which depends on where it is seen from.
struct FeatureCurve {
  static constexpr std::uint32_t none = 0xffffffffu;

  EllipseArc arc;             ///< of a rim
  bool outline = false;       ///< the outline of `face`, instead of `arc`
  std::uint32_t face = none;  ///< index into World::faces: of the side that a rim ends
  Box box;

  /// One that is the same from everywhere.
  static FeatureCurve of(const EllipseArc& arc);
};

/// A face's outline from one place (design section 3): an ellipse in the plane of the polar, or the
/// two lines along which planes through the apex touch a cone's side. They end on its rims, at two
/// of the rims' angles. Empty from inside.
struct FaceOutline {
  bool has_arc = false;
  EllipseArc arc;
  int line_count = 0;
  double angle[2] = {0.0, 0.0};  ///< the rims' angles at which the lines end
};

/// As seen from the frame's apex, or along its direction.
[[nodiscard]] FaceOutline face_outline(const ShapeFace& face, const Frame& frame);

/// Boundaries of a world's analytic shapes: of each face what can be its outline, and its rims.
/// `curves` holds what the edges' curve() counts in.
struct ShapeFeatures {
  std::vector<FeatureCurve> curves;
  std::vector<FeatureEdge> edges;
};
[[nodiscard]] ShapeFeatures shape_features(const World& world);

/// How far, in world units, a face leaves the plane that touches it at `position` within `reach` of
/// there; not more than its size.
[[nodiscard]] double face_deviation(const ShapeFace& face, glm::dvec3 position, double reach);

/// How much farther than a sphere of the same width a face leaves the plane that touches it, where
/// it is seen at a slant: 1 for spheres and round cylinders, 0 for disks.
[[nodiscard]] double face_stretch(const ShapeFace& face);

}  // namespace asos
