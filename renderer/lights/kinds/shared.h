// Geometry of lights that scalar code and kernels share, as templates on a vector type V:
// glm::dvec3, or Vec3 of lanes (renderer/kernels/simd_math.h). A `Light` is a PreparedLight or its
// LightConstants. Included once; where Highway is included before, once for each instruction set.
#if defined(ASOS_LIGHTS_KINDS_SHARED_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_LIGHTS_KINDS_SHARED_H
#undef ASOS_LIGHTS_KINDS_SHARED_H
#else
#define ASOS_LIGHTS_KINDS_SHARED_H
#endif

#include "renderer/lights/kinds/capsule_directions.h"
#include "renderer/lights/lane_choices.h"
#include "renderer/lights/light_math.h"
#include "renderer/lights/prepared_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#ifdef HWY_NAMESPACE
HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
#else
namespace asos {
#endif

/// What all shapes have: `highlight`, as highlight_of, for the reflected view direction `ray`, and
/// `sample`, as sample_light. A sample's query `q` has the light and the receiver; `middle`, the
/// light's centre relative to the receiver; the sample as `u` and `v` in -1 to 1 or as a point
/// `on_disk` (concentric); and the shape's `numbers`. Shapes with an area have `meet`: where the
/// direction of a query hits the light, and the density of the samples there, by solid angle.
template <LightShape shape>
struct SharedGeometry;

constexpr double infinitely_far = std::numeric_limits<double>::infinity();

/// Numbers that a shape needs in double precision for a sample; see its `numbers`.
template <class N>
struct Numbers {
  N first{}, second{}, third{}, fourth{};
};
template <class N, class... Others>
Numbers(N, Others...) -> Numbers<N>;

/// As LightSample. The light's power times `form` is the irradiance.
template <class V>
struct SampleOf {
  V direction;
  decltype(V::x) distance, form;
};
template <class V, class... N>
SampleOf(V, N...) -> SampleOf<V>;

/// Returns the cosine of `direction` (unit) to the receiver's normal; 0 below either of its
/// horizons.
ASOS_INLINE auto cosine_above(const auto& direction, const auto& receiver) {
  using std::max;
  return where(dot(direction, receiver.geometric) > 0.0, max(0.0, dot(direction, receiver.normal)));
}

/// Returns a sample at a point, without form. At the receiver itself it has no direction.
ASOS_INLINE auto sample_towards(const auto& to_point) {
  const auto distance = length(to_point);
  return SampleOf{to_point / selected(distance > 0.0, distance, 1.0), distance, 0.0};
}

/// Returns the fraction of light that a spot's cone and range leave, as `attenuation`.
template <class V>
ASOS_INLINE decltype(V::x) attenuation_towards(const auto& light, const V& to_light) {
  using std::clamp, std::min;
  if (light.inverse_range == 0 && light.cone_scale == 0) return 1.0;
  const auto distance = length(to_light);
  const auto r = min(distance * light.inverse_range, 1.0);
  const auto by_range = 1.0 - r * r * r * r;
  if (!(light.cone_scale > 0)) return by_range;
  const auto apart = distance > 0.0;
  const auto cosine = dot(to_light, light.towards) / selected(apart, distance, 1.0);
  const auto cone = clamp(cosine * light.cone_scale + light.cone_offset, 0.0, 1.0);
  return by_range * selected(apart, cone * cone, 1.0);
}

/// Samples the directions within the cone about `axis`, uniformly by solid angle. one_less_cosine
/// is 1 - cos of the cone's half angle.
ASOS_INLINE auto cone_sample(const auto& q, const auto& axis, const auto& one_less_cosine) {
  using std::min, std::sqrt;
  // 1 - cos of a cap is proportional to the disk's squared radius, and so is the disk's area.
  const auto p = q.on_disk();
  const auto drop = min(1.0, p.x * p.x + p.y * p.y) * one_less_cosine;
  const auto stretch = sqrt((2.0 - drop) * one_less_cosine);
  const auto x_axis = any_perpendicular(axis);
  const auto direction = (1.0 - drop) * axis + stretch * (p.x * x_axis + p.y * cross(axis, x_axis));
  const auto solid_angle = 2.0 * std::numbers::pi * one_less_cosine;
  return SampleOf{direction, infinitely_far, solid_angle * cosine_above(direction, q.receiver)};
}

template <class Q>
ASOS_INLINE typename Q::Hit meet_cone(const Q& q, const auto& axis, const auto& one_less_cosine) {
  // Compare chords, since cosines near the axis have no digits left.
  const auto chord = q.direction - axis;
  return {infinitely_far, 0.5 * std::numbers::inv_pi / one_less_cosine,
          0.5 * dot(chord, chord) <= one_less_cosine};
}

/// As contour_side.
ASOS_INLINE auto contour_term(const auto& a, const auto& b, const auto& normal) {
  using std::sqrt;
  // b - a is exact for a short side, where a x b would lose digits.
  const auto across = cross(b - a, a);
  const auto sine2 = dot(across, across);
  const auto some = sine2 > 0.0;
  const auto sine = sqrt(selected(some, sine2, 1.0));
  return where(some, 0.5 * arc_tangent(sine, dot(a, b)) * dot(across, normal) / sine);
}

/// Where a ray enters, and whether it does; otherwise the distance is about that of its nearest
/// point.
template <class N>
struct Entry {
  N distance;
  decltype(N() > N()) met;
};
template <class V>
ASOS_INLINE Entry<decltype(V::x)> entry_into_ball(const V& to_centre, double radius,
                                                  const V& direction) {
  using std::max, std::sqrt;
  const auto along = dot(to_centre, direction);
  const V beside = to_centre - along * direction;
  const auto under = radius * radius - dot(beside, beside);
  return {along - sqrt(max(0.0, under)), under > 0.0};
}

/// Returns 1 - cos of an angle, given its sine.
ASOS_INLINE auto one_less_cosine(const auto& sine) {
  using std::sqrt;
  return sine * sine / (1.0 + sqrt((1.0 - sine) * (1.0 + sine)));
}

/// As Highlight.
template <class V>
struct HighlightOf {
  V direction;
  decltype(V::x) half_angle_tangent = 0.0;
  decltype(V::x) distance = std::numeric_limits<float>::infinity();
};
template <class V, class... N>
HighlightOf(V, N...) -> HighlightOf<V>;

/// Returns the highlight of a point with a radius, or along the ray if the point is the receiver.
ASOS_INLINE auto highlight_towards(const auto& to_point, auto radius, const auto& ray) {
  using std::max;
  const auto distance = length(to_point);
  const auto apart = distance > 0.0;
  HighlightOf highlight{selected(apart, to_point / selected(apart, distance, 1.0), ray)};
  highlight.distance = distance;
  // Points inside of the radius are treated as on the surface of a ball.
  if (radius > 0) highlight.half_angle_tangent = radius / max(distance, radius);
  return highlight;
}

/// Returns the nearest point of a ball (or of a sun at the distance 1): at most a radius from its
/// centre towards the ray.
ASOS_INLINE auto nearest_of_ball(const auto& to_middle, auto radius, const auto& ray) {
  using std::max;
  // A ray that leads away is nearest where it starts.
  const auto to_ray = max(0.0, dot(to_middle, ray)) * ray - to_middle;
  const auto distance = length(to_ray);
  const auto far = distance > radius;
  return to_middle + selected(far, radius / selected(far, distance, 1.0), 1.0) * to_ray;
}

/// Returns the point of a segment, or of a capsule's axis, with the least distance to a ray's line.
ASOS_INLINE auto nearest_of_axis(const auto& light, const auto& to_middle, const auto& ray) {
  using std::clamp;
  const auto ray_half = dot(ray, light.half_u);
  const auto across2 = dot(light.half_u, light.half_u) - ray_half * ray_half;
  const auto wanted = dot(ray, to_middle) * ray_half - dot(to_middle, light.half_u);
  const auto crosses = across2 > 0.0;
  const auto t = where(crosses, clamp(wanted / selected(crosses, across2, 1.0), -1.0, 1.0));
  return to_middle + t * light.half_u;
}

template <>
struct SharedGeometry<LightShape::point> {
  static ASOS_INLINE auto highlight(const auto&, const auto& to_middle, const auto& ray) {
    return highlight_towards(to_middle, 0.0, ray);
  }
  static ASOS_INLINE auto sample(const auto& q) {
    auto sample = sample_towards(q.middle);
    const auto form = cosine_above(sample.direction, q.receiver) / dot(q.middle, q.middle);
    sample.form = where(sample.distance > 0.0, form * attenuation_towards(q.light, q.middle));
    return sample;
  }
};

template <>
struct SharedGeometry<LightShape::distant> {
  template <class V>
  static ASOS_INLINE auto highlight(const auto& light, const V&, const V&) {
    return HighlightOf{V(light.towards)};
  }
  static ASOS_INLINE auto sample(const auto& q) {
    const auto direction = q.vector(q.light.towards);
    return SampleOf{direction, infinitely_far, cosine_above(direction, q.receiver)};
  }
};

template <>
struct SharedGeometry<LightShape::ball> {
  static ASOS_INLINE auto highlight(const auto& light, const auto& to_middle, const auto& ray) {
    const auto distance = length(to_middle);
    const auto inside = distance <= light.radius;
    const auto nearest = nearest_of_ball(to_middle, light.radius, ray);
    return HighlightOf{selected(inside, ray, highlight_towards(nearest, 0.0, ray).direction),
                       selected(inside, 1.0, light.radius / selected(inside, 1.0, distance)),
                       where(!inside, distance - light.radius)};
  }
  static ASOS_INLINE auto sample(const auto& q) {
    using std::max, std::sqrt;
    const auto radius = q.light.radius;
    const auto distance = length(q.middle);
    const auto inside = distance <= radius;
    const auto sine = radius / max(distance, radius);
    auto sample = cone_sample(q, q.middle / selected(inside, 1.0, distance), one_less_cosine(sine));
    // Choose the near side of the ball. At its rim the root rounds to either side of 0.
    const auto along = dot(sample.direction, q.middle);
    const auto beside = q.middle - along * sample.direction;
    sample.distance = along - sqrt(max(0.0, radius * radius - dot(beside, beside)));
    if (!none(inside)) sample = selected(inside, sample_inside(q), sample);
    sample.form = sample.form * attenuation_towards(q.light, q.middle);
    return sample;
  }
  template <class Q>
  static ASOS_INLINE typename Q::Hit meet(const Q& q) {
    using std::max, std::sqrt;
    const auto radius = q.light.radius;
    const auto distance = length(q.middle);
    const auto inside = distance <= radius;
    const auto sine = radius / max(distance, radius);
    const auto cone =
        meet_cone(q, q.middle / selected(inside, 1.0, distance), one_less_cosine(sine));
    const auto along = dot(q.direction, q.middle);
    const auto beside = q.middle - along * q.direction;
    const auto half_chord = sqrt(max(0.0, radius * radius - dot(beside, beside)));
    const auto even = max(0.0, dot(q.direction, q.receiver.normal)) * std::numbers::inv_pi;
    return {along - selected(inside, -half_chord, half_chord), selected(inside, even, cone.density),
            inside || cone.met};
  }

