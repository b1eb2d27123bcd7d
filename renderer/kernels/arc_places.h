// Arc functions for sampling by angles, in double precision: solid angles and angles of distant
// lights are differences of large ones. Included once for each instruction set.
#if defined(ASOS_KERNELS_ARC_PLACES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_ARC_PLACES_H
#undef ASOS_KERNELS_ARC_PLACES_H
#else
#define ASOS_KERNELS_ARC_PLACES_H
#endif

#include "renderer/kernels/lanes.h"
#include "renderer/kernels/light_kernel.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

/// Converts 32-bit binary fractions to 0 to 1, exactly.
HWY_INLINE DoubleLanes fractions(const std::uint32_t* from) {
  const DoubleTag d;
  const hn::Rebind<std::int32_t, DoubleTag> di;
  const auto bits = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(from));
  const auto centred = hn::Xor(bits, hn::Set(di, std::numeric_limits<std::int32_t>::min()));
  return hn::Add(hn::Mul(hn::PromoteTo(d, centred), hn::Set(d, 1.0 / 4294967296.0)),
                 hn::Set(d, 0.5));
}
HWY_INLINE Vec3<DoubleLanes> to_middle(const ShadingPoints& points, std::size_t i,
                                       glm::dvec3 middle) {
  return broadcast(DoubleTag(), middle) - doubles(points.position, i);
}

/// Returns the sine of the angle in 0 to pi whose cosine is c.
HWY_INLINE DoubleLanes other_side(DoubleLanes c) {
  const DoubleTag d;
  const auto one = hn::Set(d, 1.0);
  return hn::Sqrt(hn::Max(hn::Zero(d), hn::Mul(hn::Sub(one, c), hn::Add(one, c))));
}

/// Returns sine and cosine of the sum of two angles.
HWY_INLINE SinCos<DoubleLanes> sum(const SinCos<DoubleLanes>& a, const SinCos<DoubleLanes>& b) {
  return {hn::Add(hn::Mul(a.sin, b.cos), hn::Mul(a.cos, b.sin)),
          hn::Sub(hn::Mul(a.cos, b.cos), hn::Mul(a.sin, b.sin))};
}

/// Clips the interval from `low` to `high` to where the line slope t + rest is positive, unless
/// nothing would be left.
HWY_INLINE void keep_positive(DoubleLanes slope, DoubleLanes rest, DoubleLanes& low,
                              DoubleLanes& high) {
  const DoubleTag d;
  const auto zero = hn::Zero(d);
  // Most intervals lie on one side of the line's root.
  const auto low_above = hn::Gt(hn::Add(hn::Mul(slope, low), rest), zero);
  const auto high_above = hn::Gt(hn::Add(hn::Mul(slope, high), rest), zero);
  if (hn::AllFalse(d, hn::Xor(low_above, high_above))) return;
  const auto end = hn::Neg(hn::Div(rest, slope));
  const auto within = hn::And(hn::Gt(end, low), hn::Lt(end, high));
  const auto rises = hn::Gt(slope, zero);
  low = hn::IfThenElse(hn::And(within, rises), end, low);
  high = hn::IfThenElse(hn::AndNot(rises, within), end, high);
}

