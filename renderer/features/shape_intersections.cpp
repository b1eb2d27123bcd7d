#include "renderer/features/shape_intersections.h"

#include "renderer/features/face_contours.h"
#include "renderer/geometry/clip_segment.h"
#include "renderer/geometry/half_space.h"
#include "renderer/world/hit_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace asos {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr std::uint64_t most_pairs = 200'000'000;
constexpr std::size_t most_face_pairs = 256;
// Distance, in the space of the unit surface, within which a plane only touches the surface or
// meets it in a rim.
constexpr double touch = 1e-6;
constexpr double parallel = 1e-9;
// Number of straight pieces around a cone.
constexpr int pieces = 720;

bool overlap(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.lo, b.hi)) && glm::all(glm::lessThanEqual(b.lo, a.hi));
}

/// A plane n . p = k in the space of a unit surface.
struct UnitPlane {
  glm::dvec3 n;
  double k;
};

class FaceCutter {
 public:
  FaceCutter(const World& world, std::uint32_t surface, ShapeIntersections& found)
      : world_(world), surface_(surface), face_(world.face(surface)), found_(found) {
    const FaceBounds bounds = bounds_of(face_);
    box_.grow(glm::vec3(bounds.lo));
    box_.grow(glm::vec3(bounds.hi));
  }

  void cut(std::uint32_t triangle) {
    Box box;
    for (int k = 0; k < 3; ++k) box.grow(world_.positions[world_.triangles[triangle][k]]);
    if (!overlap(box, box_)) return;
    const HitPlane plane = plane_of_triangle(world_, triangle);
    const glm::dvec3 n = plane.normal();
    if (!(glm::dot(n, n) > 0.0)) return;
    triangle_ = triangle;
    set_bounds(plane, n);
    UnitPlane unit{glm::transpose(face_.world_from_unit) * n,
                   glm::dot(n, plane.corner - face_.origin)};
    const double length = glm::length(unit.n);
    unit.n /= length;
    unit.k /= length;
    switch (face_.kind) {
      case ShapeFace::Kind::sphere:
        return cut_sphere(unit);
      case ShapeFace::Kind::disk:
        return cut_disk(unit);
      case ShapeFace::Kind::side:
        return cut_side(unit);
    }
  }

