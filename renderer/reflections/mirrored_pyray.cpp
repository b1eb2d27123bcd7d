#include "renderer/reflections/mirrored_pyray.h"

#include "renderer/geometry/finite.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asos {
namespace {

// Reflected unit directions rise at least this far above the surface.
constexpr auto least_rise = static_cast<double>(least_mirrored_rise);
// Limits the length of steep patches, as patch_on_plane does.
constexpr double steepest = 1.0 / 64.0;

struct MirroredEdges {
  glm::dvec3 axis;  // unit
  glm::dvec3 right, down;
};

// Returns the change of the reflected direction along an edge of the pyray: the derivative of D - 2
// (D.N) N.
glm::dvec3 reflected_edge(glm::dvec3 axis, glm::dvec3 edge, glm::dvec3 normal, glm::dvec3 turn) {
  const double along = glm::dot(axis, normal);
  return edge - 2.0 * ((glm::dot(edge, normal) + glm::dot(axis, turn)) * normal + along * turn);
}

MirroredEdges mirrored_edges(const IncidentPyray& pyray, const MirrorSurface& surface) {
  MirroredEdges edges;
  const double length = glm::length(pyray.axis);
  const glm::dvec3 none(0.0);
  edges.axis = mirrored_direction(surface, pyray.axis);
  if (surface.ratio > 0.0) {
    const glm::dvec3 axis = pyray.axis / length;
    const double opening = pyray.perspective ? 1.0 / length : 0.0;
    edges.right =
        mirrored_edge(surface, axis, opening * across(pyray.right, axis), surface.turn_right);
    edges.down =
        mirrored_edge(surface, axis, opening * across(pyray.down, axis), surface.turn_down);
    return edges;
  }
  edges.right = reflected_edge(pyray.axis, pyray.perspective ? pyray.right : none, surface.normal,
                               surface.turn_right) /
                length;
  edges.down = reflected_edge(pyray.axis, pyray.perspective ? pyray.down : none, surface.normal,
                              surface.turn_down) /
               length;
  return edges;
}

// Extends an edge by the lobe, in the same direction.
glm::dvec3 widened(glm::dvec3 edge, glm::dvec3 lobe_axis, double width) {
  return edge + (glm::dot(edge, lobe_axis) < 0.0 ? -width : width) * lobe_axis;
}

// Returns an edge of a picture after reflection; refraction keeps it.
glm::dvec3 carried(glm::dvec3 edge, const MirrorSurface& surface) {
  return surface.ratio > 0.0 ? edge : glm::reflect(edge, surface.normal);
}

double share_of(glm::dvec3 edge, glm::dvec3 wide) {
  const double length = glm::length(wide);
  return length > 0.0 ? std::min(1.0, glm::length(edge) / length) : 1.0;
}

// Returns the pyray's own edges at the surface, mirrored. They replace the patch, which is
// shortened at very steep views.
MirrorPatch mirrored_patch(const IncidentPyray& pyray, const MirrorSurface& surface) {
  const double scale = pyray.perspective ? pyray.distance : 1.0;
  return {scale * carried(pyray.right, surface), scale * carried(pyray.down, surface)};
}

// Returns the apex distance at which a pyramid with these edges leaves the surface within the patch
// in both directions. Otherwise it would contain surroundings of the mirror. Returns nothing if
// there is no such distance.
std::optional<double> apex_within(const MirrorPatch& patch, glm::dvec3 axis, glm::dvec3 right,
                                  glm::dvec3 down) {
  const glm::dvec3 a = across(right, axis), b = across(down, axis);
  const double nearest = std::min(glm::dot(across(patch.right, axis), a) / glm::dot(a, a),
                                  glm::dot(across(patch.down, axis), b) / glm::dot(b, b));
  return nearest > 0.0 && std::isfinite(nearest) ? std::optional(nearest) : std::nullopt;
}

// Returns the distance at which the rays through the patch, continued backwards, are nearest to
// each other. This is the s that minimizes the patch's edges less s times the change of direction.
double nearest_apex(const MirrorPatch& patch, glm::dvec3 axis, glm::dvec3 right, glm::dvec3 down) {
  const glm::dvec3 a = across(right, axis), b = across(down, axis);
  return (glm::dot(across(patch.right, axis), a) + glm::dot(across(patch.down, axis), b)) /
         (glm::dot(a, a) + glm::dot(b, b));
}

std::optional<MirroredPyray> parallel(const MirroredEdges& edges, const MirrorPatch& patch,
                                      const MirrorSurface& surface) {
  MirroredPyray out;
  PyrayPicture& p = out.picture;
  p.perspective = false;
  p.forward = edges.axis;
  p.right = across(patch.right, edges.axis);
  p.down = across(patch.down, edges.axis);
  const double back = glm::length(patch.right) + glm::length(patch.down);
  p.apex = surface.position - back * edges.axis;
  p.corner = p.forward - 0.5 * (p.right + p.down);
  out.apex_distance = std::numeric_limits<double>::infinity();
  if (!finite(p.right) || !finite(p.down) || p.right == glm::dvec3(0.0)) return std::nullopt;
  return out;
}

std::optional<MirroredPyray> diverging(const MirroredEdges& edges, double apex_distance,
                                       const MirrorLobe& lobe, const MirrorSurface& surface) {
  MirroredPyray out;
  PyrayPicture& p = out.picture;
  const glm::dvec3 right = widened(edges.right, lobe.right, lobe.width);
  const glm::dvec3 down = widened(edges.down, lobe.down, lobe.width);
  if (lobe.width > 0.0)
    out.sharp_share = {share_of(edges.right, right), share_of(edges.down, down)};
  out.apex_distance = apex_distance;
  const glm::dvec3 face = glm::cross(right, down);
  p.forward = glm::normalize(glm::dot(face, edges.axis) < 0.0 ? -face : face);
  const double ahead = 1.0 / glm::dot(p.forward, edges.axis);
  p.right = ahead * right;
  p.down = ahead * down;
  p.apex = surface.position - apex_distance * edges.axis;
  p.corner = ahead * edges.axis - 0.5 * (p.right + p.down);
  if (!finite(p.forward) || !finite(p.corner) || !finite(p.apex)) return std::nullopt;
  return out;
}

// Returns the cosine to the normal behind a refracting surface, for a ray with `cosine` in front of
// it; 0 beyond the critical angle.
double cosine_behind(double cosine, double ratio) {
  return std::sqrt(std::max(0.0, 1.0 - ratio * ratio * (1.0 - cosine * cosine)));
}

// Snell's law: r D + (r c - c') N with the cosines c before and c' behind.
glm::dvec3 refracted(const MirrorSurface& surface, glm::dvec3 unit) {
  const double cosine = -glm::dot(unit, surface.normal);
  const double behind = cosine_behind(cosine, surface.ratio);
  return glm::normalize(surface.ratio * unit + (surface.ratio * cosine - behind) * surface.normal);
}

}  // namespace

