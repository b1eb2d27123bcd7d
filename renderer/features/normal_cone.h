#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace asos {

/// A double cone around the normals of faces: all directions within an angle, below a right one, of
/// its axis or of the opposite. Sine and cosine of the angle are stored, since sums and halves of
/// angles then need no arc functions.
struct NormalCone {
  glm::dvec3 axis{0.0};
  double sine = 0.0;
  double cosine = 2.0;  ///< above 1: empty; 0: contains every direction

  static NormalCone everything() { return {{0, 0, 1}, 1.0, 0.0}; }
  [[nodiscard]] bool holds_nothing() const { return cosine > 1.0; }
  [[nodiscard]] bool holds_everything() const { return cosine <= 0.0; }
};

/// Returns the smallest cone that contains two unit normals themselves, and not their opposites.
/// Contains everything if they are more than 90 degrees apart, or not finite.
inline NormalCone cone_of(glm::dvec3 a, glm::dvec3 b) {
  if (!(glm::dot(a, b) >= 0.0)) return NormalCone::everything();
  const glm::dvec3 sum = a + b;
  const double length = glm::length(sum);
  return {sum / length, 0.5 * glm::length(a - b), 0.5 * length};
}

/// Returns the smallest cone that contains x and y; y is flipped first if the result is narrower
/// then.
inline NormalCone merge(const NormalCone& x, NormalCone y) {
  if (x.holds_nothing()) return y;
  if (y.holds_nothing()) return x;
  if (x.holds_everything() || y.holds_everything()) return NormalCone::everything();
  double between_cosine = glm::dot(x.axis, y.axis);
  if (between_cosine < 0.0) {
    y.axis = -y.axis;
    between_cosine = -between_cosine;
  }
  const double between_sine = glm::length(glm::cross(x.axis, y.axis));
  const auto within = [&](const NormalCone& inner, const NormalCone& outer) {
    return between_cosine * inner.cosine - between_sine * inner.sine >= outer.cosine;
  };
  if (within(y, x)) return x;
  if (within(x, y)) return y;
  // The new angle is half of the sum of both angles and the angle between the axes.
  const double both_sine = x.sine * y.cosine + x.cosine * y.sine;
  const double both_cosine = x.cosine * y.cosine - x.sine * y.sine;
  const double sum_sine = both_sine * between_cosine + both_cosine * between_sine;
  const double sum_cosine = both_cosine * between_cosine - both_sine * between_sine;
  if (sum_sine <= 0.0) return NormalCone::everything();
  NormalCone whole;
  whole.cosine = std::sqrt(std::max(0.0, 0.5 * (1.0 + sum_cosine)));
  whole.sine =
      sum_cosine > 0.0 ? 0.5 * sum_sine / whole.cosine : std::sqrt(0.5 * (1.0 - sum_cosine));
  // Turn x's axis towards y's by the difference between the new angle and x's.
  const glm::dvec3 side = glm::normalize(y.axis - x.axis * between_cosine);
  const double turn_sine = whole.sine * x.cosine - whole.cosine * x.sine;
  const double turn_cosine = whole.cosine * x.cosine + whole.sine * x.sine;
  whole.axis = turn_cosine * x.axis + turn_sine * side;
  return whole;
}

}  // namespace asos
