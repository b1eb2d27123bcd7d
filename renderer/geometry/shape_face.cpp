#include "renderer/geometry/shape_face.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
// At a pole or an apex, a step around has length 0; this fraction of one gives its direction.
constexpr double least_ring = 1e-7;

/// The point around +Y at a coordinate u, and its derivatives.
struct Around {
  double x, z;    // on the unit circle
  double xu, zu;  // derivatives by u

  explicit Around(double u)
      : x(-std::cos(two_pi * u)), z(std::sin(two_pi * u)), xu(two_pi * z), zu(-two_pi * x) {}
};

/// Returns the point of the unit surface at (u, v), its derivatives and normal.
FacePoint unit_point(const ShapeFace& face, double u, double v) {
  FacePoint p;
  switch (face.kind) {
    case ShapeFace::Kind::disk:
      p.position = {2.0 * u - 1.0, 0.0, 2.0 * v - 1.0};
      p.along_u = {2, 0, 0};
      p.along_v = {0, 0, 2};
      p.normal = {0, 1, 0};
      break;
    case ShapeFace::Kind::sphere: {
      const Around at(u);
      const double s = std::sin(std::numbers::pi * v), c = std::cos(std::numbers::pi * v);
      const double ring = std::max(s, least_ring);
      p.position = {s * at.x, c, s * at.z};
      p.along_u = {ring * at.xu, 0.0, ring * at.zu};
      p.along_v = std::numbers::pi * glm::dvec3(c * at.x, -s, c * at.z);
      p.normal = p.position;
      p.normal_u = p.along_u;
      p.normal_v = p.along_v;
      break;
    }
    case ShapeFace::Kind::side: {
      const Around at(u);
      const double widens = face.top - face.bottom;
      const double r = face.radius_at(1.0 - v);
      const double ring = std::max(r, least_ring);
      p.position = {r * at.x, 1.0 - v, r * at.z};
      p.along_u = {ring * at.xu, 0.0, ring * at.zu};
      p.along_v = {-widens * at.x, -1.0, -widens * at.z};
      p.normal = {at.x, -widens, at.z};
      p.normal_u = {at.xu, 0.0, at.zu};
      break;
    }
  }
  return p;
}

double turns(double x, double z) {
  const double u = std::atan2(z, -x) / two_pi;
  return u < 0.0 ? u + 1.0 : u;
}

/// The map from a unit surface to the shape's own space.
struct UnitFace {
  ShapeFace::Kind kind;
  double bottom, top;
  glm::dmat3 stretch;
  glm::dvec3 origin;
};

void add_cylinder(const Shape& shape, std::vector<UnitFace>& faces) {
  const double h = shape.height, b = shape.radius_bottom, t = shape.radius_top;
  const double r = std::max(b, t);
  const auto scaled = [](double x, double y, double z) {
    return glm::dmat3(x, 0, 0, 0, y, 0, 0, 0, z);
  };
  faces.push_back({ShapeFace::Kind::side, b / r, t / r, scaled(r, h, r), {0, -0.5 * h, 0}});
  // The bottom's +Y points down: half a turn around x.
  if (b > 0.0) faces.push_back({ShapeFace::Kind::disk, 1, 1, scaled(b, -b, -b), {0, -0.5 * h, 0}});
  if (t > 0.0) faces.push_back({ShapeFace::Kind::disk, 1, 1, scaled(t, t, t), {0, 0.5 * h, 0}});
}

std::vector<UnitFace> unit_faces(const Shape& shape) {
  std::vector<UnitFace> faces;
  const glm::dmat3 ball(shape.radius);
  switch (shape.type) {
    case Shape::Type::sphere:
      faces.push_back({ShapeFace::Kind::sphere, 1, 1, ball, {}});
      break;
    case Shape::Type::disk:
      faces.push_back({ShapeFace::Kind::disk, 1, 1, ball, {}});
      break;
    case Shape::Type::cylinder:
      add_cylinder(shape, faces);
      break;
    case Shape::Type::box:
      break;
  }
  return faces;
}

/// Computes the inverse with columns scaled to length 1, so that neither tiny nor huge shapes
/// overflow. Returns false if there is none.
bool invert(const glm::dmat3& m, glm::dmat3& inverse) {
  constexpr double least_volume = 1e-12;
  glm::dmat3 unit(0.0);
  double length[3];
  for (int c = 0; c < 3; ++c) {
    length[c] = glm::length(m[c]);
    if (!(length[c] > 0.0) || !std::isfinite(length[c])) return false;
    unit[c] = m[c] / length[c];
  }
  if (!(std::abs(glm::determinant(unit)) > least_volume)) return false;
  inverse = glm::inverse(unit);
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) inverse[c][r] /= length[r];
  }
  return true;
}

}  // namespace

FacePoint face_point(const ShapeFace& face, double u, double v) {
  FacePoint p = unit_point(face, u, v);
  p.position = face.world(p.position);
  p.along_u = face.world_from_unit * p.along_u;
  p.along_v = face.world_from_unit * p.along_v;
  const glm::dvec3 n = face.world_normal(p.normal);
  const double per_length = 1.0 / glm::length(n);
  p.normal = per_length * n;
  p.normal_u = per_length * face.world_normal(p.normal_u);
  p.normal_v = per_length * face.world_normal(p.normal_v);
  return p;
}

glm::dvec2 face_coordinates(const ShapeFace& face, glm::dvec3 p) {
  switch (face.kind) {
    case ShapeFace::Kind::disk:
      return {0.5 * (p.x + 1.0), 0.5 * (p.z + 1.0)};
    case ShapeFace::Kind::sphere:
      return {turns(p.x, p.z), std::atan2(std::hypot(p.x, p.z), p.y) / std::numbers::pi};
    case ShapeFace::Kind::side:
      break;
  }
  return {turns(p.x, p.z), 1.0 - p.y};
}

std::vector<ShapeFace> place_shape(const Shape& shape, const glm::dmat4& world_from_shape) {
  std::vector<ShapeFace> faces;
  for (const UnitFace& unit : unit_faces(shape)) {
    ShapeFace face;
    face.kind = unit.kind;
    face.bottom = unit.bottom;
    face.top = unit.top;
    face.world_from_unit = glm::dmat3(world_from_shape) * unit.stretch;
    face.origin = glm::dvec3(world_from_shape * glm::dvec4(unit.origin, 1.0));
    if (!invert(face.world_from_unit, face.unit_from_world)) return {};
    const FaceBounds box = bounds_of(face);
    const glm::dvec3 size = box.hi - box.lo;
    face.size = std::max({size.x, size.y, size.z});
    faces.push_back(face);
  }
  return faces;
}

FaceBounds bounds_of(const ShapeFace& face) {
  const glm::dmat3& m = face.world_from_unit;
  const glm::dvec3 around = ellipse_reach(m[0], m[2]);
  switch (face.kind) {
    case ShapeFace::Kind::sphere: {
      const glm::dvec3 reach = glm::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
      return {face.origin - reach, face.origin + reach};
    }
    case ShapeFace::Kind::disk:
      return {face.origin - around, face.origin + around};
    case ShapeFace::Kind::side:
      break;
  }
  const glm::dvec3 top = face.origin + m[1];
  return {glm::min(face.origin - face.bottom * around, top - face.top * around),
          glm::max(face.origin + face.bottom * around, top + face.top * around)};
}

}  // namespace asos
