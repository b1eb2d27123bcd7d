#pragma once

#include "renderer/geometry/frame.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// The exact visibility of a set of triangles through a square of a frame: beam tracing (CGF'98
// section 2.6). Slow, in double precision, and made of nothing that the engine is made of: the
// engine is measured against it. Every surface counts as opaque.

namespace asos {

/// The points (u, v) of a frame with a u + b v + c >= 0; scaled so that this is their distance from
/// the border, where there is one.
struct HalfPlane {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;

  [[nodiscard]] double depth(glm::dvec2 p) const { return a * p.x + b * p.y + c; }
};

/// A triangle as a frame sees it: the intersection of half-planes, whether or not it reaches behind
/// the apex, and the nearness q (see FramePoint), which is linear across it.
struct Facet {
  std::uint32_t triangle = 0;
  std::array<HalfPlane, 5> inside;
  glm::dvec3 nearness{0.0};  ///< q = dot(nearness, (u, v, 1))

  [[nodiscard]] double q(glm::dvec2 p) const {
    return nearness.x * p.x + nearness.y * p.y + nearness.z;
  }
};

/// The facet of a triangle with these corners. Nothing for one that is seen edge-on, that has no
/// area, that does not meet the frame's unit square, or whose corners are not finite.
[[nodiscard]] std::optional<Facet> make_facet(const Frame& frame, std::uint32_t triangle,
                                              const std::array<glm::dvec3, 3>& corners);

/// Leaves of a facet what is at most as near as `near` and at least as near as `far`, where given.
void cut_facet(Facet& facet, std::optional<double> near, std::optional<double> far);

/// Convex; corner by corner.
using ConvexPolygon = std::vector<glm::dvec2>;

/// The points lo <= (u, v) <= hi of a frame.
struct FrameRectangle {
  glm::dvec2 lo{0.0};
  glm::dvec2 hi{1.0};
};

/// A part of a rectangle in which one triangle, or the background, is all that is seen.
struct VisiblePart {
  static constexpr std::uint32_t background = 0xffffffffu;

  std::uint32_t facet = background;  ///< index of the facet seen
  double area = 0.0;                 ///< in the frame's units, where its square has area 1
  glm::dvec2 centroid{0.0};
  ConvexPolygon polygon;
};

/// Finds the visible parts of facets in rectangles of their frame. Where two facets lie at the same
/// depth the one with the lower triangle is seen; where they pass through each other each is seen
/// on its own side of the line. Keeps its memory between calls; one object a thread.
class ExactVisibility {
 public:
  /// The parts, which do not overlap and together fill `rectangle` (to 1e-9 of the frame's square).
  /// A facet may have many. Valid until the next call.
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
  std::vector<Fragment> fragments_;    // of the cell at hand
  std::vector<ConvexPolygon> pieces_;  // the rest of one fragment
  std::vector<ConvexPolygon> rest_;
  std::vector<VisiblePart> parts_;
};

/// The area of a convex polygon.
[[nodiscard]] double area_of(const ConvexPolygon& polygon);

}  // namespace asos
