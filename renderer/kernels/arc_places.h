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
HWY_INLINE DoubleLane fractions(const std::uint32_t* from) {
  const hn::Rebind<std::int32_t, DoubleTag> di;
  const auto bits = hn::LoadU(di, reinterpret_cast<const std::int32_t*>(from));
  const auto centred = hn::Xor(bits, hn::Set(di, std::numeric_limits<std::int32_t>::min()));
  return DoubleLane(hn::PromoteTo(DoubleTag(), centred)) * (1.0 / 4294967296.0) + 0.5;
}
HWY_INLINE DoubleVectors to_middle(const ShadingPoints& points, std::size_t i, glm::dvec3 middle) {
  return DoubleVectors(middle) - doubles(points.position, i);
}

/// Returns the sine of the angle in 0 to pi whose cosine is c.
HWY_INLINE DoubleLane other_side(DoubleLane c) {
  return sqrt(max(0.0, (1.0 - c) * (1.0 + c)));
}

/// Returns sine and cosine of the sum of two angles.
HWY_INLINE SinCos<DoubleLane> sum(const SinCos<DoubleLane>& a, const SinCos<DoubleLane>& b) {
  return {a.sin * b.cos + a.cos * b.sin, a.cos * b.cos - a.sin * b.sin};
}

/// Clips the interval from `low` to `high` to where the line slope t + rest is positive, unless
/// nothing would be left.
HWY_INLINE void keep_positive(DoubleLane slope, DoubleLane rest, DoubleLane& low,
                              DoubleLane& high) {
  // Most intervals lie on one side of the line's root.
  const auto low_above = slope * low + rest > 0.0;
  const auto high_above = slope * high + rest > 0.0;
  if (none(low_above != high_above)) return;
  const auto end = -(rest / slope);
  const auto within = end > low && end < high;
  const auto rises = slope > 0.0;
  low = selected(within && rises, end, low);
  high = selected(within && !rises, end, high);
}

/// The formulas of SphericalRectangle, with sums of angles as products of unit complex numbers.
/// First: the rectangle's solid angle, 0 where it is sampled by area. Third and fourth: the ends,
/// along half_v, of the part that may be above the point's horizons, measured from the foot of the
/// point's perpendicular.
inline void rectangle_arcs(const ShadingPoints& points, const PreparedLight& light,
                           LightArcs& found) {
  if (found.known) return;
  found.known = true;
  const auto u_length = glm::length(light.half_u);
  const auto v_length = glm::length(light.half_v);
  const glm::dvec3 u_axis = glm::normalize(light.half_u);
  const glm::dvec3 v_axis = glm::normalize(light.half_v);
  const auto x_axis = DoubleVectors(u_axis), y_axis = DoubleVectors(v_axis);
  const auto z_axis = DoubleVectors(glm::cross(u_axis, v_axis));
  const auto towards = DoubleVectors(light.towards);
  const auto thickness = light.thickness;
  for (std::size_t i = 0; i < points.count; i += DoubleLane::count()) {
    const DoubleVectors middle = to_middle(points, i, light.position);
    const auto height = -dot(middle, towards);
    const auto seen = (light.two_sided ? abs(height) : height) > thickness;
    const auto x = dot(middle, x_axis), y = dot(middle, y_axis), z = dot(middle, z_axis);
    auto x0 = x - u_length, x1 = x + u_length;
    auto y0 = y - v_length, y1 = y + v_length;
    for (const ShadingPoints::Vectors* horizon : {&points.geometric, &points.normal}) {
      const DoubleVectors normal = doubles(*horizon, i);
      const auto nx = dot(normal, x_axis), ny = dot(normal, y_axis);
      const auto by_z = z * dot(normal, z_axis);
      keep_positive(ny, by_z + max(x0 * nx, x1 * nx), y0, y1);
      keep_positive(nx, by_z + max(y0 * ny, y1 * ny), x0, x1);
    }
    store_floats(y0, &found.third[i]);
    store_floats(y1, &found.fourth[i]);

    // Compute the z of the unit normals of the planes through the point and a side, and the angles
    // between neighbouring planes.
    const auto z2 = z * z;
    const auto n0 = -(y0 / sqrt(z2 + y0 * y0));
    const auto n1 = x1 / sqrt(z2 + x1 * x1);
    const auto n2 = y1 / sqrt(z2 + y1 * y1);
    const auto n3 = -(x0 / sqrt(z2 + x0 * x0));
    const auto c0 = -(n0 * n1), c1 = -(n1 * n2);
    const auto c2 = -(n2 * n3), c3 = -(n3 * n0);
    const auto first = sum({other_side(c0), c0}, {other_side(c1), c1});
    const auto second = sum({other_side(c2), c2}, {other_side(c3), c3});
    const auto all = sum(first, second);  // the solid angle plus 2 pi
    auto solid_angle = arc_tangent(all.sin, all.cos);
    const auto beyond_half = solid_angle < -1e-12;
    solid_angle = selected(beyond_half, solid_angle + 2.0 * std::numbers::pi, solid_angle);
    // Smaller solid angles have too few digits, and sampling by area is as good at that distance.
    const auto by_angle = seen && solid_angle > 1e-5;
    solid_angle = where(by_angle, solid_angle);
    store_floats(solid_angle, &found.first[i]);
    solid_angle.store(&found.solid_angle[i]);
    (-second.sin).store(&found.sine[i]);
    second.cos.store(&found.cosine[i]);
    n0.store(&found.normal_0[i]);
    n2.store(&found.normal_2[i]);
  }
}

