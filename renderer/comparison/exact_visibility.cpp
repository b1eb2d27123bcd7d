#include "renderer/comparison/exact_visibility.h"

#include "renderer/geometry/finite.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos {
namespace {

// Distance from a line, in sides of the frame's square, below which points count as on the line: a
// hundred times the rounding error of a distance, so that cutting along a shared edge leaves no
// tiny remainders.
constexpr double on_line = 1e-14;

// Relative difference of nearness below which two planes count as equal. Corners are floats, so
// different planes differ by about 1e-8.
constexpr double same_plane = 1e-12;

// The angle between a plane and the line of sight, in radians, below which the plane is edge-on.
constexpr double edge_on = 1e-14;

// Cells with at most this many fragments, or at the deepest level, are resolved pair by pair.
constexpr std::size_t few_fragments = 48;
constexpr int deepest_cell = 8;

HalfPlane scaled(glm::dvec3 line) {
  const double gradient = std::hypot(line.x, line.y);
  const double size = gradient > 0.0 ? gradient : std::abs(line.z);
  return size > 0.0 ? HalfPlane{line.x / size, line.y / size, line.z / size} : HalfPlane{};
}

double depth_on(const HalfPlane& h, glm::dvec2 p) {
  const double d = h.depth(p);
  return std::abs(d) <= on_line ? 0.0 : d;
}

enum class WhichSide { inside, outside, both };

WhichSide side_of(const ConvexPolygon& polygon, const HalfPlane& h) {
  bool in = false;
  bool out = false;
  for (const glm::dvec2& p : polygon) {
    const double d = depth_on(h, p);
    in |= d > 0.0;
    out |= d < 0.0;
  }
  if (in && out) return WhichSide::both;
  return in ? WhichSide::inside : WhichSide::outside;
}

/// The parts of a polygon on either side of a line that crosses it. Both have the same corners on
/// the line, so no area is lost or counted twice.
struct Halves {
  ConvexPolygon inside;
  ConvexPolygon outside;
};
Halves cut(const ConvexPolygon& polygon, const HalfPlane& h) {
  Halves halves;
  halves.inside.reserve(polygon.size() + 2);
  halves.outside.reserve(polygon.size() + 2);
  glm::dvec2 p = polygon.back();
  double dp = depth_on(h, p);
  for (const glm::dvec2& q : polygon) {
    const double dq = depth_on(h, q);
    if ((dp < 0.0 && dq > 0.0) || (dp > 0.0 && dq < 0.0)) {
      const glm::dvec2 on = p + (q - p) * (dp / (dp - dq));
      halves.inside.push_back(on);
      halves.outside.push_back(on);
    }
    if (dq >= 0.0) halves.inside.push_back(q);
    if (dq <= 0.0) halves.outside.push_back(q);
    p = q;
    dp = dq;
  }
  return halves;
}

ConvexPolygon corners_of(const FrameRectangle& r) {
  return {r.lo, {r.hi.x, r.lo.y}, r.hi, {r.lo.x, r.hi.y}};
}

bool keep_inside(ConvexPolygon& polygon, const HalfPlane& h) {
  switch (side_of(polygon, h)) {
    case WhichSide::inside:
      return true;
    case WhichSide::outside:
      return false;
    case WhichSide::both:
      polygon = cut(polygon, h).inside;
      break;
  }
  return polygon.size() >= 3;
}

bool clip_to(ConvexPolygon& polygon, const Facet& facet) {
  return std::all_of(facet.inside.begin(), facet.inside.end(),
                     [&](const HalfPlane& h) { return keep_inside(polygon, h); });
}

/// The region in which `first` lies in front of `second`: everywhere, nowhere, or a half-plane.
/// Swapping the two gives the exact complement.
struct Precedence {
  WhichSide side = WhichSide::both;
  HalfPlane where;
};
Precedence precedence(const Facet& first, const Facet& second) {
  const glm::dvec3 d = first.nearness - second.nearness;
  const auto size = [](glm::dvec3 v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
  if (size(d) <= same_plane * (size(first.nearness) + size(second.nearness)))
    return {first.triangle < second.triangle ? WhichSide::inside : WhichSide::outside, {}};
  return {WhichSide::both, scaled(d)};
}

/// Returns whether a facet lies in front of another in the whole of a polygon.
bool hides(const Facet& nearer, const Facet& farther, const ConvexPolygon& polygon) {
  const Precedence order = precedence(nearer, farther);
  const WhichSide side = order.side == WhichSide::both ? side_of(polygon, order.where) : order.side;
  return side == WhichSide::inside;
}

}  // namespace

double area_of(const ConvexPolygon& polygon) {
  // Relative to the first corner, so that a small polygon far from the origin keeps its precision.
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const glm::dvec2 p = polygon[i] - polygon[0];
    const glm::dvec2 q = polygon[i + 1] - polygon[0];
    twice += p.x * q.y - p.y * q.x;
  }
  return 0.5 * std::abs(twice);
}

