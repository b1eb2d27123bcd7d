#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace asos {

/// The farthest from the origin, along an axis, that a camera or a light may stand, and the most
/// that a scene may be across. Rays that start outside, up to View's 1024 radii away, then have
/// squares of lengths that fit a float, and stay within what Embree takes (largest_traceable).
inline constexpr double largest_coordinate = 1e15;

/// Whether a place is within it; one that is not finite is not.
[[nodiscard]] inline bool within_reach(glm::dvec3 p) {
  const auto near = [](double x) { return std::abs(x) <= largest_coordinate; };
  return near(p.x) && near(p.y) && near(p.z);
}

/// The place nearest to `p` that is within it, for what is moved by hand.
[[nodiscard]] inline glm::dvec3 brought_within_reach(glm::dvec3 p) {
  return glm::clamp(p, glm::dvec3(-largest_coordinate), glm::dvec3(largest_coordinate));
}

}  // namespace asos
