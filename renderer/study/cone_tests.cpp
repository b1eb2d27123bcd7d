#include "renderer/study/cone_tests.h"

#include "renderer/geometry/ellipse_arc.h"
#include "renderer/geometry/face_crossings.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Returns |d x axis|^2 - sine^2 |d|^2, which is below 0 inside the double cone.
double outside(const PyrayCone& cone, glm::dvec3 d) {
  const double along = glm::dot(d, cone.axis);
  return glm::dot(d, d) * cone.cosine * cone.cosine - along * along;
}

bool ahead(const PyrayCone& cone, glm::dvec3 d) {
  return glm::dot(d, cone.axis) > 0.0;
}

// Returns whether the cone contains a point of a segment between offsets from the apex. Tests the
// minimum of a quadratic, and the ends.
bool near_segment(const PyrayCone& cone, glm::dvec3 a, glm::dvec3 b) {
  if (outside(cone, a) < 0.0 && ahead(cone, a)) return true;
  if (outside(cone, b) < 0.0 && ahead(cone, b)) return true;
  const glm::dvec3 d = b - a;
  const double along_a = glm::dot(a, cone.axis), along_d = glm::dot(d, cone.axis);
  const double c2 = cone.cosine * cone.cosine;
  const double q1 = glm::dot(a, d) * c2 - along_a * along_d;
  const double q2 = glm::dot(d, d) * c2 - along_d * along_d;
  if (!(q2 > 0.0)) return false;
  const double t = -q1 / q2;
  if (!(t > 0.0 && t < 1.0)) return false;
  const glm::dvec3 p = a + t * d;
  return outside(cone, p) < 0.0 && ahead(cone, p);
}

/// Finds where a circle is nearest to the cone's axis, seen from the apex.
class RingTest {
 public:
  RingTest(const PyrayCone& cone, const EllipseArc& ring)
      : cone_(cone), ring_(ring), centre_(ring.centre - cone.apex) {}

  /// Returns whether the cone contains a point of the circle. Searches downhill from the points
  /// that look nearest. These are straight outwards from where the axis crosses the circle's plane,
  /// and where the circle crosses the axis' projection.
  [[nodiscard]] bool near() const {
    const double radius2 = glm::dot(ring_.cosine, ring_.cosine);
    const glm::dvec3 n = glm::normalize(glm::cross(ring_.cosine, ring_.sine));
    const double slant = glm::dot(n, cone_.axis);
    const glm::dvec3 along = cone_.axis - slant * n;
    const double t =
        std::abs(slant) > edge_on ? glm::dot(n, centre_) / slant : glm::dot(cone_.axis, centre_);
    const glm::dvec3 q = t * cone_.axis - centre_;
    if (std::abs(slant) > edge_on && far(t, slant, q, radius2)) return false;
    if (descends(q)) return true;
    const double a = glm::dot(along, along), b = glm::dot(q, along);
    if (!(a > 0.0)) return false;
    const double inside = b * b - a * (glm::dot(q, q) - radius2);
    const double half = inside > 0.0 ? std::sqrt(inside) : 0.0;
    return descends(q + (-b + half) / a * along) || descends(q + (-b - half) / a * along);
  }

 private:
  static constexpr double edge_on = 0.02;

  // Returns whether the cone's section with the circle's plane, an ellipse, does not reach the
  // circle. Its extent follows from a triangle with the cone's half angle at the apex.
  [[nodiscard]] bool far(double t, double slant, glm::dvec3 q, double radius2) const {
    const double upright =
        std::abs(slant) * cone_.cosine - std::sqrt(std::max(0.0, 1.0 - slant * slant)) * cone_.sine;
    if (!(upright > 0.0)) return false;
    const double reach = std::abs(t) * cone_.sine / upright;
    return std::abs(glm::length(q) - std::sqrt(radius2)) > reach;
  }

  // Searches from the circle's point in a direction, by Newton's steps for d . d cosine^2 - (d .
  // axis)^2.
  [[nodiscard]] bool descends(glm::dvec3 towards) const {
    double angle = std::atan2(glm::dot(towards, ring_.sine), glm::dot(towards, ring_.cosine));
    const double c2 = cone_.cosine * cone_.cosine;
    for (int step = 0;; ++step) {
      const double co = std::cos(angle), si = std::sin(angle);
      const glm::dvec3 d = centre_ + co * ring_.cosine + si * ring_.sine;
      if (outside(cone_, d) < 0.0 && ahead(cone_, d)) return true;
      if (step == 4) return false;
      const glm::dvec3 d1 = co * ring_.sine - si * ring_.cosine, d2 = centre_ - d;
      const double w = glm::dot(d, cone_.axis), w1 = glm::dot(d1, cone_.axis);
      const double f1 = glm::dot(d, d1) * c2 - w * w1;
      const double f2 =
          (glm::dot(d1, d1) + glm::dot(d, d2)) * c2 - w1 * w1 - w * glm::dot(d2, cone_.axis);
      if (!(std::abs(f2) > 0.0)) return false;
      angle -= std::clamp(f1 / std::abs(f2), -0.5, 0.5);
    }
  }

  const PyrayCone& cone_;
  const EllipseArc& ring_;
  glm::dvec3 centre_;
};

bool near_ring(const PyrayCone& cone, const EllipseArc& ring) {
  return RingTest(cone, ring).near();
}

bool axis_meets(const PyrayCone& cone, const ShapeFace& face) {
  const FaceCrossings met = cross(face, cone.apex, cone.axis);
  return met.count > 0 && met.t[met.count - 1] > 0.0;
}