// A ray (u, v, 1) hits the triangle h0 h1 h2 in front of the apex if its three volumes with pairs
// of corners have the sign of the corners' own volume: no division, and no special case for corners
// behind the apex (Olano and Greer 1997, "Triangle scan conversion using 2D homogeneous
// coordinates").
std::optional<Facet> make_facet(const Frame& frame, std::uint32_t triangle,
                                const std::array<glm::dvec3, 3>& corners) {
  std::array<glm::dvec3, 3> h;
  for (std::size_t i = 0; i < 3; ++i) h[i] = frame.homogeneous(corners[i]);

  // Reject triangles outside one of the square's sides: most of them.
  const auto weight = [&](glm::dvec3 p) { return frame.parallel() ? 1.0 : p.z; };
  const auto beyond = [&](auto&& margin) {
    return margin(h[0]) < 0 && margin(h[1]) < 0 && margin(h[2]) < 0;
  };
  if (beyond([](glm::dvec3 p) { return p.z; }) || beyond([](glm::dvec3 p) { return p.x; }) ||
      beyond([](glm::dvec3 p) { return p.y; }) ||
      beyond([&](glm::dvec3 p) { return weight(p) - p.x; }) ||
      beyond([&](glm::dvec3 p) { return weight(p) - p.y; })) {
    return std::nullopt;
  }

  // The plane, as dot(normal, h) = distance.
  const glm::dvec3 normal = glm::cross(h[1] - h[0], h[2] - h[0]);
  const double distance = glm::dot(normal, h[0]);
  if (!finite(normal) || !std::isfinite(distance)) return std::nullopt;
  std::array<glm::dvec3, 3> flat = h;
  double volume = distance;
  if (frame.parallel()) {
    for (glm::dvec3& p : flat) p.z = 1.0;
    volume = normal.z;
    if (std::abs(volume) <= edge_on * glm::length(normal)) return std::nullopt;
  } else {
    const double reach = std::max({glm::length(h[0]), glm::length(h[1]), glm::length(h[2])});
    if (std::abs(volume) <= edge_on * glm::length(normal) * reach) return std::nullopt;
  }
  const double sign = volume < 0.0 ? -1.0 : 1.0;

  Facet facet;
  facet.triangle = triangle;
  for (std::size_t i = 0; i < 3; ++i)
    facet.inside[i] = scaled(sign * glm::cross(flat[i], flat[(i + 1) % 3]));
  if (frame.parallel()) {
    facet.nearness = glm::dvec3(normal.x, normal.y, -distance) / normal.z;
    facet.inside[3] = scaled(-facet.nearness);  // not behind the base
  } else {
    facet.nearness = normal / distance;
    facet.inside[3] = {0.0, 0.0, 1.0};
  }
  facet.inside[4] = {0.0, 0.0, 1.0};
  if (!finite(facet.nearness)) return std::nullopt;
  return facet;
}

void cut_facet(Facet& facet, std::optional<double> near, std::optional<double> far) {
  if (near) facet.inside[3] = scaled(glm::dvec3(0, 0, *near) - facet.nearness);
  if (far) facet.inside[4] = scaled(facet.nearness - glm::dvec3(0, 0, *far));
}