MirrorSurface refracting(MirrorSurface surface, double ratio) {
  surface.ratio = ratio;
  surface.geometric = -surface.geometric;
  std::swap(surface.rise, surface.fall);
  return surface;
}

glm::dvec3 mirrored_edge(const MirrorSurface& surface, glm::dvec3 unit_axis, glm::dvec3 edge,
                         glm::dvec3 turn) {
  const double r = surface.ratio;
  if (!(r > 0.0)) return reflected_edge(unit_axis, edge, surface.normal, turn);
  // The derivative of r D + (r c - c') N.
  const double cosine = -glm::dot(unit_axis, surface.normal);
  const double behind = std::max(cosine_behind(cosine, r), steepest);
  const double change = -(glm::dot(edge, surface.normal) + glm::dot(unit_axis, turn));
  return r * edge + (r - r * r * cosine / behind) * change * surface.normal +
         (r * cosine - behind) * turn;
}

glm::dvec3 mirrored_direction(const MirrorSurface& surface, glm::dvec3 direction) {
  glm::dvec3 d = surface.ratio > 0.0 ? refracted(surface, glm::normalize(direction))
                                     : glm::normalize(glm::reflect(direction, surface.normal));
  const double rise = glm::dot(d, surface.geometric);
  if (rise < least_rise) d = glm::normalize(d + (least_rise - rise) * surface.geometric);
  return d;
}

