#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <functional>
#include <span>
#include <vector>

// Lights for a scene that has none of its own. They turn with the camera about +Y and not with its
// pitch, so that "above" stays above. With the sky's ambient light a white diffuse surface comes
// near white and stays below it.

namespace asos {

/// The radiance that a white diffuse surface of unit albedo reflects of a light of the rig that it
/// faces.
inline constexpr double key_radiance = 0.60;
inline constexpr double fill_radiance = 0.16;

/// As in a small studio: a key light from the upper left in front and a fill light from the right,
/// one-sided squares that face the middle of the bounding sphere. Both are 12 of its radii away and
/// half as wide as that, for soft shadows and nearly even light: a surface half a radius nearer
/// than the middle gets the radiances above, the nearest of all 1.1 times as much, the farthest
/// 0.7. Bounds that are empty or a point count as a sphere of radius 1.
[[nodiscard]] std::vector<Light> studio_rig(const Camera& camera, const Box& bounds);

/// A point of a surface that the camera sees.
struct SeenPoint {
  glm::dvec3 eye{0.0};  ///< where its eye ray starts
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0, 1, 0};  ///< unit, to the viewer's side
};

/// How far light goes from a point in a unit direction before a surface blocks it; or infinity.
using FreeDistance = std::function<double(glm::dvec3 from, glm::dvec3 direction)>;

/// Whether the point faces the middle of a light with nothing between.
[[nodiscard]] bool reached(const Light& light, const SeenPoint& point,
                           const FreeDistance& free_distance);

/// The share of the points, 0 to 1, that one of the lights reaches.
[[nodiscard]] double reached_share(std::span<const Light> lights, std::span<const SeenPoint> seen,
                                   const FreeDistance& free_distance);

/// For what is seen of an interior, which walls shut off from a studio's lights: a key light that
/// faces down from below the ceiling and a fill light near the viewer that faces what is seen. Both
/// stay clear of walls, hang over, or on, the free stretch of the eye ray to one of nine seen
/// points (that whose key light reaches most of the others), and are up to half as wide as the
/// floor, or that point, is far. A light gives the radiances above to what lies straight
/// ahead of it, or less, so that of the seen points that it reaches a tenth may get more. A viewer
/// who looks in from outside, through walls that are not seen from behind, has the studio's fill
/// light instead, which casts no shadows then: it reaches all rooms as the eye does. `seen` must
/// not be empty.
[[nodiscard]] std::vector<Light> interior_rig(const Camera& camera, const Box& bounds,
                                              std::span<const SeenPoint> seen,
                                              const FreeDistance& free_distance);

}  // namespace asos