std::span<const VisiblePart> ExactVisibility::find(std::span<const Facet> facets,
                                                   const FrameRectangle& rectangle) {
  facets_ = facets;
  parts_.clear();
  std::vector<std::uint32_t> all(facets.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  divide(all, rectangle, 0);
  return parts_;
}

// Quarters the cell until each part has few facets (Warnock 1969), which bounds the number of
// pairs.
void ExactVisibility::divide(const std::vector<std::uint32_t>& candidates,
                             const FrameRectangle& cell, int depth) {
  gather(candidates, cell);
  drop_hidden(cell);
  if (fragments_.size() <= few_fragments || depth == deepest_cell) {
    resolve(cell, std::exchange(fragments_, {}));
    return;
  }
  std::vector<std::uint32_t> left;
  left.reserve(fragments_.size());
  for (const Fragment& f : fragments_) left.push_back(f.facet);
  const glm::dvec2 middle = 0.5 * (cell.lo + cell.hi);
  divide(left, {cell.lo, middle}, depth + 1);
  divide(left, {{middle.x, cell.lo.y}, {cell.hi.x, middle.y}}, depth + 1);
  divide(left, {{cell.lo.x, middle.y}, {middle.x, cell.hi.y}}, depth + 1);
  divide(left, {middle, cell.hi}, depth + 1);
}

// Collects the parts of the candidates that lie in the cell.
void ExactVisibility::gather(const std::vector<std::uint32_t>& candidates,
                             const FrameRectangle& cell) {
  fragments_.clear();
  for (const std::uint32_t i : candidates) {
    ConvexPolygon polygon = corners_of(cell);
    if (clip_to(polygon, facets_[i])) fragments_.push_back({i, std::move(polygon)});
  }
}

// Drops the fragments behind the nearest facet, at the cell's centre, that covers the whole cell.
void ExactVisibility::drop_hidden(const FrameRectangle& cell) {
  const ConvexPolygon corners = corners_of(cell);
  const glm::dvec2 middle = 0.5 * (cell.lo + cell.hi);
  const Facet* cover = nullptr;
  for (const Fragment& f : fragments_) {
    const Facet& facet = facets_[f.facet];
    const bool covers =
        std::all_of(facet.inside.begin(), facet.inside.end(),
                    [&](const HalfPlane& h) { return side_of(corners, h) == WhichSide::inside; });
    if (covers && (!cover || facet.q(middle) > cover->q(middle))) cover = &facet;
  }
  if (!cover) return;
  std::erase_if(fragments_, [&](const Fragment& f) {
    return &facets_[f.facet] != cover && hides(*cover, facets_[f.facet], f.polygon);
  });
}

// Subtracts from each fragment all others where they are nearer, and from the cell all fragments.
// The rest are the visible parts.
void ExactVisibility::resolve(const FrameRectangle& cell, const std::vector<Fragment>& fragments) {
  for (const Fragment& f : fragments) {
    pieces_.assign(1, f.polygon);
    for (const Fragment& other : fragments) {
      if (&other == &f || pieces_.empty()) continue;
      const Precedence order = precedence(facets_[other.facet], facets_[f.facet]);
      if (order.side == WhichSide::outside) continue;
      subtract(facets_[other.facet], order.side == WhichSide::both ? &order.where : nullptr);
    }
    emit(f.facet);
  }
  pieces_.assign(1, corners_of(cell));
  for (const Fragment& f : fragments) subtract(facets_[f.facet], nullptr);
  emit(VisiblePart::background);
}

// Subtracts the part of a facet within the half-plane `where` (null: all of it) from the pieces.
void ExactVisibility::subtract(const Facet& nearer, const HalfPlane* where) {
  std::array<HalfPlane, 6> lines;
  std::copy(nearer.inside.begin(), nearer.inside.end(), lines.begin());
  lines.back() = where ? *where : HalfPlane{0.0, 0.0, 1.0};
  rest_.clear();
  for (ConvexPolygon& piece : pieces_) {
    const bool apart = std::any_of(lines.begin(), lines.end(), [&](const HalfPlane& h) {
      return side_of(piece, h) == WhichSide::outside;
    });
    if (apart || !cut_away(piece, lines)) rest_.push_back(std::move(piece));
  }
  std::swap(pieces_, rest_);
}

// Adds the part outside any of the lines to the rest. Returns false if that is the whole piece,
// which then stays uncut.
bool ExactVisibility::cut_away(const ConvexPolygon& piece, std::span<const HalfPlane> lines) {
  const std::size_t before = rest_.size();
  ConvexPolygon inner = piece;
  for (const HalfPlane& h : lines) {
    const WhichSide side = side_of(inner, h);
    if (side == WhichSide::inside) continue;
    if (side == WhichSide::outside) {
      rest_.resize(before);
      return false;
    }
    Halves halves = cut(inner, h);
    rest_.push_back(std::move(halves.outside));
    inner = std::move(halves.inside);
  }
  return true;
}

void ExactVisibility::emit(std::uint32_t facet) {
  for (ConvexPolygon& piece : pieces_) {
    VisiblePart part;
    part.facet = facet;
    part.area = area_of(piece);
    if (!(part.area > 0.0)) continue;
    // Weight the triangles of the fan from the first corner by area; all have the same orientation.
    for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
      const glm::dvec2 p = piece[i] - piece[0];
      const glm::dvec2 q = piece[i + 1] - piece[0];
      part.centroid += std::abs(p.x * q.y - p.y * q.x) / (6.0 * part.area) * (p + q);
    }
    part.centroid += piece[0];
    part.polygon = std::move(piece);
    parts_.push_back(std::move(part));
  }
}

}  // namespace asos