 private:
  /// Sets the bounds: the triangle's three sides, and the two ends of a side.
  void set_bounds(const HitPlane& plane, glm::dvec3 n) {
    const glm::dvec3 corner[3] = {plane.corner, plane.corner + plane.edge1,
                                  plane.corner + plane.edge2};
    bounds_.clear();
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 inwards = glm::cross(n, corner[(i + 1) % 3] - corner[i]);
      bounds_.push_back({inwards, glm::dot(inwards, corner[i])});
    }
    if (face_.kind != ShapeFace::Kind::side) return;
    const glm::dvec3 up = face_.world_normal({0, 1, 0});
    const double base = glm::dot(up, face_.origin);
    bounds_.push_back({up, base});
    bounds_.push_back({-up, -base - 1.0});
  }

  void cut_sphere(const UnitPlane& plane) {
    if (!(std::abs(plane.k) < 1.0 - touch)) return;
    const double radius = std::sqrt((1.0 - plane.k) * (1.0 + plane.k));
    const glm::dvec3 other = std::abs(plane.n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(plane.n, other));
    add_arc(plane.k * plane.n, radius * x, radius * glm::cross(plane.n, x));
  }

  void cut_disk(const UnitPlane& plane) {
    const glm::dvec2 n(plane.n.x, plane.n.z);
    const double size = glm::length(n);
    if (size < touch || !(std::abs(plane.k) < size * (1.0 - touch))) return;
    const glm::dvec2 middle = plane.k / (size * size) * n;
    const double half = std::sqrt(std::max(0.0, 1.0 - glm::dot(middle, middle)));
    const glm::dvec2 along = half / size * glm::dvec2(-n.y, n.x);
    const glm::dvec2 a = middle - along, b = middle + along;
    add_line({a.x, 0, a.y}, {b.x, 0, b.y});
  }

  void cut_side(const UnitPlane& plane) {
    const double across = std::hypot(plane.n.x, plane.n.z);
    if (across < touch) {  // level: a ring
      const double y = plane.k / plane.n.y;
      if (y < touch || y > 1.0 - touch) return;
      const double r = face_.radius_at(y);
      return add_arc({0, y, 0}, {r, 0, 0}, {0, 0, r});
    }
    if (face_.bottom != face_.top) return cut_cone(plane);
    if (std::abs(plane.n.y) > parallel) {
      const glm::dvec3 slope = -plane.n / plane.n.y;
      return add_arc({0, plane.k / plane.n.y, 0}, {1, slope.x, 0}, {0, slope.z, 1});
    }
    if (!(std::abs(plane.k) < across * (1.0 - touch))) return;
    const double middle = std::atan2(plane.n.z, plane.n.x), half = std::acos(plane.k / across);
    for (const double t : {middle - half, middle + half})
      add_line({std::cos(t), 0, std::sin(t)}, {std::cos(t), 1, std::sin(t)});
  }

  // The line at each angle of a cone's side meets the plane once, or nowhere.
  void cut_cone(const UnitPlane& plane) {
    const auto at = [&](int i) -> std::optional<glm::dvec3> {
      const double t = two_pi * i / pieces, c = std::cos(t), s = std::sin(t);
      const double g = plane.n.x * c + plane.n.z * s;
      const double y = (plane.k - face_.bottom * g) / (plane.n.y + (face_.top - face_.bottom) * g);
      // Continue slightly beyond the ends, where the lines are cut off.
      if (!(y > -1.0 && y < 2.0) || face_.radius_at(y) < 0.0) return std::nullopt;
      const double r = face_.radius_at(y);
      return glm::dvec3(r * c, y, r * s);
    };
    std::optional<glm::dvec3> last = at(0);
    for (int i = 1; i <= pieces; ++i) {
      const std::optional<glm::dvec3> next = at(i);
      if (last && next) add_line(*last, *next);
      last = next;
    }
  }

  // Adds the parts of an arc of unit space inside the bounds.
  void add_arc(glm::dvec3 centre, glm::dvec3 cosine, glm::dvec3 sine) {
    EllipseArc arc{face_.world(centre), face_.world_from_unit * cosine,
                   face_.world_from_unit * sine};
    std::vector<double> angles;
    for (const HalfSpace& half : bounds_)
      add_crossings(half.height(arc.centre), glm::dot(half.normal, arc.cosine),
                    glm::dot(half.normal, arc.sine), angles);
    const auto inside = [&](double angle) {
      const glm::dvec3 p = arc.at(angle);
      return std::all_of(bounds_.begin(), bounds_.end(),
                         [&](const HalfSpace& half) { return half.height(p) >= 0.0; });
    };
    if (angles.empty()) {
      if (inside(0.0)) found_.arcs.push_back({arc, triangle_, surface_});
      return;
    }
    for (double& angle : angles) angle -= two_pi * std::floor((angle - angles[0]) / two_pi);
    angles.push_back(angles[0] + two_pi);
    std::sort(angles.begin(), angles.end());
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
      if (!(angles[i] < angles[i + 1]) || !inside(0.5 * (angles[i] + angles[i + 1]))) continue;
      arc.from = angles[i];
      arc.to = angles[i + 1];
      found_.arcs.push_back({arc, triangle_, surface_});
    }
  }

  void add_line(glm::dvec3 unit_a, glm::dvec3 unit_b) {
    const glm::dvec3 a = face_.world(unit_a), b = face_.world(unit_b);
    EdgeRange range;
    for (const HalfSpace& half : bounds_) range.keep(half.height(a), half.height(b));
    if (!(range.t0 < range.t1)) return;
    const glm::vec3 p(a + range.t0 * (b - a)), q(a + range.t1 * (b - a));
    if (p != q) found_.lines.push_back({p, q, triangle_, surface_});
  }

  const World& world_;
  std::uint32_t surface_;
  const ShapeFace& face_;
  ShapeIntersections& found_;
  Box box_;
  std::uint32_t triangle_ = 0;
  std::vector<HalfSpace> bounds_;
};

// Adds the intersections of the faces of different shapes whose boxes overlap.
void cross_faces(const World& world, ShapeIntersections& found) {
  const auto triangles = static_cast<std::uint32_t>(world.triangles.size());
  std::vector<Box> boxes;
  for (const ShapeFace& face : world.faces) {
    const FaceBounds bounds = bounds_of(face);
    boxes.emplace_back();
    boxes.back().grow(glm::vec3(bounds.lo));
    boxes.back().grow(glm::vec3(bounds.hi));
  }
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < world.faces.size(); ++i) {
    for (std::uint32_t k = i + 1; k < world.faces.size(); ++k) {
      const ShapeFace &a = world.faces[i], &b = world.faces[k];
      const bool flat_a = a.kind == ShapeFace::Kind::disk;
      if (a.part == b.part || (flat_a && b.kind == ShapeFace::Kind::disk) ||
          !overlap(boxes[i], boxes[k]))
        continue;
      if (++pairs > most_face_pairs) {
        found.complete = false;
        return;
      }
      for (const FaceCrossing& piece : face_contours(flat_a ? b : a, flat_a ? a : b))
        found.lines.push_back({piece.a, piece.b, triangles + i, triangles + k});
    }
  }
}

}  // namespace

ShapeIntersections find_shape_intersections(const World& world) {
  ShapeIntersections found;
  const auto triangles = static_cast<std::uint32_t>(world.solid_triangles());
  const auto first_face = static_cast<std::uint32_t>(world.triangles.size());
  if (world.faces.size() * std::uint64_t{triangles} > most_pairs) {
    found.complete = false;
    return found;
  }
  for (std::uint32_t f = 0; f < world.faces.size(); ++f) {
    FaceCutter cutter(world, first_face + f, found);
    for (std::uint32_t t = 0; t < triangles; ++t) cutter.cut(t);
  }
  cross_faces(world, found);
  return found;
}

}  // namespace asos
