#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <span>

// Projected solid angles to the z axis, 0 to pi, of what lies above several horizons. Everything is
// relative to the receiver and may have been through a linear transform, which takes circles to
// ellipses and the receiver's horizons to others: what linearly transformed cosines (Heitz, Dupuy,
// Hill and Neubelt 2016) ask for. Double precision; finite for finite input.

namespace asos {

/// The directions above all of up to three planes through the receiver. The first is always z = 0.
class Horizons {
 public:
  static constexpr std::size_t most = 3;

  /// `normal` may have any length. One that is there already is not added once more: the border
  /// would count twice.
  void add(glm::dvec3 normal);
  [[nodiscard]] std::span<const glm::dvec3> normals() const { return {normals_.data(), count_}; }

 private:
  std::array<glm::dvec3, most> normals_{glm::dvec3(0, 0, 1)};  // unit
  std::size_t count_ = 1;
};

/// Of all directions.
[[nodiscard]] double whole_form(const Horizons& horizons);

/// A flat polygon, also a concave one. Positive if the corners run counter-clockwise as seen from
/// the receiver, negative if clockwise; the receiver must not lie in the polygon's plane.
[[nodiscard]] double polygon_form(std::span<const glm::dvec3> corners, const Horizons& horizons);

/// The ellipse centre + cos(angle) a + sin(angle) b, seen from either side; 0 from its plane.
[[nodiscard]] double ellipse_form(glm::dvec3 centre, glm::dvec3 a, glm::dvec3 b,
                                  const Horizons& horizons);

/// The part of a straight line above the horizons, as numbers from 0 (`begin`) to 1 (`end`); empty
/// where first >= second.
struct LinePart {
  double first = 0.0;
  double second = 1.0;
};
[[nodiscard]] LinePart part_above(glm::dvec3 begin, glm::dvec3 end, const Horizons& horizons);

}  // namespace asos
