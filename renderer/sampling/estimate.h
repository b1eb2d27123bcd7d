#pragma once

#include <glm/glm.hpp>

#include <limits>

namespace asos {

/// A value, with its error and cost (design section 14).
struct Estimate {
  glm::dvec3 value{0.0};
  /// A proven bound on the value's error, or its standard error, in display intensity (1 is white).
  double error = std::numeric_limits<double>::infinity();
  double cost = 0.0;  ///< in samples
};

}  // namespace asos