/// The formulas of SphericalRectangle, with sums of angles as products of unit complex numbers.
/// First: the rectangle's solid angle, 0 where it is sampled by area. Third and fourth: the ends,
/// along half_v, of the part that may be above the point's horizons, measured from the foot of the
/// point's perpendicular.
inline void rectangle_arcs(const ShadingPoints& points, const PreparedLight& light,
                           LightArcs& found) {
  if (found.known) return;
  found.known = true;
  const DoubleTag d;
  const auto u_length = hn::Set(d, glm::length(light.half_u));
  const auto v_length = hn::Set(d, glm::length(light.half_v));
  const glm::dvec3 u_axis = glm::normalize(light.half_u);
  const glm::dvec3 v_axis = glm::normalize(light.half_v);
  const auto x_axis = broadcast(d, u_axis), y_axis = broadcast(d, v_axis);
  const auto z_axis = broadcast(d, glm::cross(u_axis, v_axis));
  const auto towards = broadcast(d, light.towards);
  const auto thickness = hn::Set(d, light.thickness);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const Vec3<DoubleLanes> middle = to_middle(points, i, light.position);
    const auto height = hn::Neg(dot(middle, towards));
    const auto seen = hn::Gt(light.two_sided ? hn::Abs(height) : height, thickness);
    const auto x = dot(middle, x_axis), y = dot(middle, y_axis), z = dot(middle, z_axis);
    auto x0 = hn::Sub(x, u_length), x1 = hn::Add(x, u_length);
    auto y0 = hn::Sub(y, v_length), y1 = hn::Add(y, v_length);
    for (const ShadingPoints::Vectors* horizon : {&points.geometric, &points.normal}) {
      const Vec3<DoubleLanes> normal = doubles(*horizon, i);
      const auto nx = dot(normal, x_axis), ny = dot(normal, y_axis);
      const auto by_z = hn::Mul(z, dot(normal, z_axis));
      keep_positive(ny, hn::Add(by_z, hn::Max(hn::Mul(x0, nx), hn::Mul(x1, nx))), y0, y1);
      keep_positive(nx, hn::Add(by_z, hn::Max(hn::Mul(y0, ny), hn::Mul(y1, ny))), x0, x1);
    }
    store_floats(y0, &found.third[i]);
    store_floats(y1, &found.fourth[i]);

    // Compute the z of the unit normals of the planes through the point and a side, and the angles
    // between neighbouring planes.
    const auto z2 = hn::Mul(z, z);
    const auto n0 = hn::Neg(hn::Div(y0, hn::Sqrt(hn::Add(z2, hn::Mul(y0, y0)))));
    const auto n1 = hn::Div(x1, hn::Sqrt(hn::Add(z2, hn::Mul(x1, x1))));
    const auto n2 = hn::Div(y1, hn::Sqrt(hn::Add(z2, hn::Mul(y1, y1))));
    const auto n3 = hn::Neg(hn::Div(x0, hn::Sqrt(hn::Add(z2, hn::Mul(x0, x0)))));
    const auto c0 = hn::Neg(hn::Mul(n0, n1)), c1 = hn::Neg(hn::Mul(n1, n2));
    const auto c2 = hn::Neg(hn::Mul(n2, n3)), c3 = hn::Neg(hn::Mul(n3, n0));
    const auto first = sum({other_side(c0), c0}, {other_side(c1), c1});
    const auto second = sum({other_side(c2), c2}, {other_side(c3), c3});
    const auto all = sum(first, second);  // the solid angle plus 2 pi
    auto solid_angle = arc_tangent(d, all.sin, all.cos);
    const auto beyond_half = hn::Lt(solid_angle, hn::Set(d, -1e-12));
    solid_angle = hn::IfThenElse(
        beyond_half, hn::Add(solid_angle, hn::Set(d, 2.0 * std::numbers::pi)), solid_angle);
    // Smaller solid angles have too few digits, and sampling by area is as good at that distance.
    const auto by_angle = hn::And(seen, hn::Gt(solid_angle, hn::Set(d, 1e-5)));
    solid_angle = hn::IfThenElseZero(by_angle, solid_angle);
    store_floats(solid_angle, &found.first[i]);
    hn::Store(solid_angle, d, &found.solid_angle[i]);
    hn::Store(hn::Neg(second.sin), d, &found.sine[i]);
    hn::Store(second.cos, d, &found.cosine[i]);
    hn::Store(n0, d, &found.normal_0[i]);
    hn::Store(n2, d, &found.normal_2[i]);
  }
}

/// Second, for rectangle_arcs: the place along half_u as 1 / (x / z)^2, with the sign of x.
inline void rectangle_places(const ShadingPoints& points, const PreparedLight& light,
                             const LightPointBatch& places, LightArcs& found) {
  rectangle_arcs(points, light, found);
  const DoubleTag d;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const auto solid_angle = hn::Load(d, &found.solid_angle[i]);
    if (hn::AllFalse(d, hn::Gt(solid_angle, zero))) continue;
    const auto n0 = hn::Load(d, &found.normal_0[i]), n2 = hn::Load(d, &found.normal_2[i]);
    const auto u = fractions(&places.u[i]);
    const auto turn = sin_cos(d, hn::Mul(u, solid_angle));
    const auto angle = sum(turn, {hn::Load(d, &found.sine[i]), hn::Load(d, &found.cosine[i])});
    const auto quotient = hn::Div(hn::Sub(hn::Mul(angle.cos, n0), n2), angle.sin);
    // At the end of a rectangle that fills half of all directions, the quotient would be 0 / 0.
    const auto at_end = hn::IfThenElse(hn::Lt(u, hn::Set(d, 0.5)), hn::Set(d, -0.0), zero);
    const auto f = hn::IfThenElse(hn::Eq(angle.sin, zero), at_end, quotient);
    const auto slope2 = hn::Sub(hn::Mul(f, f), hn::Mul(hn::Sub(one, n0), hn::Add(one, n0)));
    store_floats(hn::CopySign(hn::Max(slope2, hn::Set(d, 1e-30)), f), &found.second[i]);
  }
}

