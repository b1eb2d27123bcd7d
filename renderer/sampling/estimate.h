#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace asos {

/// A value that was determined in one of several ways, and how well (design section 14).
struct Estimate {
  glm::dvec3 value{0.0};
  /// Of the value, in display intensity, 1 is white: a proven bound, or a standard error.
  double error = std::numeric_limits<double>::infinity();
  double cost = 0.0;  ///< in samples
};

}  // namespace asos
