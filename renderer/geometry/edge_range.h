#pragma once

#include <algorithm>

namespace asos {

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