MirrorLobe lobe_around(const MirrorSurface& surface, glm::dvec3 mirrored, glm::dvec3 picture_right,
                       double width) {
  const glm::dvec3 right = across(carried(picture_right, surface), mirrored);
  MirrorLobe lobe;
  lobe.right = glm::normalize(right);
  lobe.down = glm::cross(mirrored, lobe.right);
  lobe.width = width;
  return lobe;
}

MirrorPatch patch_of(const IncidentPyray& pyray, glm::dvec3 normal) {
  const glm::dvec3 unit = glm::normalize(pyray.axis);
  const double cosine = glm::dot(normal, unit);
  const double safe = std::copysign(std::max(std::abs(cosine), steepest), cosine);
  const double scale = pyray.perspective ? pyray.distance : 1.0;
  const auto moved = [&](glm::dvec3 edge) {
    return scale * (edge - unit * (glm::dot(normal, edge) / safe));
  };
  return {moved(pyray.right), moved(pyray.down)};
}

std::optional<MirroredPyray> mirrored(const IncidentPyray& pyray, const MirrorSurface& surface,
                                      const MirrorLobe& lobe) {
  const MirroredEdges edges = mirrored_edges(pyray, surface);
  const MirrorPatch patch = patch_of(pyray, surface.geometric);
  const bool sharp = !(lobe.width > 0.0);
  std::optional<MirroredPyray> out;
  // A plane without blur keeps the apex, mirrored, and keeps parallel rays parallel. After
  // refraction there is no apex.
  const bool keeps_apex = surface.ratio == 0.0 || !pyray.perspective;
  if (sharp && !surface.bent() && keeps_apex) {
    out = pyray.perspective
              ? diverging(edges, pyray.distance * glm::length(pyray.axis), lobe, surface)
              : parallel(edges, patch, surface);
  } else {
    const glm::dvec3 right = widened(edges.right, lobe.right, lobe.width);
    const glm::dvec3 down = widened(edges.down, lobe.down, lobe.width);
    // With blur, the pyramid stays within the patch if it can. Else its apex is where the reflected
    // rays, continued backwards, are nearest to each other.
    const MirrorPatch seen = surface.bent() ? patch : mirrored_patch(pyray, surface);
    const auto within = sharp ? std::nullopt : apex_within(seen, edges.axis, right, down);
    const double apex = within ? *within : nearest_apex(seen, edges.axis, right, down);
    if (apex > 0.0 && std::isfinite(apex)) {
      out = diverging(edges, apex, lobe, surface);
    } else if (surface.bent()) {
      // The rays meet in front of the mirror, so use its tangent plane.
      MirrorSurface plane = surface;
      plane.turn_right = plane.turn_down = glm::dvec3(0.0);
      return mirrored(pyray, plane, lobe);
    }
  }
  if (!out) return std::nullopt;
  // The pyray begins above the surface.
  const double height =
      glm::dot(surface.geometric, surface.position) + surface.clearance + surface.rise;
  out->picture.beyond = {surface.geometric, height};
  return out;
}

double reflected_angle(const IncidentPyray& pyray, const MirrorSurface& surface) {
  const MirroredEdges edges = mirrored_edges(pyray, surface);
  const double diagonal =
      std::max(glm::length(edges.right + edges.down), glm::length(edges.right - edges.down));
  return 2.0 * std::atan(0.5 * diagonal);
}

}  // namespace asos
