#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// A polygon, concave or with holes, cut into rows at the heights of its corners, and the rows into
/// trapezoids. It gives an area-preserving map from the unit square onto its inside.
struct PolygonRows {
  struct Row {
    double y0 = 0.0;  ///< from y0 to y1
    double y1 = 0.0;
    double width0 = 0.0;  ///< summed over its trapezoids, at y0 and at y1
    double width1 = 0.0;
    double area_before = 0.0;  ///< area of the rows below
    std::uint32_t first = 0;   ///< index into `trapezoids`, left to right
    std::uint32_t count = 0;
  };
  /// x at a row's y0 and y1.
  struct Trapezoid {
    double left0, left1, right0, right1;
  };

  std::vector<Row> rows;
  std::vector<Trapezoid> trapezoids;
  double area = 0.0;

  /// The inside is where an odd number of the closed outlines' sides lie to the left.
  [[nodiscard]] static PolygonRows of(std::span<const std::vector<glm::dvec2>> outlines);

  /// Returns the point for v in 0..1, which selects the height by area, and u in 0..1, which
  /// selects the place across the inside at that height. Neighbours stay neighbours, except for u
  /// across a notch or a hole. The area must not be 0.
  [[nodiscard]] glm::dvec2 point(double u, double v) const;
};

}  // namespace asos
