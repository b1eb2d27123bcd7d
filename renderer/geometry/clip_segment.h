#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace asos {

/// The part of a segment inside a rectangle, as parameters along it: empty unless t0 < t1.
template <typename T>
struct SegmentPart {
  T t0{0};
  T t1{1};

  [[nodiscard]] bool empty() const { return !(t0 < t1); }
};

/// Clips the segment from `p` to `p + d` to the rectangle from `lo` to `hi` by Liang and Barsky.
/// The rectangle's border counts as inside for a segment along it, but a single point is empty.
template <typename T>
[[nodiscard]] SegmentPart<T> clip_segment(glm::vec<2, T> p, glm::vec<2, T> d, glm::vec<2, T> lo,
                                          glm::vec<2, T> hi) {
  SegmentPart<T> part;
  for (int k = 0; k < 2; ++k) {
    if (d[k] == T{0}) {
      if (p[k] < lo[k] || p[k] > hi[k]) part.t1 = T{-1};
      continue;
    }
    const T at_lo = (lo[k] - p[k]) / d[k], at_hi = (hi[k] - p[k]) / d[k];
    part.t0 = std::max(part.t0, std::min(at_lo, at_hi));
    part.t1 = std::min(part.t1, std::max(at_lo, at_hi));
  }
  return part;
}

/// The part of a straight edge that satisfies linear conditions, as parameters along it. Empty
/// unless t0 < t1 (or t0 <= t1 if a single point counts).
struct EdgeRange {
  double t0 = 0.0;
  double t1 = 1.0;

  /// Keeps f >= 0, where f runs from f0 to f1 along the edge.
  void keep(double f0, double f1) {
    if (f0 < 0.0 && f1 < 0.0) {
      t1 = -1.0;
    } else if (f0 < 0.0) {
      t0 = std::max(t0, f0 / (f0 - f1));
    } else if (f1 < 0.0) {
      t1 = std::min(t1, f0 / (f0 - f1));
    }
  }
};

}  // namespace asos
