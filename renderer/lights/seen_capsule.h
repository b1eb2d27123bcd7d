#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace asos {

/// A capsule (all points within a radius of a segment) as seen from outside of the infinite
/// cylinder around it. The silhouette has two straight sides and an arc around each end. It is
/// symmetrical about the plane through the receiver and the axis. Longitudes are angles in that
/// plane from the foot of the receiver's perpendicular to the axis, and increase along the axis.
struct SeenCapsule {
  /// The ball at an end. The arc is its part of the circle in which the receiver's cone touches the
  /// ball: the angles up to `arc` to both sides of `outward`.
  struct End {
    glm::dvec3 centre;         ///< relative to the receiver
    glm::dvec3 axis, outward;  ///< unit: to the centre, and perpendicular, away from the middle
    double along = 0.0;        ///< from the foot to the centre, along the axis
    double sine = 0.0;         ///< of the ball's half angle
    double cosine = 1.0;       ///< of the ball's half angle
    double arc = 0.0;          ///< radians
    [[nodiscard]] double one_less_cosine() const { return sine * sine / (1.0 + cosine); }
  };

  glm::dvec3 foot, along, across;  ///< unit axes; across = foot x along
  double radius = 0.0, height = 0.0;
  double sine = 0.0, cosine = 1.0;  ///< of half the angle between the planes of the sides
  std::array<End, 2> ends;          ///< at the axis's begin and end

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
  SeenCapsule seen;
  seen.radius = radius;
  const double half_length = glm::length(half);
  seen.along = half / half_length;
  // Start at the nearer end, since the other may be so far that the foot would lose digits.
  const double side = glm::dot(to_middle, half) > 0.0 ? -1.0 : 1.0;
  const glm::dvec3 nearer = to_middle + side * half;
  const double along = glm::dot(nearer, seen.along);
  const glm::dvec3 foot = nearer - along * seen.along;
  seen.height = glm::length(foot);
  seen.foot = foot / seen.height;
  seen.across = glm::cross(seen.foot, seen.along);
  seen.sine = radius / seen.height;
  if (!(seen.sine < 1.0)) return std::nullopt;
  seen.cosine = std::sqrt((1.0 - seen.sine) * (1.0 + seen.sine));
  for (const std::size_t i : {0, 1}) {
    End& end = seen.ends[i];
    const double outward = i == 1 ? 1.0 : -1.0;
    end.along = along + (outward - side) * half_length;
    end.centre = foot + end.along * seen.along;
    const double distance = std::hypot(seen.height, end.along);
    const double cosine = seen.height / distance, sine = end.along / distance;
    end.axis = cosine * seen.foot + sine * seen.along;
    end.outward = outward * (cosine * seen.along - sine * seen.foot);
    end.sine = radius / distance;
    end.cosine = std::sqrt((1.0 - end.sine) * (1.0 + end.sine));
    end.arc = std::atan2(seen.cosine, outward * seen.sine * sine);
  }
  return seen;
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
