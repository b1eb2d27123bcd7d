#include "renderer/reflections/ray_bundle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace asos {
namespace {

// Limits of a pyramid's size at the surface, relative to its size at `t`. Near 0 the apex would lie
// on the surface, and near 1 it would exceed the range of doubles.
constexpr double least_share = 1.0 / 64.0;
constexpr double most_share = 63.0 / 64.0;

// Smallest width of a section, relative to its width without a focus.
constexpr double least_width = 1e-3;

// Returns an edge of the section at `t`. It keeps some length where the rays meet.
glm::dvec3 edge_at(glm::dvec3 at, glm::dvec3 turn, double t, glm::dvec3 axis) {
  const glm::dvec3 start = across(at, axis), moved = t * across(turn, axis);
  const glm::dvec3 edge = start + moved;
  const double least = least_width * (glm::length(start) + glm::length(moved));
  return glm::length(edge) < least ? edge + least * glm::normalize(moved) : edge;
}

// One axis of a section across a blurred bundle. The sign of the blur's edge does not matter.
struct BlurredAxis {
  glm::dvec3 unit;   // along the section
  double own = 0.0;  // width of the section, and the width that blur adds to it
  double blur = 0.0;
  glm::dvec3 turn;  // change of direction over each of these widths
  glm::dvec3 lobe;

  BlurredAxis(glm::dvec3 section, glm::dvec3 blurred, glm::dvec3 turn_, glm::dvec3 lobe_)
      : unit(glm::normalize(glm::length(section) > glm::length(blurred) ? section : blurred)),
        turn(turn_),
        lobe(lobe_) {
    if (glm::dot(section, unit) < 0.0) unit = -unit;
    own = glm::dot(section, unit);
    blur = glm::dot(blurred, unit);
    if (blur < 0.0) blur = -blur, lobe = -lobe;
  }
  [[nodiscard]] double variance() const { return own * own + blur * blur; }
  [[nodiscard]] double width() const { return own + blur; }
  // Returns the change of the mean direction along the section.
  [[nodiscard]] glm::dvec3 slope() const { return (own * turn + blur * lobe) / variance(); }
  // Returns the remaining variation of directions at one place, as an edge.
  [[nodiscard]] glm::dvec3 rest() const {
    return (blur * turn - own * lobe) / std::sqrt(variance());
  }
};

// Independent boxes along one axis: each one's change of place and of direction.
struct Boxes {
  std::array<glm::dvec3, 3> at{};
  std::array<glm::dvec3, 3> turn{};
};

// Returns the squared widths of two boxes that replace three, the larger first. They have the same
// sum of squares and, if possible, the same sum of fourth powers.
std::pair<double, double> two_for_three(const glm::dvec3& widths) {
  const glm::dvec3 squares = widths * widths;
  const double sum = squares.x + squares.y + squares.z, fourth = glm::dot(squares, squares);
  const double half = 0.5 * std::sqrt(std::max(0.0, 2.0 * fourth - sum * sum));
  return {0.5 * sum + half, std::max(0.0, 0.5 * sum - half)};
}

// Replaces three boxes by two, for a distance `t`. The second is the blur; it is the one with the
// smaller extent at the origin.
void merge(const Boxes& boxes, double t, glm::dvec3& at, glm::dvec3& turn, glm::dvec3& lobe_at,
           glm::dvec3& lobe) {
  glm::dvec3 unit(0.0), places, turns;
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 there = boxes.at[i] + t * boxes.turn[i];
    if (const double length = glm::length(there); length > longest)
      longest = length, unit = there / length;
  }
  if (!(longest > 0.0)) return;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    places[i] = glm::dot(boxes.at[k] + t * boxes.turn[k], unit);
    turns[i] = glm::dot(boxes.turn[k], unit);
  }
  // Rotate the three boxes into two that span the same space, with these widths at `t`.
  const glm::dvec3 first = glm::normalize(places);
  glm::dvec3 second = turns - glm::dot(turns, first) * first;
  const double left = glm::length(second);
  second = left > 1e-12 * glm::length(turns) ? second / left : glm::dvec3(0.0);
  const auto [larger, smaller] = two_for_three(places);
  const double all = larger + smaller;
  double least = std::numeric_limits<double>::infinity();
  for (const double blurring : {larger, smaller}) {
    for (const double sign : {-1.0, 1.0}) {
      const double c = std::sqrt((all - blurring) / all), s = std::sqrt(blurring / all);
      const glm::dvec3 own = c * first - sign * s * second, blur = s * first + sign * c * second;
      const auto combined = [](const glm::dvec3& by, const std::array<glm::dvec3, 3>& edges) {
        return by.x * edges[0] + by.y * edges[1] + by.z * edges[2];
      };
      const glm::dvec3 blur_at = combined(blur, boxes.at);
      if (!(glm::length(blur_at) < least)) continue;
      least = glm::length(blur_at);
      at = combined(own, boxes.at), turn = combined(own, boxes.turn);
      lobe_at = blur_at, lobe = combined(blur, boxes.turn);
    }
  }
}

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