/// Samples by the angle at the point (Kulla and Fajardo 2012, "equi-angular"). First: the place
/// along the segment from the foot of the point's perpendicular. Second: the measure ds / du there.
/// Third: the perpendicular's length.
inline void segment_places(const ShadingPoints& points, const PreparedLight& light,
                           const LightPointBatch& places, LightArcs& found) {
  const DoubleTag d;
  const double half = glm::length(light.half_u);
  const auto length = hn::Set(d, 2.0 * half);
  const auto along = broadcast(d, light.half_u / half);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const Vec3<DoubleLanes> middle = to_middle(points, i, light.position);
    const auto ahead = dot(middle, along);
    const auto s0 = hn::Sub(ahead, hn::Set(d, half));
    const auto s1 = hn::Add(s0, length);
    const Vec3<DoubleLanes> foot = middle - scaled(ahead, along);
    const auto height2 = dot(foot, foot);
    const auto height = hn::Sqrt(height2);
    const auto angle = arc_tangent(d, hn::Mul(height, length), hn::Add(height2, hn::Mul(s0, s1)));
    const auto u = fractions(&places.u[i]);
    const auto turn = sin_cos(d, hn::Mul(u, angle));
    // The place is tan(atan(s0 / height) + u angle) height.
    const auto up = hn::Add(hn::Mul(s0, turn.cos), hn::Mul(height, turn.sin));
    const auto over = hn::Sub(hn::Mul(height, turn.cos), hn::Mul(s0, turn.sin));
    const auto turned = clamped(hn::Mul(height, hn::Div(up, over)), s0, s1);
    const auto wide = hn::Gt(angle, hn::Set(d, 1e-4));
    const auto s = hn::IfThenElse(wide, turned, hn::Add(s0, hn::Mul(length, u)));
    // A line contributes nothing to a point on it.
    const auto apart = hn::Gt(height, hn::Zero(d));
    const auto by_angle =
        hn::IfThenElseZero(apart, hn::Mul(hn::Div(angle, height), hn::Add(height2, hn::Mul(s, s))));
    store_floats(s, &found.first[i]);
    store_floats(hn::IfThenElse(wide, by_angle, length), &found.second[i]);
    store_floats(height, &found.third[i]);
  }
}

/// First and second: the place on a polygon that is no rectangle, relative to its centre.
inline void polygon_places(const ShadingPoints& points, const PreparedLight& light,
                           const LightPointBatch& places, LightArcs& found) {
  constexpr double scale = 1.0 / 4294967296.0;
  for (std::size_t i = 0; i < points.count; ++i) {
    const glm::dvec2 p = light.rows.point(scale * places.u[i], scale * places.v[i]);
    found.first[i] = static_cast<float>(p.x);
    found.second[i] = static_cast<float>(p.y);
  }
}

/// First to third: the place on a capsule, relative to the point. Fourth: the sample's form.
inline void capsule_places(const ShadingPoints& points, const PreparedLight& light,
                           const LightPointBatch& places, LightArcs& found) {
  constexpr double scale = 1.0 / 4294967296.0;
  PreparedLight of_one = light;
  of_one.power = glm::vec3(1.0f);
  for (std::size_t i = 0; i < points.count; ++i) {
    const Receiver receiver{points.position.at(i), points.normal.at(i), points.geometric.at(i)};
    const LightSample sample =
        sample_light(of_one, receiver, scale * places.u[i], scale * places.v[i]);
    const glm::vec3 offset(sample.distance * sample.direction);
    found.first[i] = offset.x;
    found.second[i] = offset.y;
    found.third[i] = offset.z;
    found.fourth[i] = sample.irradiance.x;
  }
}

/// Finds the numbers of a shape's samples at each point. Other shapes need none.
template <LightShape shape>
HWY_INLINE void find_places(ShapeTag<shape>, const ShadingPoints& points,
                            const PreparedLight& light, const LightPointBatch& places,
                            LightArcs& arc) {
  if constexpr (shape == LightShape::segment) segment_places(points, light, places, arc);
  if constexpr (shape == LightShape::capsule) capsule_places(points, light, places, arc);
  if constexpr (shape == LightShape::rectangle) rectangle_places(points, light, places, arc);
  if constexpr (shape == LightShape::polygon) polygon_places(points, light, places, arc);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