/// Second, for rectangle_arcs: the place along half_u as 1 / (x / z)^2, with the sign of x.
inline void rectangle_places(const ShadingPoints& points, const PreparedLight& light,
                             const LightPointBatch& places, LightArcs& found) {
  rectangle_arcs(points, light, found);
  for (std::size_t i = 0; i < points.count; i += DoubleLane::count()) {
    const auto solid_angle = DoubleLane::loaded(&found.solid_angle[i]);
    if (none(solid_angle > 0.0)) continue;
    const auto n0 = DoubleLane::loaded(&found.normal_0[i]),
               n2 = DoubleLane::loaded(&found.normal_2[i]);
    const auto u = fractions(&places.u[i]);
    const auto turn = sin_cos(u * solid_angle);
    const auto angle =
        sum(turn, {DoubleLane::loaded(&found.sine[i]), DoubleLane::loaded(&found.cosine[i])});
    const auto quotient = (angle.cos * n0 - n2) / angle.sin;
    // At the end of a rectangle that fills half of all directions, the quotient would be 0 / 0.
    const auto at_end = where(u < 0.5, -0.0);
    const auto f = selected(angle.sin == 0.0, at_end, quotient);
    const auto slope2 = f * f - (1.0 - n0) * (1.0 + n0);
    store_floats(copysign(max(slope2, 1e-30), f), &found.second[i]);
  }
}

/// Samples by the angle at the point (Kulla and Fajardo 2012, "equi-angular"). First: the place
/// along the segment from the foot of the point's perpendicular. Second: the measure ds / du there.
/// Third: the perpendicular's length.
inline void segment_places(const ShadingPoints& points, const PreparedLight& light,
                           const LightPointBatch& places, LightArcs& found) {
  const double half = glm::length(light.half_u);
  const auto length = 2.0 * half;
  const auto along = DoubleVectors(light.half_u / half);
  for (std::size_t i = 0; i < points.count; i += DoubleLane::count()) {
    const DoubleVectors middle = to_middle(points, i, light.position);
    const auto ahead = dot(middle, along);
    const auto s0 = ahead - half;
    const auto s1 = s0 + length;
    const DoubleVectors foot = middle - ahead * along;
    const auto height2 = dot(foot, foot);
    const auto height = sqrt(height2);
    const auto angle = arc_tangent(height * length, height2 + s0 * s1);
    const auto u = fractions(&places.u[i]);
    const auto turn = sin_cos(u * angle);
    // The place is tan(atan(s0 / height) + u angle) height.
    const auto up = s0 * turn.cos + height * turn.sin;
    const auto over = height * turn.cos - s0 * turn.sin;
    const auto turned = clamp(height * (up / over), s0, s1);
    const auto wide = angle > 1e-4;
    const auto s = selected(wide, turned, s0 + length * u);
    // A line contributes nothing to a point on it.
    const auto apart = height > 0.0;
    const auto by_angle = where(apart, angle / height * (height2 + s * s));
    store_floats(s, &found.first[i]);
    store_floats(selected(wide, by_angle, length), &found.second[i]);
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
