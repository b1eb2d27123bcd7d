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

/// The intersections of a world's triangles with faces of its analytic shapes: ellipses, straight
/// lines, and other sections of cones in short straight pieces. Also the intersections of two
/// faces, unless both are disks (face_contours). Planes that only touch a face, or meet it in its
/// rim, have none.
struct ShapeIntersections {
  std::vector<IntersectionArc> arcs;
  std::vector<IntersectionLine> lines;
  bool complete = true;  ///< false: more pairs than the limit; some are missing
};
[[nodiscard]] ShapeIntersections find_shape_intersections(const World& world);

}  // namespace asos
