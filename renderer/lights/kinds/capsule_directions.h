// Sampling of capsules for a vector type V: glm::dvec3, or Vec3 of double lanes. Included once;
// where Highway is included before, once for each instruction set.
#if defined(ASOS_LIGHTS_KINDS_CAPSULE_DIRECTIONS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_LIGHTS_KINDS_CAPSULE_DIRECTIONS_H
#undef ASOS_LIGHTS_KINDS_CAPSULE_DIRECTIONS_H
#else
#define ASOS_LIGHTS_KINDS_CAPSULE_DIRECTIONS_H
#endif

#include "renderer/lights/lane_choices.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#ifdef HWY_NAMESPACE
HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
#else
namespace asos {
#endif

/// A capsule (all points within a radius of a segment) as seen from outside of the infinite
/// cylinder around it. The silhouette has two straight sides and an arc around each end. It is
/// symmetrical about the plane through the receiver and the axis. Longitudes are angles in that
/// plane from the foot of the receiver's perpendicular to the axis, and increase along the axis.
template <class V>
struct SeenCapsuleOf {
  using N = decltype(V::x);
  /// The ball at an end. The arc is its part of the circle in which the receiver's cone touches the
  /// ball: the angles up to `arc` to both sides of `outward`.
  struct End {
    V centre;         ///< relative to the receiver
    V axis, outward;  ///< unit: to the centre, and perpendicular, away from the middle
    N along;          ///< from the foot to the centre, along the axis
    N sine, cosine;   ///< of the ball's half angle
    N arc;            ///< radians
    [[nodiscard]] ASOS_INLINE N one_less_cosine() const { return sine * sine / (1.0 + cosine); }
  };

  V foot, along, across;  ///< unit axes; across = foot x along
  N height;
  N sine, cosine;           ///< of half the angle between the planes of the sides
  std::array<End, 2> ends;  ///< at the axis's begin and end

  /// The sine is 1 or more for a receiver within the infinite cylinder. It sees one ball.
  ASOS_INLINE SeenCapsuleOf(const V& to_middle, glm::dvec3 half, double radius) {
    using std::hypot, std::sqrt;
    const double half_length = glm::length(half);
    const glm::dvec3 axis = half / half_length;
    // Start at the nearer end, since the other may be so far that the foot would lose digits.
    const auto side = selected(dot(to_middle, half) > 0.0, -1.0, 1.0);
    const V nearer = to_middle + side * half;
    const auto nearer_along = dot(nearer, axis);
    const V to_foot = nearer - nearer_along * axis;
    along = axis;
    height = length(to_foot);
    foot = to_foot / height;
    across = cross(foot, along);
    sine = radius / height;
    cosine = sqrt((1.0 - sine) * (1.0 + sine));
    for (const std::size_t i : {0, 1}) {
      End& end = ends[i];
      const double outward = i == 1 ? 1.0 : -1.0;
      end.along = nearer_along + (outward - side) * half_length;
      end.centre = to_foot + end.along * along;
      const N distance = hypot(height, end.along);
      const N cos = height / distance, sin = end.along / distance;
      end.axis = cos * foot + sin * along;
      end.outward = outward * (cos * along - sin * foot);
      end.sine = radius / distance;
      end.cosine = sqrt((1.0 - end.sine) * (1.0 + end.sine));
      end.arc = arc_tangent(cosine, outward * sine * sin);
    }
  }
};

/// Directions to a capsule, uniform by solid angle: a longitude, then the sine of the latitude. The
/// part between the arcs has a closed form; on an arc, Newton's method finds the longitude.
template <class V>
class CapsuleDirections {
 public:
  using Seen = SeenCapsuleOf<V>;
  using End = typename Seen::End;
  using N = typename Seen::N;

  ASOS_INLINE explicit CapsuleDirections(const SeenCapsuleOf<V>& seen) : seen_(seen) {
    using std::asin, std::hypot;
    for (const std::size_t i : {0, 1}) {
      const End& end = seen.ends[i];
      const N far = hypot(end.along, seen.height * seen.cosine * seen.cosine);
      side_[i] = asin(seen.sine * (end.along / far));
      const auto turn = sin_cos(end.arc);
      arc_[i] = area_to(end, arc_tangent(end.cosine * turn.sin, turn.cos));
    }
    all_ = arc_[0] + arc_[1] + (side_[1] - side_[0]);
  }

