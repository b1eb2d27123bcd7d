#include "renderer/features/feature_curve.h"

#include "renderer/features/feature_edge.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Returns the ellipse along which lines from outside touch the unit sphere.
FaceOutline sphere_outline(const ShapeFace& face, const Frame& frame) {
  FaceOutline outline;
  glm::dvec3 axis(0.0);
  double height = 0.0, radius = 1.0;
  if (frame.parallel()) {
    axis = glm::normalize(face.unit_from_world * frame.direction());
  } else {
    // The polar of the apex a is the plane a . x = 1.
    const glm::dvec3 a = face.unit(frame.apex());
    const double distance = glm::length(a);
    if (!(distance > 1.0)) return outline;
    axis = a / distance;
    height = 1.0 / distance;
    radius = std::sqrt((1.0 - height) * (1.0 + height));
  }
  const glm::dvec3 other = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(axis, other));
  outline.has_arc = true;
  outline.arc = {face.world(height * axis), radius * (face.world_from_unit * x),
                 radius * (face.world_from_unit * glm::cross(axis, x))};
  return outline;
}

// The normal (cos t, -widens, sin t) of the line at the angle t is perpendicular to the direction
// to the apex. Hence distance * cos(t - middle) = radius, where the radius is that of the side, or
// of its continuation, at the apex's height.
FaceOutline side_outline(const ShapeFace& face, const Frame& frame) {
  FaceOutline outline;
  glm::dvec3 a;
  double radius;
  if (frame.parallel()) {
    a = face.unit_from_world * frame.direction();
    radius = (face.top - face.bottom) * a.y;
  } else {
    a = face.unit(frame.apex());
    radius = face.radius_at(a.y);
  }
  const double distance = std::hypot(a.x, a.z);
  if (!(distance > std::abs(radius))) return outline;
  const double middle = std::atan2(a.z, a.x);
  const double half = std::acos(radius / distance);
  outline.line_count = 2;
  outline.angle[0] = middle - half;
  outline.angle[1] = middle + half;
  return outline;
}

Box box_around(const EllipseArc& arc) {
  const glm::dvec3 reach = ellipse_reach(arc.cosine, arc.sine);
  Box box;
  box.grow(glm::vec3(arc.centre - reach));
  box.grow(glm::vec3(arc.centre + reach));
  return box;
}

Box box_around(const ShapeFace& face) {
  const FaceBounds bounds = bounds_of(face);
  Box box;
  box.grow(glm::vec3(bounds.lo));
  box.grow(glm::vec3(bounds.hi));
  return box;
}

class ShapeFeatureFinder {
 public:
  explicit ShapeFeatureFinder(const World& world) : world_(world) {}

  ShapeFeatures run() {
    for (std::uint32_t f = 0; f < world_.faces.size(); ++f) add(f);
    return std::move(found_);
  }

 private:
  void add(std::uint32_t f) {
    const ShapeFace& face = world_.faces[f];
    if (face.kind == ShapeFace::Kind::disk) {
      // A cap has the same rim as the side before it.
      const bool cap = f > 0 && world_.faces[f - 1].part == face.part;
      if (!cap)
        add_rim(FeatureKind::open, ring(face, 0.0), FeatureCurve::none, f, FeatureEdge::none);
      return;
    }
    FeatureCurve outline;
    outline.outline = true;
    outline.face = f;
    outline.box = box_around(face);
    add_edge(FeatureKind::silhouette, outline, f, f);
    if (face.kind != ShapeFace::Kind::side) return;
    std::uint32_t cap = f + 1;
    if (face.bottom > 0.0) add_rim(FeatureKind::crease, ring(face, 0.0), f, f, cap++);
    if (face.top > 0.0) add_rim(FeatureKind::crease, ring(face, 1.0), f, f, cap);
  }

  void add_rim(FeatureKind kind, const EllipseArc& arc, std::uint32_t side, std::uint32_t left,
               std::uint32_t right) {
    FeatureCurve rim = FeatureCurve::of(arc);
    rim.face = side;
    add_edge(kind, rim, left, right);
  }

  void add_edge(FeatureKind kind, const FeatureCurve& curve, std::uint32_t left,
                std::uint32_t right) {
    const auto smooth_surface = [&](std::uint32_t face) {
      return face == FeatureEdge::none ? face
                                       : face + static_cast<std::uint32_t>(world_.triangles.size());
    };
    FeatureEdge edge;
    edge.left_surface = smooth_surface(left);
    edge.right_surface = smooth_surface(right);
    edge.kind = kind;
    edge.set_curve(static_cast<std::uint32_t>(found_.curves.size()));
    found_.curves.push_back(curve);
    found_.edges.push_back(edge);
  }

  const World& world_;
  ShapeFeatures found_;
};

// Returns an upper bound on the growth of a unit vector; without `all_rows`, row 1 is left out.
double largest_growth(const glm::dmat3& m, bool all_rows) {
  double square = 0.0;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r)
      if (all_rows || r != 1) square += m[c][r] * m[c][r];
  }
  return std::sqrt(square);
}

}  // namespace

FeatureCurve FeatureCurve::of(const EllipseArc& arc) {
  FeatureCurve curve;
  curve.arc = arc;
  curve.box = box_around(arc);
  return curve;
}

FaceOutline face_outline(const ShapeFace& face, const Frame& frame) {
  switch (face.kind) {
    case ShapeFace::Kind::sphere:
      return sphere_outline(face, frame);
    case ShapeFace::Kind::side:
      return side_outline(face, frame);
    case ShapeFace::Kind::disk:
      break;
  }
  return {};
}

ShapeFeatures shape_features(const World& world) {
  return ShapeFeatureFinder(world).run();
}

// In unit space, a chord of length c deviates from a sphere's plane by c^2 / 2, and from a cone's
// by that over its radius there. Heights above the plane shrink by the length of the normal's
// image.
double face_deviation(const ShapeFace& face, glm::dvec3 position, double reach) {
  if (face.kind == ShapeFace::Kind::disk) return 0.0;
  const glm::dvec3 p = face.unit(position);
  const bool sphere = face.kind == ShapeFace::Kind::sphere;
  const double around = std::hypot(p.x, p.z);
  const glm::dvec3 n = sphere ? p
                       : around > 0.0
                           ? glm::dvec3(p.x / around, face.bottom - face.top, p.z / around)
                           : glm::dvec3(1, 0, 0);
  const double radius = sphere ? 1.0 : around;
  const double chord = reach * largest_growth(face.unit_from_world, sphere);
  const double deviation = 0.5 * chord * chord / (radius * glm::length(face.world_normal(n)));
  return deviation < face.size ? deviation : face.size;
}

double face_stretch(const ShapeFace& face) {
  if (face.kind == ShapeFace::Kind::disk) return 0.0;
  const glm::dmat3& m = face.world_from_unit;
  const bool sphere = face.kind == ShapeFace::Kind::sphere;
  double least = glm::length(m[0]), most = least;
  for (int c = 1; c < 3; ++c) {
    if (!sphere && c == 1) continue;
    least = std::min(least, glm::length(m[c]));
    most = std::max(most, glm::length(m[c]));
  }
  // A cone is wider farther along its lines.
  const bool cone = !sphere && face.bottom != face.top;
  return (cone ? 2.0 : 1.0) * most / least;
}

}  // namespace asos
