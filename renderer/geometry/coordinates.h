#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace asos {

/// Largest distance of a camera or a light from the origin, along an axis, and largest extent of a
/// scene. Rays that start outside, up to View's 1024 radii away, then have squared lengths that fit
/// a float, and stay within Embree's limit (largest_traceable).
inline constexpr double largest_coordinate = 1e15;

/// Returns whether a place is finite and its coordinates are within largest_coordinate.
[[nodiscard]] inline bool within_reach(glm::dvec3 p) {
  const auto near = [](double x) { return std::abs(x) <= largest_coordinate; };
  return near(p.x) && near(p.y) && near(p.z);
}

/// Clamps coordinates to largest_coordinate, for objects that the user moves.
[[nodiscard]] inline glm::dvec3 brought_within_reach(glm::dvec3 p) {
  return glm::clamp(p, glm::dvec3(-largest_coordinate), glm::dvec3(largest_coordinate));
}

}  // namespace asos
