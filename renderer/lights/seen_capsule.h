#pragma once

#include "renderer/lights/kinds/capsule_directions.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace asos {

/// A capsule in double precision, with its silhouette.
struct SeenCapsule : SeenCapsuleOf<glm::dvec3> {
  using SeenCapsuleOf::SeenCapsuleOf;

  /// Returns nothing for a receiver within the infinite cylinder. It sees one ball:
  /// see `nearest_of_axis`.
  [[nodiscard]] static std::optional<SeenCapsule> of(glm::dvec3 to_middle, glm::dvec3 half,
                                                     double radius);
  /// Returns the point of the axis, -half to half about to_middle, that is nearest to the receiver.
  [[nodiscard]] static glm::dvec3 nearest_of_axis(glm::dvec3 to_middle, glm::dvec3 half) {
    const double t = -glm::dot(to_middle, half) / glm::dot(half, half);
    return to_middle + std::clamp(t, -1.0, 1.0) * half;
  }

  /// Returns a point of an end's arc, relative to the receiver, by its angle from `outward` to
  /// across; `wider` scales its distance from the circle's centre.
  [[nodiscard]] glm::dvec3 on_arc(const End& end, double angle, double wider = 1.0) const {
    const double distance = glm::length(end.centre) * end.cosine;
    return distance *
           (end.cosine * end.axis +
            wider * end.sine * (std::cos(angle) * end.outward + std::sin(angle) * across));
  }
  /// Returns the silhouette as a polygon of the same area, relative to the receiver: for each end,
  /// from below `across` to above it, 2 * half_sides[end] sides and a side to the other end.
  [[nodiscard]] std::array<std::vector<glm::dvec3>, 2> silhouette(
      std::array<int, 2> half_sides) const;
  /// Divides `sides` between the arcs by their angles, at least two sides per half arc.
  [[nodiscard]] std::array<int, 2> half_sides(int sides) const;
};

inline std::optional<SeenCapsule> SeenCapsule::of(glm::dvec3 to_middle, glm::dvec3 half,
                                                  double radius) {
  const SeenCapsule seen(to_middle, half, radius);
  return seen.sine < 1.0 ? std::optional(seen) : std::nullopt;
}

inline std::array<int, 2> SeenCapsule::half_sides(int sides) const {
  const double part = ends[0].arc / (ends[0].arc + ends[1].arc);
  const int first = std::clamp(static_cast<int>(std::lround(0.5 * sides * part)), 2, sides / 2 - 2);
  return {first, sides / 2 - first};
}

inline std::array<std::vector<glm::dvec3>, 2> SeenCapsule::silhouette(
    std::array<int, 2> half_sides) const {
  std::array<std::vector<glm::dvec3>, 2> found;
  for (const std::size_t i : {0, 1}) {
    const End& end = ends[i];
    const int sides = 2 * half_sides[i];
    const double step = 2.0 * end.arc / sides;
    // The corners between the ends of the arc, which touch the straight sides, lie beyond it.
    const double inner = sides - 2.0;
    const double wider = (std::sqrt(1.0 + inner * sides * step / std::sin(step)) - 1.0) / inner;
    for (int k = 0; k <= sides; ++k)
      found[i].push_back(on_arc(end, k * step - end.arc, k % sides == 0 ? 1.0 : wider));
  }
  return found;
}

}  // namespace asos