 private:
  /// From the inside, where light arrives from all directions, samples by the cosine to the
  /// receiver's normal.
  static ASOS_INLINE auto sample_inside(const auto& q) {
    using std::max, std::sqrt;
    const auto p = q.on_disk();
    const auto& normal = q.receiver.normal;
    const auto x_axis = any_perpendicular(normal);
    const auto up = sqrt(max(0.0, 1.0 - (p.x * p.x + p.y * p.y)));
    const auto direction = p.x * x_axis + p.y * cross(normal, x_axis) + up * normal;
    const auto along = dot(direction, q.middle);
    const auto power = q.light.radius * q.light.radius - dot(q.middle, q.middle);
    return SampleOf{direction, along + sqrt(along * along + max(0.0, power)),
                    where(dot(direction, q.receiver.geometric) > 0.0, std::numbers::pi)};
  }
};

template <>
struct SharedGeometry<LightShape::sun> {
  template <class V>
  static ASOS_INLINE auto highlight(const auto& light, const V&, const V& ray) {
    const V nearest = nearest_of_ball(V(light.towards), light.radius, ray);
    return HighlightOf{highlight_towards(nearest, 0.0, ray).direction, light.radius};
  }
  static ASOS_INLINE auto sample(const auto& q) {
    return cone_sample(q, q.vector(q.light.towards), q.light.one_less_cosine);
  }
  template <class Q>
  static ASOS_INLINE typename Q::Hit meet(const Q& q) {
    return meet_cone(q, q.light.towards, q.light.one_less_cosine);
  }
};

template <>
struct SharedGeometry<LightShape::segment> {
  static ASOS_INLINE auto highlight(const auto& light, const auto& to_middle, const auto& ray) {
    return highlight_towards(nearest_of_axis(light, to_middle, ray), light.highlight_radius, ray);
  }
  /// Samples by the angle at the receiver (Kulla and Fajardo 2012, "equi-angular"), which cancels
  /// the squared distance. First to third: the point relative to the receiver. Fourth: the measure
  /// ds / du there, by the physical rule times the line's distance.
  template <class V>
  static ASOS_INLINE auto numbers(const PreparedLight& light, const auto&, const V& middle,
                                  const auto& u, const auto&) {
    using std::clamp, std::sqrt;
    const double length = 2.0 * light.u_length;
    const auto ahead = dot(middle, light.u_axis);
    const auto s0 = ahead - light.u_length, s1 = s0 + length;
    const V foot = middle - ahead * light.u_axis;
    const auto height2 = dot(foot, foot), height = sqrt(height2);
    const auto angle = arc_tangent(height * length, height2 + s0 * s1);
    const auto turn = sin_cos(u * angle);
    // The place is tan(atan(s0 / height) + u angle) height.
    const auto up = s0 * turn.cos + height * turn.sin, over = height * turn.cos - s0 * turn.sin;
    const auto wide = angle > 1e-4;
    const auto s = selected(wide, clamp(height * (up / over), s0, s1), s0 + length * u);
    // A line contributes nothing to a point on it.
    const auto by_angle = where(height > 0.0, angle / height * (height2 + s * s));
    const auto measure = selected(wide, by_angle, length);
    const V point = foot + s * light.u_axis;
    const bool tube = light.rule == LightRule::physical;
    return Numbers{point.x, point.y, point.z, tube ? measure * height : measure};
  }
  static ASOS_INLINE auto sample(const auto& q) {
    const auto [x, y, z, measure] = q.numbers();
    auto sample = sample_towards(q.vector({x, y, z}));
    const auto form =
        measure * cosine_above(sample.direction, q.receiver) / (sample.distance * sample.distance);
    const bool tube = q.light.rule == LightRule::physical;
    sample.form = where(sample.distance > 0.0, tube ? form / sample.distance : form);
    return sample;
  }
};

template <>
struct SharedGeometry<LightShape::capsule> {
  /// At the axis point with the least distance to the ray's line, moved towards the ray.
  static ASOS_INLINE auto highlight(const auto& light, const auto& to_middle, const auto& ray) {
    const auto ball = nearest_of_axis(light, to_middle, ray);
    return highlight_towards(nearest_of_ball(ball, light.radius, ray), light.highlight_radius, ray);
  }
  static ASOS_INLINE auto sample(const auto& q) {
    const auto [x, y, z, form] = q.numbers();
    auto sample = sample_towards(q.vector({x, y, z}));
    sample.form = form;
    return sample;
  }
  template <class V>
  static ASOS_INLINE Entry<decltype(V::x)> entry(const PreparedLight& light, const V& to_middle,
                                                 const V& direction) {
    using std::abs, std::max, std::sqrt;
    const auto slope = dot(direction, light.u_axis), middle = dot(to_middle, light.u_axis);
    // Look for the ray's entry into the infinite cylinder.
    const V flat = direction - slope * light.u_axis, foot = to_middle - middle * light.u_axis;
    const auto flat2 = dot(flat, flat);
    const auto crosses = flat2 > 1e-20;
    const auto across2 = selected(crosses, flat2, 1.0);
    const auto nearest = dot(foot, flat) / across2;
    const V beside = foot - nearest * flat;
    const auto under = light.radius * light.radius - dot(beside, beside);
    const auto distance = nearest - sqrt(max(0.0, under) / across2);
    const auto place = distance * slope - middle;
    const auto on_side = crosses && abs(place) <= light.u_length;
    if (all(on_side)) return {distance, under > 0.0};
    const auto upper = selected(crosses, place, -slope) > 0.0;
    const V end = to_middle + selected(upper, 1.0, -1.0) * light.half_u;
    const auto ball = entry_into_ball(end, light.radius, direction);
    return {selected(on_side, distance, ball.distance),
            (on_side && under > 0.0) || (!on_side && ball.met)};
  }
  /// First to third: the sample relative to the receiver. Fourth: its form; negative within the
  /// infinite cylinder.
  template <class V>
  static ASOS_INLINE auto numbers(const PreparedLight& light, const auto& receiver, const V& middle,
                                  const auto& u, const auto& v) {
    const SeenCapsuleOf<V> seen(middle, light.half_u, light.radius);
    const CapsuleDirections<V> directions(seen);
    const V direction = directions.direction(u, v);
    const V at = entry(light, middle, direction).distance * direction;
    const auto form = directions.solid_angle() * cosine_above(direction, receiver);
    return Numbers{at.x, at.y, at.z, selected(seen.sine < 1.0, form, -1.0)};
  }
  /// Finds directions that may hit the light: those that hit the ball around it.
  template <class Q>
  static ASOS_INLINE typename Q::Hit meet(const Q& q) {
    constexpr float wider = 1.001f;
    const auto reach = wider * (q.light.radius + q.light.u_length);
    const auto beside = q.middle - dot(q.middle, q.direction) * q.direction;
    return {0.0, 0.0, dot(beside, beside) <= reach * reach};
  }
};

/// Shared by the shapes in a plane. `Shape` has `nearest`, to a point relative to the centre, and
/// `holds`, for a point of the plane.
template <class Shape>
struct SharedFlat {
  static ASOS_INLINE auto highlight(const auto& light, const auto& to_middle, const auto& ray) {
    const auto nearest = Shape::nearest(light, plane_hit(light, to_middle, ray));
    return highlight_towards(to_middle + nearest, light.highlight_radius, ray);
  }
  /// Returns the nearest point of the bounding rectangle.
  static ASOS_INLINE auto nearest(const auto& light, const auto& hit) {
    using std::clamp;
    return clamp(dot(hit, light.u_axis), -light.u_length, light.u_length) * light.u_axis +
           clamp(dot(hit, light.v_axis), -light.v_length, light.v_length) * light.v_axis;
  }
  /// Returns whether the bounding rectangle holds a point.
  static ASOS_INLINE auto holds(const auto& light, const auto& p) {
    using std::abs;
    return abs(dot(p, light.u_axis)) <= light.u_length &&
           abs(dot(p, light.v_axis)) <= light.v_length;
  }
  /// Finds the hit as for samples by area.
  template <class Q>
  static ASOS_INLINE typename Q::Hit meet(const Q& q) {
    using std::abs;
    const auto cosine = -dot(q.direction, q.light.towards);
    const auto height = -dot(q.middle, q.light.towards);
    const auto along = q.light.two_sided ? cosine * height : cosine;
    const auto beside = q.light.two_sided ? abs(height) : height;
    auto met = along > 0.0 && beside > q.light.thickness;
    if (none(met)) return {0.0, 0.0, met};
    const auto distance = height / selected(met, cosine, 1.0);
    met = met && Shape::holds(q.light, distance * q.direction - q.middle);
    return {distance, distance * distance / selected(met, q.light.area * abs(cosine), 1.0), met};
  }
  /// Returns a sample that was chosen by area.
  static ASOS_INLINE auto area_sample(const auto& q, const auto& to_point) {
    using std::abs;
    auto sample = sample_towards(to_point);
    const auto below = dot(to_point, q.light.towards);
    const auto height = q.light.two_sided ? abs(below) : -below;
    const auto form = q.light.area * (height / sample.distance) *
                      cosine_above(sample.direction, q.receiver) /
                      (sample.distance * sample.distance);
    sample.form = where(sample.distance > 0.0 && height > q.light.thickness, form);
    return sample;
  }

