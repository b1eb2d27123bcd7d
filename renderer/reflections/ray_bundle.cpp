#include "renderer/reflections/ray_bundle.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// The share of its size at `t` that a pyramid has at the surface: not so near 0 that it begins at
// the surface itself, nor so near 1 that its apex is where doubles end.
constexpr double least_share = 1.0 / 64.0;
constexpr double most_share = 63.0 / 64.0;

// A section is at least so much, of what it would be without a focus.
constexpr double least_width = 1e-3;

// An edge of the section at `t`: where the rays meet there, still of some length.
glm::dvec3 edge_at(glm::dvec3 at, glm::dvec3 turn, double t, glm::dvec3 axis) {
  const glm::dvec3 start = across(at, axis), moved = t * across(turn, axis);
  const glm::dvec3 edge = start + moved;
  const double least = least_width * (glm::length(start) + glm::length(moved));
  return glm::length(edge) < least ? edge + least * glm::normalize(moved) : edge;
}

// One direction across a blurred bundle, at a section. Which way the lobe's edge runs is all the
// same.
struct BlurredAxis {
  glm::dvec3 unit;   // along the section
  double own = 0.0;  // width of the section, and what blur adds to it
  double blur = 0.0;
  glm::dvec3 turn;  // what each of them changes of the direction, over its width
  glm::dvec3 lobe;

  BlurredAxis(glm::dvec3 section, double t, glm::dvec3 turn_, glm::dvec3 lobe_)
      : unit(glm::normalize(glm::length(section) > t * glm::length(lobe_) ? section : lobe_)),
        turn(turn_),
        lobe(lobe_) {
    if (glm::dot(section, unit) < 0.0) unit = -unit;
    if (glm::dot(lobe, unit) < 0.0) lobe = -lobe;
    own = glm::dot(section, unit);
    blur = t * glm::dot(lobe, unit);
  }
  [[nodiscard]] double variance() const { return own * own + blur * blur; }
  [[nodiscard]] double width() const { return own + blur; }
  /// What a step along the section changes of the direction, as the mean of all rays there.
  [[nodiscard]] glm::dvec3 slope() const { return (own * turn + blur * lobe) / variance(); }
  /// The edge over which the direction varies in one place.
  [[nodiscard]] glm::dvec3 rest() const {
    return (blur * turn - own * lobe) / std::sqrt(variance());
  }
};

}  // namespace

RayBundle RayBundle::of(const Frame& frame, const Bounds2& part) {
  const glm::dvec2 size(part.hi - part.lo);
  const glm::dvec2 middle = glm::dvec2(part.lo) + 0.5 * size;
  const glm::dvec3 right = size.x * frame.base_u(), down = size.y * frame.base_v();
  RayBundle bundle;
  if (frame.parallel()) {
    bundle.origin = frame.world({middle.x, middle.y, 0.0});
    bundle.direction = glm::normalize(frame.direction());
    bundle.right_at = right;
    bundle.down_at = down;
    return bundle;
  }
  const glm::dvec3 axis =
      frame.base_corner() + middle.x * frame.base_u() + middle.y * frame.base_v();
  const double length = glm::length(axis);
  bundle.origin = frame.apex();
  bundle.direction = axis / length;
  bundle.right = across(right, bundle.direction) / length;
  bundle.down = across(down, bundle.direction) / length;
  return bundle;
}

RayBundle RayBundle::part(const Bounds2& part) const {
  const glm::dvec2 size(part.hi - part.lo);
  const glm::dvec2 off = glm::dvec2(part.lo) + 0.5 * size - 0.5;
  RayBundle bundle;
  bundle.origin = origin + off.x * right_at + off.y * down_at;
  bundle.direction = glm::normalize(direction + off.x * right + off.y * down);
  bundle.right_at = size.x * right_at;
  bundle.down_at = size.y * down_at;
  bundle.right = across(size.x * right, bundle.direction);
  bundle.down = across(size.y * down, bundle.direction);
  return bundle;
}

RayBundle RayBundle::of(const MirroredPyray& pyray, glm::dvec3 position) {
  const PyrayPicture& p = pyray.picture;
  const glm::dvec3 axis = p.corner + 0.5 * (p.right + p.down);
  const double length = glm::length(axis);
  RayBundle bundle;
  bundle.origin = position;
  bundle.direction = axis / length;
  const glm::dvec3 right = across(p.right, bundle.direction) / length;
  const glm::dvec3 down = across(p.down, bundle.direction) / length;
  bundle.right_at = pyray.apex_distance * right;
  bundle.down_at = pyray.apex_distance * down;
  bundle.right = pyray.sharp_share.x * right;
  bundle.down = pyray.sharp_share.y * down;
  bundle.lobe_right = right - bundle.right;
  bundle.lobe_down = down - bundle.down;
  return bundle;
}

