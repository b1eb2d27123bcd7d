#include "renderer/reflections/mirror_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// A shading normal this close to the triangle's is treated as the triangle's.
constexpr float same_normal = 1.0f - 1e-6f;

// Error of a ray's hit with a plane in single precision, relative to the ray's length and the
// coordinates of its origin.
constexpr double ray_rounding = 4.0 * std::numeric_limits<float>::epsilon();

// Uses the triangle's plane through one of its corners, which has no rounding error. Rays start
// above it by their own rounding error only, so that objects on a mirror are reflected down to
// their base.
void take_plane(const World& world, const Hit& hit, double ray_length, MirrorSurface& surface) {
  const glm::uvec3 v = world.triangles[hit.triangle];
  const glm::dvec3 p0(world.positions[v.x]);
  const glm::dvec3 n =
      glm::cross(glm::dvec3(world.positions[v.y]) - p0, glm::dvec3(world.positions[v.z]) - p0);
  const double length = glm::length(n);
  if (!(length > 0.0)) return;
  const glm::dvec3 unit = glm::dot(n, surface.normal) < 0.0 ? -n / length : n / length;
  surface.position -= glm::dot(surface.position - p0, unit) * unit;
  surface.normal = surface.geometric = unit;
  surface.hit_tolerance = surface.clearance;
  const glm::dvec3 p = glm::abs(surface.position);
  const double rounding = ray_rounding * (std::max({p.x, p.y, p.z}) + ray_length);
  surface.clearance = std::min(surface.clearance, rounding);
}

// Returns the height of a concave surface at the patch's corners, to second order and with a margin
// for higher orders. The normals of a concave surface lean towards each other.
double hollow_rise(const MirrorPatch& patch, glm::dvec3 turn_right, glm::dvec3 turn_down) {
  const double along_right = glm::dot(turn_right, patch.right);
  const double along_down = glm::dot(turn_down, patch.down);
  constexpr double room = 1.25;
  return room * (std::max(0.0, -along_right) + std::max(0.0, -along_down)) / 8.0;
}

}  // namespace

MirrorSurface mirror_surface(const World& world, const Hit& hit, const SurfacePoint& point,
                             const IncidentPyray& pyray, bool bent) {
  MirrorSurface surface;
  surface.position = glm::dvec3(point.position);
  surface.normal = glm::dvec3(point.shading_normal);
  surface.geometric = glm::dvec3(point.geometric_normal);
  surface.clearance = static_cast<double>(clear_height(point));
  if (!world.is_face(hit.triangle) &&
      glm::dot(point.shading_normal, point.geometric_normal) > same_normal)
    take_plane(world, hit, pyray.perspective ? pyray.distance * glm::length(pyray.axis) : 0.0,
               surface);
  const MirrorPatch patch = patch_of(pyray, surface.geometric);
  const NormalSpread turn = normal_turn(world, hit, {glm::vec3(patch.right), glm::vec3(patch.down)},
                                        point.shading_normal);
  const glm::dvec3 turn_right(turn.right), turn_down(turn.down);
  surface.rise = hollow_rise(patch, turn_right, turn_down);
  surface.fall = hollow_rise(patch, -turn_right, -turn_down);
  if (!bent) return surface;
  surface.turn_right = turn_right;
  surface.turn_down = turn_down;
  return surface;
}

Ray ray_leaving(const MirrorSurface& surface, glm::dvec3 direction) {
  Ray ray;
  ray.direction = glm::vec3(direction);
  ray.origin = glm::vec3(surface.position);
  const double slope = glm::dot(direction, surface.geometric);
  ray.t_near = slope > 0.0 ? static_cast<float>(surface.clearance / slope)
                           : std::numeric_limits<float>::infinity();
  return ray;
}

std::optional<MirrorPlane> plane_of(const MirrorSurface& surface) {
  if (!(surface.hit_tolerance > 0.0)) return std::nullopt;
  return MirrorPlane{{surface.geometric, glm::dot(surface.geometric, surface.position)},
                     surface.hit_tolerance};
}

IncidentPyray pyray_around(const PixelSpacing& spacing, const Ray& ray, float t, float side) {
  IncidentPyray pyray;
  const glm::dvec3 direction(ray.direction);
  const double ahead = glm::dot(direction, glm::dvec3(spacing.forward));
  pyray.perspective = spacing.perspective;
  pyray.axis = spacing.perspective ? direction / ahead : direction;
  pyray.right = static_cast<double>(side) * glm::dvec3(spacing.right);
  pyray.down = static_cast<double>(side) * glm::dvec3(spacing.down);
  pyray.distance = static_cast<double>(spacing.start + t) * (spacing.perspective ? ahead : 1.0);
  return pyray;
}

PixelSpacing spacing_of(const MirroredPyray& pyray, float side) {
  PixelSpacing spacing;
  spacing.perspective = pyray.picture.perspective;
  spacing.forward = glm::vec3(pyray.picture.forward);
  spacing.right = glm::vec3(pyray.picture.right / static_cast<double>(side));
  spacing.down = glm::vec3(pyray.picture.down / static_cast<double>(side));
  spacing.start =
      std::isfinite(pyray.apex_distance) ? static_cast<float>(pyray.apex_distance) : 0.0f;
  return spacing;
}

}  // namespace asos
