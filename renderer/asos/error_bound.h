#pragma once

namespace asos {

/// Bound on the error of a leaf's centre as the mean of the leaf, in display intensity, and on the
/// contrast of the leaf's samples (design section 14). Bounds of independent causes add up, in any
/// order.
struct ErrorBound {
  double error = 0.0;
  /// Contrast of the leaf's samples beyond the usual, such as that of highlights.
  double contrast = 0.0;
  /// The error has no bound: only samples determine the leaf.
  bool unbounded = false;

  [[nodiscard]] static ErrorBound of(double error) { return {error, 0.0, false}; }
  [[nodiscard]] static ErrorBound none() { return {}; }
  [[nodiscard]] static ErrorBound unknown(bool is = true) { return {0.0, 0.0, is}; }

  ErrorBound& operator+=(const ErrorBound& other) {
    error += other.error;
    contrast += other.contrast;
    unbounded |= other.unbounded;
    return *this;
  }
  friend ErrorBound operator+(ErrorBound a, const ErrorBound& b) { return a += b; }
};

}  // namespace asos