bool axis_meets_polygon(const PyrayCone& cone, std::span<const glm::dvec3> corners) {
  // All sides turn the same way around the axis.
  double sign = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = corners[i] - cone.apex;
    const glm::dvec3 b = corners[i + 1 == corners.size() ? 0 : i + 1] - cone.apex;
    const double side = glm::dot(glm::cross(a, b), cone.axis);
    if (side * sign < 0.0) return false;
    if (side != 0.0) sign = side;
  }
  return ahead(cone, corners[0] - cone.apex);
}

ConeMeeting meeting(bool boundary, bool inside) {
  if (boundary) return ConeMeeting::marginal;
  return inside ? ConeMeeting::covered : ConeMeeting::none;
}

}  // namespace

// With the sphere's half angle b and its centre at the angle a from the axis, a > b + c is outside
// and a < b - c inside of it, where c is the cone's half angle.
ConeMeeting meet_sphere(const PyrayCone& cone, glm::dvec3 centre, double radius) {
  const glm::dvec3 d = centre - cone.apex;
  const double distance2 = glm::dot(d, d);
  const double tangent2 = distance2 - radius * radius;
  if (!(tangent2 > 0.0)) return ConeMeeting::marginal;
  // All cosines and sines are multiplied by the distance.
  const double along = glm::dot(d, cone.axis), cosine = std::sqrt(tangent2);
  if (along < cosine * cone.cosine - radius * cone.sine) return ConeMeeting::none;
  const bool wider = radius * cone.cosine > cosine * cone.sine;
  const bool inside = along > cosine * cone.cosine + radius * cone.sine;
  return wider && inside ? ConeMeeting::covered : ConeMeeting::marginal;
}

ConeMeeting meet_polygon(const PyrayCone& cone, std::span<const glm::dvec3> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 b = corners[i + 1 == corners.size() ? 0 : i + 1];
    if (near_segment(cone, corners[i] - cone.apex, b - cone.apex)) return ConeMeeting::marginal;
  }
  return meeting(false, axis_meets_polygon(cone, corners));
}

ConeMeeting meet_disk(const PyrayCone& cone, const ShapeFace& face) {
  return meeting(near_ring(cone, ring(face, 0.0)), axis_meets(cone, face));
}

ConeMeeting meet_cylinder(const PyrayCone& cone, const ShapeFace& side) {
  const EllipseArc bottom = ring(side, 0.0), top = ring(side, 1.0);
  if (side.bottom > 0.0 && near_ring(cone, bottom)) return ConeMeeting::marginal;
  if (side.top > 0.0 && near_ring(cone, top)) return ConeMeeting::marginal;
  const glm::dvec3 a = side.unit(cone.apex);
  const double radius = side.radius_at(a.y), distance = std::hypot(a.x, a.z);
  if (distance > std::abs(radius)) {
    // The lines whose tangent planes contain the apex (side_outline of feature_curve.cpp).
    const double x = a.x / distance, z = a.z / distance;
    const double c = radius / distance, s = std::sqrt((1.0 - c) * (1.0 + c));
    for (const double turn : {s, -s}) {
      const double u = x * c - z * turn, v = z * c + x * turn;
      const auto on = [&](const EllipseArc& rim) {
        return rim.centre + u * rim.cosine + v * rim.sine - cone.apex;
      };
      if (near_segment(cone, on(bottom), on(top))) return ConeMeeting::marginal;
    }
  }
  if (axis_meets(cone, side)) return ConeMeeting::covered;
  // Or through a lid.
  const glm::dvec3 o = side.unit(cone.apex), d = side.unit_from_world * cone.axis;
  for (const double y : {0.0, 1.0}) {
    const double t = (y - o.y) / d.y, r = side.radius_at(y);
    const double x = o.x + t * d.x, z = o.z + t * d.z;
    if (t > 0.0 && x * x + z * z < r * r) return ConeMeeting::covered;
  }
  return ConeMeeting::none;
}

ConeMeeting meet_box(const PyrayCone& cone, glm::dvec3 lo, glm::dvec3 hi) {
  if (meet_sphere(cone, 0.5 * (lo + hi), 0.5 * glm::length(hi - lo)) == ConeMeeting::none)
    return ConeMeeting::none;
  // [k]: whether the apex is in front of the low face and of the high face across axis k.
  bool faces[3][2];
  for (int k = 0; k < 3; ++k) {
    faces[k][0] = cone.apex[k] < lo[k];
    faces[k][1] = cone.apex[k] > hi[k];
  }
  const glm::dvec3 from = lo - cone.apex, to = hi - cone.apex;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    for (int side = 0; side < 4; ++side) {
      const int si = side & 1, sj = side >> 1;
      if (faces[i][si] == faces[j][sj]) continue;
      glm::dvec3 a(0.0);
      a[i] = si ? to[i] : from[i];
      a[j] = sj ? to[j] : from[j];
      glm::dvec3 b = a;
      a[k] = from[k];
      b[k] = to[k];
      if (near_segment(cone, a, b)) return ConeMeeting::marginal;
    }
  }
  double t0 = 0.0, t1 = 1e300;
  for (int k = 0; k < 3; ++k) {
    const double a = from[k] / cone.axis[k], b = to[k] / cone.axis[k];
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  return t0 < t1 ? ConeMeeting::covered : ConeMeeting::none;
}

}  // namespace asos
