#pragma once

#include "renderer/geometry/frame.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// The exact visibility of a set of triangles through a square of a frame: beam tracing (CGF'98
// section 2.6). This is the reference for the ASOS engine and shares no code with it. It is slow
// and uses double precision. Every surface counts as opaque.

namespace asos {

/// The points (u, v) of a frame with a u + b v + c >= 0, scaled so that this is their distance from
/// the border, if there is one.
struct HalfPlane {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;

  [[nodiscard]] double depth(glm::dvec2 p) const { return a * p.x + b * p.y + c; }
};

/// A triangle in the view of a frame: the intersection of half-planes, also if it reaches behind
/// the apex, and the nearness q (see FramePoint), which is linear across it.
struct Facet {
  std::uint32_t triangle = 0;
  std::array<HalfPlane, 5> inside;
  glm::dvec3 nearness{0.0};  ///< q = dot(nearness, (u, v, 1))

  [[nodiscard]] double q(glm::dvec2 p) const {
    return nearness.x * p.x + nearness.y * p.y + nearness.z;
  }
};

/// Returns the facet of a triangle with these corners. None if it is edge-on, has no area, lies
/// outside the frame's unit square, or has corners that are not finite.
[[nodiscard]] std::optional<Facet> make_facet(const Frame& frame, std::uint32_t triangle,
                                              const std::array<glm::dvec3, 3>& corners);

/// Clips a facet to nearness values from `far` to `near`, as far as given.
void cut_facet(Facet& facet, std::optional<double> near, std::optional<double> far);

/// The corners of a convex polygon in order.
using ConvexPolygon = std::vector<glm::dvec2>;

/// The points lo <= (u, v) <= hi of a frame.
struct FrameRectangle {
  glm::dvec2 lo{0.0};
  glm::dvec2 hi{1.0};
};

/// A part of a rectangle that shows a single triangle, or the background.
struct VisiblePart {
  static constexpr std::uint32_t background = 0xffffffffu;

  std::uint32_t facet = background;  ///< index of the visible facet
  double area = 0.0;                 ///< in the frame's units, in which its square has area 1
  glm::dvec2 centroid{0.0};
  ConvexPolygon polygon;
};

/// Finds the visible parts of facets in rectangles of their frame. If two facets lie at the same
/// depth, the one with the lower triangle index is visible. If they intersect, each is visible on
/// its side of the line. Keeps its memory between calls; one object per thread.
class ExactVisibility {
 public:
  /// Returns the visible parts. They do not overlap and together fill `rectangle` (to 1e-9 of the
  /// frame's square). A facet may have many. Valid until the next call.
  [[nodiscard]] std::span<const VisiblePart> find(std::span<const Facet> facets,
                                                  const FrameRectangle& rectangle);

 private:
  struct Fragment {
    std::uint32_t facet;
    ConvexPolygon polygon;
  };

  void divide(const std::vector<std::uint32_t>& candidates, const FrameRectangle& cell, int depth);
  void gather(const std::vector<std::uint32_t>& candidates, const FrameRectangle& cell);
  void drop_hidden(const FrameRectangle& cell);
  void resolve(const FrameRectangle& cell, const std::vector<Fragment>& fragments);
  void subtract(const Facet& nearer, const HalfPlane* where);
  [[nodiscard]] bool cut_away(const ConvexPolygon& piece, std::span<const HalfPlane> lines);
  void emit(std::uint32_t facet);

  std::span<const Facet> facets_;
  std::vector<Fragment> fragments_;    // of the current cell
  std::vector<ConvexPolygon> pieces_;  // the rest of one fragment
  std::vector<ConvexPolygon> rest_;
  std::vector<VisiblePart> parts_;
};

/// Returns the area of a convex polygon.
[[nodiscard]] double area_of(const ConvexPolygon& polygon);

}  // namespace asos