MirrorPatch RayBundle::whole_section(double t) const {
  MirrorPatch whole = section(t);
  if (!blurred()) return whole;
  const MirrorPatch blur = blur_of_section(t);
  const BlurredAxis u(whole.right, blur.right, right, lobe_right);
  const BlurredAxis v(whole.down, blur.down, down, lobe_down);
  return {std::sqrt(u.variance()) * u.unit, std::sqrt(v.variance()) * v.unit};
}

void RayBundle::add_lobe(const MirrorLobe& lobe, double t) {
  if (!(lobe.width > 0.0)) return;
  const glm::dvec3 none(0.0);
  const Boxes along_right{{right_at, lobe_right_at, none},
                          {right, lobe_right, lobe.width * lobe.right}};
  const Boxes along_down{{down_at, lobe_down_at, none}, {down, lobe_down, lobe.width * lobe.down}};
  merge(along_right, t, right_at, right, lobe_right_at, lobe_right);
  merge(along_down, t, down_at, down, lobe_down_at, lobe_down);
}

RayBundle RayBundle::blurred_part(const Bounds2& part, double t) const {
  const MirrorPatch there = section(t), blur = blur_of_section(t);
  const BlurredAxis u(there.right, blur.right, right, lobe_right);
  const BlurredAxis v(there.down, blur.down, down, lobe_down);
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
  bundle.lobe_right_at = -way * bundle.lobe_right;
  bundle.lobe_down_at = -way * bundle.lobe_down;
  return bundle;
}

RayBundle mirrored(const RayBundle& bundle, const MirrorSurface& surface) {
  const double t = glm::dot(surface.position - bundle.origin, bundle.direction);
  IncidentPyray beam;
  beam.perspective = false;
  beam.axis = bundle.direction;
  const auto patch_of_section = [&](const MirrorPatch& section) {
    beam.right = section.right;
    beam.down = section.down;
    return patch_of(beam, surface.geometric);
  };
  const MirrorPatch section = bundle.section(t), patch = patch_of_section(section);
  RayBundle out;
  out.origin = surface.position;
  out.direction = mirrored_direction(surface, bundle.direction);
  out.right_at = patch.right;
  out.down_at = patch.down;
  const auto turned = [&](glm::dvec3 edge, glm::dvec3 turn) {
    return across(mirrored_edge(surface, bundle.direction, edge, turn), out.direction);
  };
  if (!bundle.blurred()) {
    out.right = turned(bundle.right, surface.turn_right);
    out.down = turned(bundle.down, surface.turn_down);
    return out;
  }
  // Divide the normal's turn over the whole section between the section and its blur.
  const MirrorPatch whole = bundle.whole_section(t), blur = bundle.blur_of_section(t);
  const auto share = [](glm::dvec3 edge, glm::dvec3 all) {
    return glm::dot(edge, all) / glm::dot(all, all);
  };
  out.right = turned(bundle.right, share(section.right, whole.right) * surface.turn_right);
  out.down = turned(bundle.down, share(section.down, whole.down) * surface.turn_down);
  out.lobe_right = turned(bundle.lobe_right, share(blur.right, whole.right) * surface.turn_right);
  out.lobe_down = turned(bundle.lobe_down, share(blur.down, whole.down) * surface.turn_down);
  const MirrorPatch blurred = patch_of_section(blur);
  out.lobe_right_at = blurred.right;
  out.lobe_down_at = blurred.down;
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
    const MirrorPatch blur = bundle.blur_of_section(t);
    const auto widen = [](glm::dvec3& edge, glm::dvec3 by) {
      const double own = glm::length(edge), wide = own + glm::length(by);
      edge *= wide / own;
      return own / wide;
    };
    out.sharp_share = {widen(right, blur.right), widen(down, blur.down)};
  }
  // In a focal line the edges coincide.
  const glm::dvec3 beside = glm::cross(axis, right);
  const double area = glm::dot(beside, down);
  const double least = least_width * glm::length(right) * glm::length(down);
  if (std::abs(area) < least) down += std::copysign(least, area) / glm::dot(right, right) * beside;

  const MirrorPatch start = bundle.whole_section(0.0);
  const glm::dvec3 patch_right = across(start.right, axis);
  const glm::dvec3 patch_down = across(start.down, axis);
  const double of_right = glm::dot(patch_right, right), of_down = glm::dot(patch_down, down);
  const double right2 = glm::dot(right, right), down2 = glm::dot(down, down);
  const double fitting = blurred ? std::min(of_right / right2, of_down / down2)
                                 : (of_right + of_down) / (right2 + down2);
  const double share = std::clamp(fitting, least_share, most_share);
  const double before = t * share / (1.0 - share);
  // The pyramid is completely sharp at the surface. Choose its sharpness far away so that it is
  // right at `t`.
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
