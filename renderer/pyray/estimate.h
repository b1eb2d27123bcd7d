#pragma once

#include "renderer/pyray/error_budget.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <optional>

namespace asos {

/// How a leaf is determined (design section 14).
enum class Estimator : std::uint8_t {
  centre,   ///< one sample represents it
  samples,  ///< the mean of samples distributed over it
  split,    ///< its four quarters
};

/// A value with its error and cost (design section 14). The value is the radiance of a leaf or of
/// its reflection, or the visible fraction of a light.
struct Estimate {
  glm::dvec3 value{0.0};
  /// A bound on the value's error, or its standard error, in display intensity (1 is white).
  double error = std::numeric_limits<double>::infinity();
  double cost = 0.0;  ///< in samples or rays

  [[nodiscard]] static Estimate exact(glm::dvec3 value) { return {value, 0.0}; }
  /// Returns whether the error is bounded, and within an allowance.
  [[nodiscard]] bool within(double allowed) const {
    return error <= allowed && error < std::numeric_limits<double>::infinity();
  }
};

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

/// The costs of a part's estimators, in samples of the part, and what its samples meet.
struct EstimatorCosts {
  double centre = 0.0;                 ///< samples replace it if they cost no more
  std::optional<double> quarter = {};  ///< without, the part may not be split
  double contrast = ErrorBudget::usual_contrast;
};

/// Returns the cheapest estimator with an error within the allowance, for a part of this weight
/// whose centre has this error. If none qualifies, returns the one with the least error (design
/// section 14).
[[nodiscard]] Estimator choose(const ErrorBudget& error_budget, double weight,
                               const ErrorBound& centre, const EstimatorCosts& costs);

}  // namespace asos