RayBundle RayBundle::blurred_part(const Bounds2& part, double t) const {
  const MirrorPatch there = section(t);
  const BlurredAxis u(there.right, t, right, lobe_right), v(there.down, t, down, lobe_down);
  const glm::dvec2 size(part.hi - part.lo);
  const glm::dvec2 widths(u.width(), v.width());
  const glm::dvec2 off = widths * (glm::dvec2(part.lo) + 0.5 * size - 0.5), wide = widths * size;
  RayBundle bundle;
  const glm::dvec3 slope_u = u.slope(), slope_v = v.slope();
  bundle.direction = glm::normalize(direction + off.x * slope_u + off.y * slope_v);
  const double way = t * glm::dot(direction, bundle.direction);
  bundle.origin = origin + t * direction + off.x * u.unit + off.y * v.unit - way * bundle.direction;
  bundle.right = across(wide.x * slope_u, bundle.direction);
  bundle.down = across(wide.y * slope_v, bundle.direction);
  bundle.right_at = wide.x * u.unit - way * bundle.right;
  bundle.down_at = wide.y * v.unit - way * bundle.down;
  bundle.lobe_right = u.rest();
  bundle.lobe_down = v.rest();
  return bundle;
}

RayBundle mirrored(const RayBundle& bundle, const MirrorSurface& surface) {
  const double t = glm::dot(surface.position - bundle.origin, bundle.direction);
  const MirrorPatch section = bundle.section(t);
  IncidentPyray beam;
  beam.perspective = false;
  beam.axis = bundle.direction;
  beam.right = section.right;
  beam.down = section.down;
  const MirrorPatch patch = patch_of(beam, surface.geometric);
  RayBundle out;
  out.origin = surface.position;
  out.direction = mirrored_direction(surface, bundle.direction);
  out.right_at = patch.right;
  out.down_at = patch.down;
  const auto turned = [&](glm::dvec3 edge, glm::dvec3 turn) {
    return across(mirrored_edge(surface, bundle.direction, edge, turn), out.direction);
  };
  out.right = turned(bundle.right, surface.turn_right);
  out.down = turned(bundle.down, surface.turn_down);
  if (bundle.blurred()) {
    out.lobe_right = turned(bundle.lobe_right, glm::dvec3(0.0));
    out.lobe_down = turned(bundle.lobe_down, glm::dvec3(0.0));
  }
  return out;
}

std::optional<MirroredPyray> pyramid_around(const RayBundle& bundle, const MirrorSurface& surface,
                                            double t) {
  const glm::dvec3 axis = bundle.direction;
  glm::dvec3 right = edge_at(bundle.right_at, bundle.right, t, axis);
  glm::dvec3 down = edge_at(bundle.down_at, bundle.down, t, axis);
  MirroredPyray out;
  const bool blurred = bundle.blurred();
  if (blurred) {
    const auto widen = [t](glm::dvec3& edge, glm::dvec3 lobe) {
      const double own = glm::length(edge), blur = t * glm::length(lobe);
      edge *= (own + blur) / own;
      return own / (own + blur);
    };
    out.sharp_share = {widen(right, bundle.lobe_right), widen(down, bundle.lobe_down)};
  }
  // In a focal line the edges lie on each other.
  const glm::dvec3 beside = glm::cross(axis, right);
  const double area = glm::dot(beside, down);
  const double least = least_width * glm::length(right) * glm::length(down);
  if (std::abs(area) < least) down += std::copysign(least, area) / glm::dot(right, right) * beside;

  const glm::dvec3 patch_right = across(bundle.right_at, axis);
  const glm::dvec3 patch_down = across(bundle.down_at, axis);
  const double of_right = glm::dot(patch_right, right), of_down = glm::dot(patch_down, down);
  const double right2 = glm::dot(right, right), down2 = glm::dot(down, down);
  const double fitting = blurred ? std::min(of_right / right2, of_down / down2)
                                 : (of_right + of_down) / (right2 + down2);
  const double share = std::clamp(fitting, least_share, most_share);
  const double before = t * share / (1.0 - share);
  // On the surface all of it is sharp, and far away so much that it is right at `t`.
  if (blurred) out.sharp_share = glm::clamp((out.sharp_share - share) / (1.0 - share), 0.0, 1.0);

  out.apex_distance = before;
  PyrayPicture& p = out.picture;
  p.apex = bundle.origin - before * axis;
  p.forward = axis;
  p.right = right / (before + t);
  p.down = down / (before + t);
  p.corner = axis - 0.5 * (p.right + p.down);
  const double height =
      glm::dot(surface.geometric, surface.position) + surface.clearance + surface.rise;
  p.beyond = {surface.geometric, height};
  const glm::dvec3 all = p.apex + p.corner + p.right + p.down;
  if (!std::isfinite(all.x + all.y + all.z) || p.right == glm::dvec3(0.0) ||
      p.down == glm::dvec3(0.0))
    return std::nullopt;
  return out;
}

}  // namespace asos
