#pragma once

#include "renderer/features/feature_curve.h"
#include "renderer/features/intersections.h"
#include "renderer/world/world.h"

#include <cstdint>
#include <vector>

namespace asos {

/// An arc along which a triangle and a face of an analytic shape pass through each other.
struct IntersectionArc {
  EllipseArc arc;
  std::uint32_t triangle = 0;
  std::uint32_t face = 0;  ///< its number as a surface (World::is_face)
};

/// Where triangles of a world pass through faces of its analytic shapes: ellipses as they are,
/// straight lines, and the other sections of cones in short straight pieces; and where two faces
/// pass through each other, unless both are disks (face_contours). Planes that only touch
/// a face or meet it in its rim have none.
struct ShapeIntersections {
  std::vector<IntersectionArc> arcs;
  std::vector<IntersectionLine> lines;
  bool complete = true;  ///< false: more pairs than are looked at; some are missing
};
[[nodiscard]] ShapeIntersections find_shape_intersections(const World& world);

}  // namespace asos
