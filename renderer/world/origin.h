#pragma once

#include <glm/glm.hpp>

#include <limits>
#include <vector>

namespace asos {

/// The box of a part of a scene in the author's coordinates.
struct PlacedBox {
  glm::dvec3 lo{std::numeric_limits<double>::infinity()};
  glm::dvec3 hi{-std::numeric_limits<double>::infinity()};

  void grow(glm::dvec3 p) { lo = glm::min(lo, p), hi = glm::max(hi, p); }
  [[nodiscard]] glm::dvec3 middle() const { return 0.5 * lo + 0.5 * hi; }
  /// Returns its longest side.
  [[nodiscard]] double extent() const;
};

/// Returns the origin for positions in single precision: the `middle` of everything. If a small
/// part would lose its shape to rounding there, returns that part's centre, provided all parts keep
/// their shapes far better then (a house at the corner of a planet). There is at least one part.
[[nodiscard]] glm::dvec3 choose_origin(const std::vector<PlacedBox>& parts, glm::dvec3 middle);

}  // namespace asos