  [[nodiscard]] ASOS_INLINE N solid_angle() const { return 2.0 * all_; }

  /// Returns a unit direction. Its density by solid angle is 1 / solid_angle().
  [[nodiscard]] ASOS_INLINE V direction(N u, N v) const {
    using std::abs, std::clamp, std::copysign, std::min, std::sqrt;
    const N before = u * all_, behind = (1.0 - u) * all_;
    const auto first = before < arc_[0], on_end = first || behind < arc_[1];
    const N angle = min(side_[0] + (before - arc_[0]), side_[1]);
    const auto turn = sin_cos(abs(angle));
    N sine = clamp(copysign(turn.sin, angle) / seen_.sine, N(-1.0), N(1.0));
    N cosine = sqrt((1.0 - sine) * (1.0 + sine));
    N widest = min(N(1.0), seen_.sine * cosine / turn.cos);
    V flat = cosine * seen_.foot + sine * seen_.along;
    if (!none(on_end)) {
      const End &a = seen_.ends[0], &b = seen_.ends[1];
      const End end{
          a.centre, selected(first, a.axis, b.axis), selected(first, a.outward, b.outward),
          a.along,  selected(first, a.sine, b.sine), selected(first, a.cosine, b.cosine),
          a.arc};
      const auto longitude = sin_cos(angle_of(end, selected(first, before, behind)));
      sine = end.sine * longitude.cos;
      cosine = sqrt((1.0 - sine) * (1.0 + sine));
      flat = selected(on_end, cosine * end.axis + sine * end.outward, flat);
      widest = selected(on_end, end.sine * longitude.sin / cosine, widest);
    }
    const N up = (2.0 * v - 1.0) * widest;
    return sqrt((1.0 - up) * (1.0 + up)) * flat + up * seen_.across;
  }

 private:
  // Areas are halves of solid angles: on one side of the plane through the axis.

  /// Returns the area between the tip of an end's arc and a longitude: the ball's half angle and
  /// the longitude from the ball's centre have sines in the ratio 1 to cos(angle).
  static ASOS_INLINE N area_to(const End& end, const SinCos<N>& angle) {
    const N s = angle.sin, c = angle.cos, less = end.one_less_cosine();
    return less * arc_tangent(s, c * end.cosine) -
           arc_tangent(c * s * less, s * s + c * c * end.cosine);
  }
  static ASOS_INLINE N area_to(const End& end, N angle) { return area_to(end, sin_cos(angle)); }
  /// Returns the inverse of area_to. The area grows with the cube of a small angle, so the
  /// iteration compares cube roots. Half of the ball is symmetrical to the other.
  static ASOS_INLINE N angle_of(const End& end, N area) {
    using std::cbrt, std::clamp, std::max;
    const N whole = std::numbers::pi * end.one_less_cosine();
    const auto beyond = area > 0.5 * whole;
    const N near = selected(beyond, max(N(0.0), whole - area), area), root = cbrt(near);
    N angle = 0.5 * cbrt(6.0 * std::numbers::pi * (near / whole));
    for (int i = 0; i < 4; ++i) {
      const auto wide = angle > 1e-4;
      if (none(wide)) break;
      const auto turn = sin_cos(angle);
      const N x = end.sine * turn.cos;
      const N slope = end.sine * end.sine * turn.sin * turn.sin / ((1.0 - x) * (1.0 + x));
      const N now = cbrt(max(N(0.0), area_to(end, turn)));
      angle = selected(wide, angle - (now - root) * 3.0 * now * now / slope, angle);
    }
    angle = clamp(angle, N(0.0), N(0.5 * std::numbers::pi));
    return selected(beyond, std::numbers::pi - angle, angle);
  }

  Seen seen_;
  std::array<N, 2> side_, arc_;  // areas: from the foot to the arc, and within it
  N all_;
};

#ifdef HWY_NAMESPACE
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#else
}  // namespace asos
#endif

#endif