 private:
  /// Returns the point where the mirrored ray hits the light's plane, relative to `to_middle`. If
  /// the ray hits the plane beyond the whole light, or not at all, the ray's far end is used
  /// instead, so that the point moves continuously as the ray turns away.
  static ASOS_INLINE auto plane_hit(const auto& light, const auto& to_middle, const auto& ray) {
    using std::abs;
    const auto far = length(to_middle) + light.u_length + light.v_length;
    const auto along = dot(to_middle, light.towards), slope = dot(ray, light.towards);
    const auto hits = along * slope > 0.0 && abs(along) < far * abs(slope);
    return selected(hits, along / selected(hits, slope, 1.0), far) * ray - to_middle;
  }
};

template <>
struct SharedGeometry<LightShape::rectangle> : SharedFlat<SharedGeometry<LightShape::rectangle>> {
  /// The part that may be above the receiver's horizons (Urena, Fajardo and King 2013, "An
  /// Area-Preserving Parametrization for Spherical Rectangles"; here sums of angles are products of
  /// unit complex numbers).
  template <class N>
  struct Arcs {
    N y0, y1;              ///< ends along half_v, from the foot of the receiver's perpendicular
    N solid_angle;         ///< 0: sampled by area
    N sine, cosine;        ///< of the angle at the first side
    N normal_0, normal_2;  ///< z of the unit normals of the planes through two sides
  };
  template <class V>
  static ASOS_INLINE auto arcs(const PreparedLight& light, const auto& receiver, const V& middle) {
    using std::abs, std::max, std::sqrt;
    const auto x = dot(middle, light.u_axis), y = dot(middle, light.v_axis);
    const auto z = dot(middle, light.towards);
    auto x0 = x - light.u_length, x1 = x + light.u_length;
    auto y0 = y - light.v_length, y1 = y + light.v_length;
    for (const V& normal : {receiver.geometric, receiver.normal}) {
      const auto nx = dot(normal, light.u_axis), ny = dot(normal, light.v_axis);
      const auto by_z = z * dot(normal, light.towards);
      keep_positive(ny, by_z + max(x0 * nx, x1 * nx), y0, y1);
      keep_positive(nx, by_z + max(y0 * ny, y1 * ny), x0, x1);
    }
    // Compute the z of the unit normals of the planes through the point and a side, and the angles
    // between neighbouring planes.
    const auto z2 = z * z;
    const auto n0 = -(y0 / sqrt(z2 + y0 * y0)), n1 = x1 / sqrt(z2 + x1 * x1);
    const auto n2 = y1 / sqrt(z2 + y1 * y1), n3 = -(x0 / sqrt(z2 + x0 * x0));
    const auto first = sum(angle_of(-(n0 * n1)), angle_of(-(n1 * n2)));
    const auto second = sum(angle_of(-(n2 * n3)), angle_of(-(n3 * n0)));
    const auto all = sum(first, second);  // the solid angle plus 2 pi
    auto solid_angle = arc_tangent(all.sin, all.cos);
    solid_angle = selected(solid_angle < -1e-12, solid_angle + 2.0 * std::numbers::pi, solid_angle);
    // Smaller solid angles have too few digits, and sampling by area is as good at that distance.
    const auto seen = (light.two_sided ? abs(z) : -z) > light.thickness;
    solid_angle = where(seen && solid_angle > 1e-5, solid_angle);
    return Arcs<decltype(V::x)>{y0, y1, solid_angle, -second.sin, second.cos, n0, n2};
  }
  /// Returns the place along half_u as 1 / (x / z)^2, with the sign of x.
  static ASOS_INLINE auto slope2(const auto& arcs, const auto& u) {
    using std::copysign, std::max;
    const auto n0 = arcs.normal_0;
    const auto angle = sum(sin_cos(u * arcs.solid_angle), {arcs.sine, arcs.cosine});
    const auto quotient = (angle.cos * n0 - arcs.normal_2) / angle.sin;
    // At the end of a rectangle that fills half of all directions, the quotient would be 0 / 0.
    const auto f = selected(angle.sin == 0.0, where(u < 0.5, -0.0), quotient);
    return copysign(max(f * f - (1.0 - n0) * (1.0 + n0), 1e-30), f);
  }
  /// First: the solid angle. Second: slope2. Third and fourth: the ends along half_v.
  static ASOS_INLINE auto numbers(const PreparedLight& light, const auto& receiver,
                                  const auto& middle, const auto& u, const auto&) {
    const auto found = arcs(light, receiver, middle);
    return Numbers{found.solid_angle, slope2(found, u), found.y0, found.y1};
  }
  static ASOS_INLINE auto sample(const auto& q) {
    using std::abs, std::clamp, std::copysign, std::sqrt;
    const auto& light = q.light;
    const auto [solid_angle, slope2, y0, y1] = q.numbers();
    const auto by_angle = solid_angle > 0.0;
    auto by_area = sample_towards(q.middle);
    if (!all(by_angle)) {
      by_area = place(q);
      if (none(by_angle)) return by_area;
    }
    const auto x_middle = dot(q.middle, light.u_axis), z = dot(q.middle, light.towards);
    const auto per_z = copysign(1.0 / sqrt(abs(slope2)), slope2);
    // At u = 0 and 1 the quotient rounds to either side of the rectangle's ends.
    const auto x = clamp(abs(z) * per_z, x_middle - light.u_length, x_middle + light.u_length);
    const auto d2 = x * x + z * z;
    const auto h0 = y0 / sqrt(d2 + y0 * y0), h1 = y1 / sqrt(d2 + y1 * y1);
    const auto h = h0 + (q.v() * 0.5 + 0.5) * (h1 - h0);
    const auto y = clamp(h * sqrt(d2) / sqrt((1.0 - h) * (1.0 + h)), y0, y1);
    auto sample = sample_towards(x * light.u_axis + y * light.v_axis + z * light.towards);
    sample.form = solid_angle * cosine_above(sample.direction, q.receiver);
    return all(by_angle) ? sample : selected(by_angle, sample, by_area);
  }
  template <class Q>
  static ASOS_INLINE typename Q::Hit meet(const Q& q) {
    auto hit = SharedFlat<SharedGeometry>::meet(q);
    const auto solid_angle = q.numbers().first;
    const auto by_angle = solid_angle > 0.0;
    hit.density = selected(by_angle, 1.0 / selected(by_angle, solid_angle, 1.0), hit.density);
    return hit;
  }
  /// Samples by area.
  static ASOS_INLINE auto place(const auto& q) {
    return area_sample(q, q.middle + q.u() * q.light.half_u + q.v() * q.light.half_v);
  }

