#include "renderer/gltf/outlines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asos::gltf {

namespace {

// Largest distance of corners from their plane, relative to the extent: the rounding error of
// single precision after a rotation or two, with a margin.
constexpr double planar_tolerance = 1e-3;
// Smallest area, relative to the squared extent.
constexpr double least_area = 1e-9;

using Outline2 = std::vector<glm::dvec2>;

/// Returns twice the enclosed area of `outline`, along its normal (Newell's method), relative to
/// `middle`.
glm::dvec3 twice_area(const std::vector<glm::dvec3>& outline, glm::dvec3 middle) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    sum += glm::cross(outline[i] - middle, outline[(i + 1) % outline.size()] - middle);
  }
  return sum;
}

double side_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
  const glm::dvec2 u = b - a, v = p - a;
  return u.x * v.y - u.y * v.x;
}

/// Returns whether two sides cross in their interiors; sides that only touch do not.
bool cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  return side_of(a, b, c) * side_of(a, b, d) < 0.0 && side_of(c, d, a) * side_of(c, d, b) < 0.0;
}

bool any_crossing(const std::vector<Outline2>& outlines) {
  struct Side {
    glm::dvec2 from, to;
  };
  std::vector<Side> sides;
  for (const Outline2& o : outlines) {
    for (std::size_t i = 0; i < o.size(); ++i) sides.push_back({o[i], o[(i + 1) % o.size()]});
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      if (cross(sides[i].from, sides[i].to, sides[k].from, sides[k].to)) return true;
    }
  }
  return false;
}

bool inside(const Outline2& outline, glm::dvec2 p) {
  bool in = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
      in = !in;
    }
  }
  return in;
}

std::string count_fault(const Outlines& outlines) {
  if (outlines.empty()) return "has no outline";
  std::size_t corners = 0;
  for (const std::vector<glm::dvec3>& outline : outlines) {
    if (outline.size() < 3) return "has an outline of fewer than three corners";
    corners += outline.size();
    for (const glm::dvec3 p : outline) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        return "has a corner that is not finite";
      }
    }
  }
  if (corners <= most_outline_corners) return {};
  return fmt::format("has {} corners; the limit is {}", corners, most_outline_corners);
}

/// Returns the fault of flat outlines that meet or nest wrongly; empty if none.
std::string crossing_fault(const FlatOutlines& flat) {
  const glm::dvec3 n = flat.normal;
  const glm::dvec3 axis = std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(axis, n)), v = glm::cross(n, u);
  std::vector<Outline2> drawn;
  for (const std::vector<glm::dvec3>& outline : flat.outlines) {
    Outline2& o = drawn.emplace_back();
    for (const glm::dvec3 p : outline) {
      o.emplace_back(glm::dot(p - flat.middle, u), glm::dot(p - flat.middle, v));
    }
  }
  if (any_crossing(drawn)) return "has outlines that cross";
  // Since no sides cross, one point of a hole represents all of it. The centre of a side is safer
  // than a corner, which may touch.
  for (std::size_t hole = 1; hole < drawn.size(); ++hole) {
    const glm::dvec2 p = 0.5 * (drawn[hole][0] + drawn[hole][1]);
    if (!inside(drawn[0], p)) return "has a hole outside of its outer outline";
    for (std::size_t other = 1; other < drawn.size(); ++other) {
      if (other != hole && inside(drawn[other], p)) return "has a hole in a hole";
    }
  }
  return {};
}

}  // namespace

Checked<FlatOutlines> flatten_outlines(Outlines outlines) {
  if (std::string why = count_fault(outlines); !why.empty()) return fault(why);
  FlatOutlines flat{std::move(outlines), {}, {}};
  const std::vector<glm::dvec3>& outer = flat.outlines[0];
  for (const glm::dvec3 p : outer) flat.middle += p / static_cast<double>(outer.size());
  double extent = 0.0;
  for (const glm::dvec3 p : outer) extent = std::max(extent, glm::length(p - flat.middle));
  const double least = least_area * extent * extent;
  const glm::dvec3 area = twice_area(outer, flat.middle);
  if (!(glm::length(area) > least) || !std::isfinite(glm::length(area))) {
    return fault("has an outline without area");
  }
  flat.normal = glm::normalize(area);
  for (std::size_t i = 0; i < flat.outlines.size(); ++i) {
    for (glm::dvec3& p : flat.outlines[i]) {
      const double off = glm::dot(p - flat.middle, flat.normal);
      if (std::abs(off) > planar_tolerance * extent) return fault("is not flat");
      p -= off * flat.normal;
    }
    const double along = glm::dot(twice_area(flat.outlines[i], flat.middle), flat.normal);
    if (!(std::abs(along) > least)) return fault("has an outline without area");
    if (i > 0 && along > 0.0) std::reverse(flat.outlines[i].begin(), flat.outlines[i].end());
  }
  if (std::string why = crossing_fault(flat); !why.empty()) return fault(why);
  return flat;
}

}  // namespace asos::gltf
