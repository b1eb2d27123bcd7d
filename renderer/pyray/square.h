#pragma once

#include "renderer/geometry/bounds2.h"
#include "renderer/geometry/clip_segment.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace asos {

/// A (sub-)pyray: an axis-aligned square of a root frame.
struct Square {
  float u = 0.0f;
  float v = 0.0f;
  float side = 1.0f;

  [[nodiscard]] float centre_u() const { return u + 0.5f * side; }
  [[nodiscard]] float centre_v() const { return v + 0.5f * side; }
  /// Returns quarter 0..3: left to right, then top to bottom.
  [[nodiscard]] Square quarter(int i) const {
    const float h = 0.5f * side;
    return {(i & 1) ? u + h : u, (i & 2) ? v + h : v, h};
  }
  /// Returns part `i` of a grid of n x n parts: left to right, then top to bottom.
  [[nodiscard]] Square part(int n, int i) const {
    const float h = side / static_cast<float>(n);
    return {u + static_cast<float>(i % n) * h, v + static_cast<float>(i / n) * h, h};
  }
};

/// A straight piece of a boundary in a root frame: u, v and the nearness (see FramePoint) are
/// linear along it.
struct Segment {
  float u0 = 0, v0 = 0, nearness0 = 0;
  float u1 = 0, v1 = 0, nearness1 = 0;
  std::uint32_t edge = 0;  ///< index into FeatureSet::edges
};

/// A directed edge of the border of a region of a root frame: the region lies to the left where u
/// points to the right and v up, so that outer borders run counter-clockwise and those of holes
/// clockwise.
struct BorderEdge {
  glm::vec2 from{0.0f};
  glm::vec2 to{0.0f};
};

/// Returns whether a border winds around a point an odd number of times, computed in the precision
/// of the point.
template <typename T>
[[nodiscard]] bool winds_around(std::span<const BorderEdge> border, glm::vec<2, T> p) {
  bool in = false;
  for (const BorderEdge& s : border) {
    const glm::vec<2, T> from(s.from), to(s.to);
    if ((from.y > p.y) != (to.y > p.y) &&
        p.x < from.x + (to.x - from.x) * (p.y - from.y) / (to.y - from.y))
      in = !in;
  }
  return in;
}

/// The region of a leaf: a square, or its part inside a border.
struct LeafRegion {
  Square square;
  std::span<const BorderEdge> border;  ///< empty: the whole square
  bool marginal = false;  ///< boundaries pass through it: one sample represents all of it

  template <typename T>
  [[nodiscard]] bool holds(glm::vec<2, T> p) const {
    if (!border.empty()) return winds_around(border, p);
    const glm::vec<2, T> lo(square.u, square.v);
    const glm::vec<2, T> hi(square.u + square.side, square.v + square.side);
    return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y;
  }
  /// Calls visit(BorderEdge) for every edge of the border, or of the square if there is no border.
  template <typename Visit>
  void for_each_edge(Visit&& visit) const {
    if (!border.empty()) {
      for (const BorderEdge& edge : border) visit(edge);
      return;
    }
    const float u1 = square.u + square.side, v1 = square.v + square.side;
    const glm::vec2 corners[4] = {{square.u, square.v}, {u1, square.v}, {u1, v1}, {square.u, v1}};
    for (int i = 0; i < 4; ++i) visit(BorderEdge{corners[i], corners[(i + 1) % 4]});
  }
};

/// Returns the bounding rectangle of a leaf's region.
[[nodiscard]] inline Bounds2 bounds_of(const LeafRegion& region) {
  const Square& s = region.square;
  if (region.border.empty()) return {{s.u, s.v}, {s.u + s.side, s.v + s.side}};
  Bounds2 bounds{region.border[0].from, region.border[0].from};
  for (const BorderEdge& side : region.border) {
    bounds.lo = glm::min(bounds.lo, glm::min(side.from, side.to));
    bounds.hi = glm::max(bounds.hi, glm::max(side.from, side.to));
  }
  return bounds;
}

/// Returns the fraction of the bounding rectangle `bounds` that a region fills; 0 if the rectangle
/// has no area.
[[nodiscard]] inline float filled_share(const LeafRegion& region, const Bounds2& bounds) {
  const glm::vec2 size = bounds.hi - bounds.lo;
  float twice_area = 0.0f;
  region.for_each_edge([&](const BorderEdge& edge) {
    const glm::vec2 from = edge.from - bounds.lo, to = edge.to - bounds.lo;
    twice_area += from.x * to.y - from.y * to.x;
  });
  const float around = size.x * size.y;
  return around > 0.0f ? 0.5f * std::abs(twice_area) / around : 0.0f;
}

/// Clips a segment to a square. A segment along the square's border does not cross its inside:
/// empty.
[[nodiscard]] inline SegmentPart<float> clip(const Segment& s, const Square& square) {
  // The border is moved inwards by a millionth, so that an edge along it belongs to neither side.
  const float border = 1e-6f * square.side;
  const glm::vec2 p(s.u0, s.v0), corner(square.u, square.v);
  return clip_segment<float>(p, glm::vec2(s.u1, s.v1) - p, corner + border,
                             corner + square.side - border);
}

}  // namespace asos
