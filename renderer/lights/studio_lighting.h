#pragma once

#include "renderer/lights/prepared_light.h"
#include "renderer/scene/scene.h"
#include "renderer/world/world.h"

#include <glm/glm.hpp>

#include <cmath>
#include <functional>
#include <span>
#include <vector>

// Default lighting for a scene without lights of its own. It turns with the camera about +Y and not
// with its pitch, so that "above" stays above. Together with the sky's ambient light, a white
// diffuse surface is almost white.

namespace asos {

/// Returns right, up and back to the viewer for default lights that turn with a camera about +Y.
[[nodiscard]] inline glm::dmat3 lighting_axes(const Camera& camera) {
  const glm::dmat4& m = camera.world_from_camera;
  // A camera that looks straight down or up has no "behind" on the ground, so its up vector is
  // used.
  glm::dvec3 back(m[2].x, 0.0, m[2].z);
  if (!(glm::length(back) > 1e-3)) back = {-m[1].x, 0.0, -m[1].z};
  if (!(glm::length(back) > 1e-3)) back = {0.0, 0.0, 1.0};
  back = glm::normalize(back);
  const glm::dvec3 up(0.0, 1.0, 0.0);
  return {glm::cross(up, back), up, back};
}

/// Returns a one-sided rectangle of 1 nit that casts shadows. `direction` is unit. `right` is any
/// vector not parallel to it; half_u follows `right`.
[[nodiscard]] inline Light lighting_rectangle(const char* name, glm::dvec3 middle,
                                              glm::dvec3 direction, glm::dvec3 right,
                                              double half_width, double half_height) {
  Light light;
  light.name = name;
  light.type = Light::Type::rectangle;
  light.position = middle;
  light.direction = direction;
  const glm::dvec3 v = glm::normalize(glm::cross(direction, right));
  light.half_u = half_width * glm::cross(v, direction);
  light.half_v = half_height * v;
  return light;
}

/// Returns the unshadowed irradiance of a surface from a light of 1 nit.
[[nodiscard]] inline double irradiance_of_unit(const Light& light, glm::dvec3 position,
                                               glm::dvec3 normal) {
  return unshadowed_irradiance(prepare_light(light), Receiver{position, normal, normal}).x;
}

/// The radiance that a white diffuse surface of unit albedo reflects of a default light that it
/// faces, in the light's strongest colour component.
inline constexpr double key_radiance = 0.60;
inline constexpr double fill_radiance = 0.16;

/// Returns the lights of a small studio: a warm key light from the upper left in front and a cool
/// fill light from the right, one-sided squares that face the centre of the bounding sphere. Both
/// are 12 of its radii away and 0.4 as wide as that, for soft shadows and nearly even light. A
/// surface half
/// a radius nearer than the centre has the radiances above, the nearest one 1.1 times as much, and
/// the farthest 0.7. Bounds that are empty or a point count as a sphere of radius 1.
[[nodiscard]] std::vector<Light> studio_lighting(const Camera& camera, const Box& bounds);

/// A point of a surface that the camera sees.
struct SeenPoint {
  glm::dvec3 eye{0.0};  ///< start of the point's eye ray
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
