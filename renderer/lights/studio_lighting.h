#pragma once

#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <functional>
#include <span>
#include <vector>

// Default lighting for a scene without lights of its own. It turns with the camera about +Y and not
// with its pitch, so that "above" stays above. Together with the sky's ambient light, a white
// diffuse surface is almost white.

namespace asos {

/// The radiance that a white diffuse surface of unit albedo reflects of a default light that it
/// faces.
inline constexpr double key_radiance = 0.60;
inline constexpr double fill_radiance = 0.16;

/// Returns the lights of a small studio: a key light from the upper left in front and a fill light
/// from the right, one-sided squares that face the centre of the bounding sphere. Both are 12 of
/// its radii away and half as wide as that, for soft shadows and nearly even light. A surface half
/// a radius nearer than the centre has the radiances above, the nearest one 1.1 times as much, and
/// the farthest 0.7. Bounds that are empty or a point count as a sphere of radius 1.
[[nodiscard]] std::vector<Light> studio_lighting(const Camera& camera, const Box& bounds);

/// A point of a surface that the camera sees.
struct SeenPoint {
  glm::dvec3 eye{0.0};  ///< start of its eye ray
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0, 1, 0};  ///< unit, on the viewer's side
};

/// Returns the distance from a point in a unit direction to the first surface that blocks light, or
/// infinity.
using FreeDistance = std::function<double(glm::dvec3 from, glm::dvec3 direction)>;

/// Returns whether the point faces the centre of a light with nothing in between.
[[nodiscard]] bool reached(const Light& light, const SeenPoint& point,
                           const FreeDistance& free_distance);

/// Returns the fraction of the points, 0 to 1, that one of the lights reaches.
[[nodiscard]] double reached_share(std::span<const Light> lights, std::span<const SeenPoint> seen,
                                   const FreeDistance& free_distance);

/// Returns default lighting for a view of an interior, where walls block a studio's lights. A key
/// light faces down from below the ceiling, and a fill light near the viewer faces the visible
/// points. Both stay clear of walls. They are above, or on, the free part of the eye ray to one of
/// nine visible points: the one whose key light reaches most of the others. Their width is up to
/// half the distance of the floor, or of that point. A light gives at most the radiances above to
/// the surface straight ahead. It is dimmer if needed, so that at most a tenth of the visible
/// points that it reaches get more. A viewer outside, who looks in through walls that are invisible
/// from behind, has the studio's fill light instead, without shadows, so that it reaches all
/// visible rooms. `seen` must not be empty.
[[nodiscard]] std::vector<Light> interior_lighting(const Camera& camera, const Box& bounds,
                                                   std::span<const SeenPoint> seen,
                                                   const FreeDistance& free_distance);

}  // namespace asos