 private:
  /// Returns sine and cosine of the angle in 0 to pi with a cosine.
  template <class N>
  static ASOS_INLINE SinCos<N> angle_of(const N& cosine) {
    using std::max, std::sqrt;
    return {sqrt(max(0.0, (1.0 - cosine) * (1.0 + cosine))), cosine};
  }
  /// Returns sine and cosine of the sum of two angles.
  template <class N>
  static ASOS_INLINE SinCos<N> sum(const SinCos<N>& a, const SinCos<N>& b) {
    return {a.sin * b.cos + a.cos * b.sin, a.cos * b.cos - a.sin * b.sin};
  }
  /// Clips the interval from `low` to `high` to where the line slope t + rest is positive, unless
  /// nothing would be left.
  static ASOS_INLINE void keep_positive(const auto& slope, const auto& rest, auto& low,
                                        auto& high) {
    // Most intervals lie on one side of the line's root.
    if (none((slope * low + rest > 0.0) != (slope * high + rest > 0.0))) return;
    const auto end = -(rest / slope);
    const auto within = end > low && end<high, rises = slope> 0.0;
    low = selected(within && rises, end, low);
    high = selected(within && !rises, end, high);
  }
};

template <>
struct SharedGeometry<LightShape::polygon> : SharedFlat<SharedGeometry<LightShape::polygon>> {
  /// First and second: the place relative to the centre, along half_u and half_v.
  static auto numbers(const PreparedLight& light, const auto&, const auto&, double u, double v) {
    const glm::dvec2 p = light.rows.point(u, v);
    return Numbers<double>{p.x, p.y};
  }
  static ASOS_INLINE auto sample(const auto& q) {
    const auto p = q.numbers();
    return area_sample(q, q.middle + p.first * q.light.u_axis + p.second * q.light.v_axis);
  }
};

template <>
struct SharedGeometry<LightShape::disk> : SharedFlat<SharedGeometry<LightShape::disk>> {
  static ASOS_INLINE auto nearest(const auto& light, const auto& hit) {
    const auto flat = hit - dot(hit, light.towards) * light.towards;
    const auto distance = length(flat);
    const auto beyond = distance > light.radius;
    return selected(beyond, light.radius / selected(beyond, distance, 1.0), 1.0) * flat;
  }
  static ASOS_INLINE auto holds(const auto& light, const auto& p) {
    return dot(p, p) <= light.radius * light.radius;
  }
  static ASOS_INLINE auto sample(const auto& q) {
    const auto p = q.on_disk();
    return area_sample(q, q.middle + p.x * q.light.half_u + p.y * q.light.half_v);
  }
};

#ifdef HWY_NAMESPACE
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#else
}  // namespace asos
#endif

#endif
