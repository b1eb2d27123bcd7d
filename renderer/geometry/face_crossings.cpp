#include "renderer/geometry/face_crossings.h"

#include <cmath>
#include <utility>

namespace asos {
namespace {

/// A line in the space of the unit surface. Its origin is moved to the point nearest to the axis
/// (or the centre); `t` is reduced by that distance.
struct UnitLine {
  glm::dvec3 origin;
  glm::dvec3 direction;
  double moved = 0.0;

  [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }
};

void add(FaceCrossings& found, const UnitLine& line, double t) {
  if (!std::isfinite(t)) return;
  found.t[found.count] = t + line.moved;
  found.unit[found.count] = line.at(t);
  ++found.count;
}

FaceCrossings cross_disk(const UnitLine& line) {
  FaceCrossings found;
  if (line.direction.y == 0.0) return found;
  const double t = -line.origin.y / line.direction.y;
  glm::dvec3 p = line.at(t);
  if (!(p.x * p.x + p.z * p.z <= 1.0)) return found;
  add(found, line, t);
  found.unit[0].y = 0.0;
  return found;
}

FaceCrossings cross_sphere(const UnitLine& line) {
  FaceCrossings found;
  // The origin is the point nearest to the centre.
  const double half2 =
      (1.0 - glm::dot(line.origin, line.origin)) / glm::dot(line.direction, line.direction);
  if (!(half2 > 0.0)) return found;
  const double half = std::sqrt(half2);
  add(found, line, -half);
  add(found, line, half);
  for (int i = 0; i < found.count; ++i) found.unit[i] = glm::normalize(found.unit[i]);
  return found;
}

// x^2 + z^2 = r(y)^2 with r(y) >= 0 and 0 <= y <= 1.
FaceCrossings cross_side(const ShapeFace& face, const UnitLine& line) {
  FaceCrossings found;
  const double widens = face.top - face.bottom;
  const glm::dvec3 o = line.origin, d = line.direction;
  const double r0 = face.radius_at(o.y), rd = widens * d.y;
  // a t^2 + 2 b t + c = 0.
  const double a = d.x * d.x + d.z * d.z - rd * rd;
  const double b = o.x * d.x + o.z * d.z - r0 * rd;
  const double c = (std::hypot(o.x, o.z) - r0) * (std::hypot(o.x, o.z) + r0);
  double roots[2];
  int count = 0;
  if (a == 0.0) {
    if (b != 0.0) roots[count++] = -0.5 * c / b;
  } else {
    const double square = b * b - a * c;
    if (!(square > 0.0)) return found;
    const double s = -(b + std::copysign(std::sqrt(square), b));
    roots[count++] = s / a;
    if (s != 0.0) roots[count++] = c / s;
    if (count == 2 && roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  }
  for (int i = 0; i < count; ++i) {
    const double y = o.y + roots[i] * d.y;
    if (y >= 0.0 && y <= 1.0 && face.radius_at(y) >= 0.0) add(found, line, roots[i]);
  }
  return found;
}

}  // namespace

FaceCrossings cross(const ShapeFace& face, glm::dvec3 origin, glm::dvec3 direction) {
  UnitLine line{face.unit(origin), face.unit_from_world * direction};
  if (face.kind == ShapeFace::Kind::disk) return cross_disk(line);
  // Moves the origin to the point nearest to the centre of the sphere or the axis.
  const glm::dvec3 middle =
      face.kind == ShapeFace::Kind::sphere ? glm::dvec3(0) : glm::dvec3(0, 0.5, 0);
  line.moved =
      -glm::dot(line.origin - middle, line.direction) / glm::dot(line.direction, line.direction);
  if (!std::isfinite(line.moved)) return {};
  line.origin += line.moved * line.direction;
  return face.kind == ShapeFace::Kind::sphere ? cross_sphere(line) : cross_side(face, line);
}

}  // namespace asos
