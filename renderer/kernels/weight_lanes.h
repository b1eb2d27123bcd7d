// Estimates of lights at points, for lanes of either. Included once for each instruction set.
#if defined(ASOS_KERNELS_WEIGHT_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_WEIGHT_LANES_H
#undef ASOS_KERNELS_WEIGHT_LANES_H
#else
#define ASOS_KERNELS_WEIGHT_LANES_H
#endif

#include "renderer/kernels/lane.h"
#include "renderer/kernels/light_table.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/viewed_point.h"

#include <cstddef>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

using Field = LightTable::Field;

/// A light in each lane: those from number k on.
struct LightLanes {
  const LightTable& table;
  std::size_t k;

  [[nodiscard]] HWY_INLINE Lanes operator[](std::size_t field) const {
    return hn::LoadU(FloatTag(), table.of(static_cast<Field>(field)) + k);
  }
};
/// One light, the same in all lanes.
struct OneLight {
  const LightTable& table;
  std::size_t k;

  [[nodiscard]] HWY_INLINE Lanes operator[](std::size_t field) const {
    return all_lanes(table.of(static_cast<Field>(field))[k]);
  }
};
template <class Light>
HWY_INLINE Vectors fields(const Light& light, Field first) {
  return {light[first], light[first + 1u], light[first + 2u]};
}
HWY_INLINE Lanes square(Lanes x) {
  return hn::Mul(x, x);
}

/// One point in all lanes, or a point in each.
struct PointLanes {
  Vectors position, geometric, normal, to_viewer;
  Vectors tangent, bitangent;  ///< about the normal
  Vectors diffuse, f0, f90_less_f0;
  Lanes falloff, n_dot_v, alpha2, shows_lights;
};

/// Returns the cosine to the centre of a light, or to the centre of its part above the horizon.
/// `reach` is the light's extent along the normal at a distance of 1. The result is above 0 unless
/// the whole light is below the horizon.
HWY_INLINE Lanes cosine_above(Lanes cosine, Lanes reach) {
  const auto cut = hn::Mul(all_lanes(0.5f), hn::Add(cosine, reach));
  return hn::Max(hn::Zero(FloatTag()), hn::Max(cosine, cut));
}

/// Returns how far a light extends from its centre along a direction.
template <class Light>
HWY_INLINE Lanes reach_along(const Light& light, const Vectors& direction) {
  using enum LightTable::Field;
  const auto u = dot(direction, fields(light, half_u_x));
  const auto v = dot(direction, fields(light, half_v_x));
  return hn::Add(light[round], hn::Add(hn::Abs(u), hn::Abs(v)));
}
/// Extents of a light along a point's normals.
struct ReachLanes {
  Lanes normal, geometric;
};

/// How the half vector turns, in the tangent plane, from the light's centre to the end of one of
/// its half edges.
struct TurnLanes {
  Lanes x, y;
};
HWY_INLINE TurnLanes turn_to_end(const PointLanes& at, const Vectors& direction, Lanes per_sum,
                                 const Vectors& half_edge) {
  const Vectors across = half_edge - scaled(dot(direction, half_edge), direction);
  return {hn::Mul(per_sum, dot(at.tangent, across)), hn::Mul(per_sum, dot(at.bitangent, across))};
}

/// Direction and irradiance of a light at a point, or of the part of the light around its nearest
/// point.
struct SeenLanes {
  Vectors direction;  ///< to its centre
  Lanes nearness;
  Lanes n_dot_l;
  Lanes form;  ///< irradiance for a power of 1
};

/// Returns direction and irradiance of a light at `offset`, with the extent `size` and this reach.
/// The power times `size` is its intensity. `by_distance`: as LightTable::near_linear.
template <class Light>
HWY_INLINE SeenLanes seen(const Light& light, const PointLanes& at, const Vectors& offset,
                          Lanes size, const ReachLanes& reach, Lanes by_distance) {
  using enum LightTable::Field;
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const Vectors towards = fields(light, towards_x);
  const auto is_far = hn::Gt(light[far], zero);
  const auto distance2 = dot(offset, offset);
  const auto distance = hn::Sqrt(distance2);
  const auto nearness = hn::Div(one, hn::Max(distance, all_lanes(1e-30f)));
  SeenLanes at_light;
  at_light.nearness = hn::IfThenElse(is_far, one, nearness);
  at_light.direction = select(is_far, towards, scaled(nearness, offset));
  // An extent beyond twice the distance has no further effect.
  const auto seen_reach = [&](Lanes along) {
    return hn::Min(all_lanes(2.0f), hn::Mul(along, at_light.nearness));
  };
  const auto up = dot(at_light.direction, at.geometric);
  const auto above = hn::Gt(hn::Add(up, seen_reach(reach.geometric)), zero);
  const auto cosine = dot(at_light.direction, at.normal);
  at_light.n_dot_l = cosine_above(cosine, seen_reach(reach.normal));

  const auto axis = dot(at_light.direction, towards);
  const auto both = hn::Gt(light[two_sided], zero);
  const auto leaves = hn::IfThenElse(both, hn::Abs(axis), hn::Max(zero, hn::Neg(axis)));
  const auto by_face = hn::IfThenElse(hn::Gt(light[flat], zero), leaves, one);
  auto left = one;
  if (light.table.attenuates()) {
    const auto cone =
        clamped(hn::Add(hn::Mul(axis, light[cone_scale]), light[cone_offset]), zero, one);
    const auto r2 = square(hn::Min(one, hn::Mul(distance, light[inverse_range])));
    left = hn::Mul(square(cone), hn::Sub(one, square(r2)));
  }
  const auto fall = hn::Max(
      hn::Add(distance2, hn::Add(hn::Mul(distance, by_distance), hn::Mul(size, light[near_size]))),
      light[least]);
  const auto by_place = hn::IfThenElse(is_far, one, hn::Div(left, fall));
  const auto form = hn::Mul(hn::Mul(size, by_place), hn::Mul(at_light.n_dot_l, by_face));
  at_light.form = hn::IfThenElseZero(above, form);
  // Bend the direction towards the part above the horizon.
  at_light.direction = at_light.direction + scaled(hn::Sub(at_light.n_dot_l, cosine), at.normal);
  return at_light;
}

/// Returns the vector from the point to the nearest point of a light with edges.
template <class Light>
HWY_INLINE Vectors to_nearest(const Light& light, const Vectors& offset) {
  using enum LightTable::Field;
  const auto one = all_lanes(1.0f);
  const Vectors u = fields(light, half_u_x), v = fields(light, half_v_x);
  const auto along = [&](const Vectors& half, LightTable::Field per_square) {
    return clamped(hn::Neg(hn::Mul(dot(offset, half), light[per_square])), hn::Neg(one), one);
  };
  return offset + (scaled(along(u, per_u2), u) + scaled(along(v, per_v2), v));
}

/// The highlight: the lobe in the direction of the light's centre, widened by the light's spread of
/// half vectors.
struct EstimatedShine {
  Lanes lobe, fresnel;
};
template <class Light>
HWY_INLINE EstimatedShine shine(const Light& light, const PointLanes& at, const SeenLanes& seen) {
  using enum LightTable::Field;
  const auto one = all_lanes(1.0f);
  const Vectors sum = seen.direction + at.to_viewer;
  const auto length = hn::Sqrt(hn::Max(dot(sum, sum), all_lanes(1e-12f)));
  const auto per_sum = hn::Div(one, length);
  const auto spread = hn::Mul(seen.nearness, per_sum);
  const auto round2 = square(hn::Mul(light[round], spread));
  const auto u = turn_to_end(at, seen.direction, spread, fields(light, half_u_x));
  const auto v = turn_to_end(at, seen.direction, spread, fields(light, half_v_x));
  const auto by_edges_x = hn::Add(square(u.x), square(v.x));
  const auto by_edges_y = hn::Add(square(u.y), square(v.y));
  // No lobe is broader than a uniform one.
  const auto added = hn::Add(hn::Add(round2, round2), hn::Add(by_edges_x, by_edges_y));
  const auto part = hn::Div(one, hn::Max(one, added));
  const auto xx = hn::Add(at.alpha2, hn::Mul(part, hn::Add(round2, by_edges_x)));
  const auto yy = hn::Add(at.alpha2, hn::Mul(part, hn::Add(round2, by_edges_y)));
  const auto xy = hn::Mul(part, hn::Add(hn::Mul(u.x, u.y), hn::Mul(v.x, v.y)));
  const GgxSlopes<Lane> slopes{xx, xy, yy};
  const Lane det = max(slopes.determinant(), Lane(square(at.alpha2)));

  const auto hx = hn::Mul(per_sum, dot(at.tangent, sum));
  const auto hy = hn::Mul(per_sum, dot(at.bitangent, sum));
  const auto up = hn::Mul(per_sum, dot(at.normal, sum));
  const Lane alpha = min(Lane(1), sqrt(sqrt(det)));
  const Lane nl = hn::Max(seen.n_dot_l, all_lanes(grazing_cosine)), nv = at.n_dot_v;
  return {ggx_over(GgxSlopes<Lane>::alpha2(det), slopes.stretched(hx, hy, up, det),
                   smith_without_roots(nl, nv, alpha)),
          schlick_weight<Lane>(hn::Mul(all_lanes(0.5f), length))};
}

/// `shines`: the points with highlights.
template <class Light>
HWY_INLINE Lanes weight(const Light& light, const PointLanes& at, const LaneMask& shines) {
  using enum LightTable::Field;
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const Vectors offset = fields(light, position_x) - at.position;
  const auto across = light[radius], all = light[extent];
  const ReachLanes reach{reach_along(light, at.normal), reach_along(light, at.geometric)};
  const SeenLanes middle = seen(light, at, offset, all, reach, light[near_linear]);
  auto form = middle.form;
  // The nearest part of a light with a large angular extent may contribute more than the light's
  // centre.
  const auto has_edges = hn::Gt(light[per_u2], zero);
  const auto large = hn::Gt(hn::Mul(across, middle.nearness), all_lanes(0.25f));
  if (const auto near = hn::And(has_edges, large); !hn::AllFalse(FloatTag(), near)) {
    const Vectors nearest = to_nearest(light, offset);
    const auto distance2 = dot(nearest, nearest);
    const auto distance = hn::Sqrt(distance2);
    const auto part = hn::Min(all, hn::Add(hn::Mul(light[part_linear], distance),
                                           hn::Mul(light[part_square], distance2)));
    const ReachLanes of_near{hn::Min(reach.normal, distance), hn::Min(reach.geometric, distance)};
    const auto of_part = seen(light, at, nearest, part, of_near, zero).form;
    form = hn::IfThenElse(near, hn::Max(form, of_part), form);
  }

  if (hn::AllFalse(FloatTag(), hn::Gt(form, zero))) return zero;
  const Vectors power = fields(light, power_x);
  Vectors carried{hn::Mul(power.x, at.diffuse.x), hn::Mul(power.y, at.diffuse.y),
                  hn::Mul(power.z, at.diffuse.z)};
  if (!hn::AllFalse(FloatTag(), shines)) {
    const EstimatedShine shown = shine(light, at, middle);
    const auto mirrors = hn::Lt(at.shows_lights, light[shown_from]);
    const auto lobe = hn::IfThenElseZero(mirrors, shown.lobe);
    const auto scatters = hn::Sub(one, hn::Mul(at.falloff, shown.fresnel));
    const auto channel = [&](Lanes by, Lanes scattered, Lanes f0, Lanes rest) {
      const auto f = hn::Add(f0, hn::Mul(rest, shown.fresnel));
      return hn::Mul(by, hn::Add(hn::Mul(scattered, scatters), hn::Mul(f, lobe)));
    };
    const Vectors both{channel(power.x, at.diffuse.x, at.f0.x, at.f90_less_f0.x),
                       channel(power.y, at.diffuse.y, at.f0.y, at.f90_less_f0.y),
                       channel(power.z, at.diffuse.z, at.f0.z, at.f90_less_f0.z)};
    carried = select(shines, both, carried);
  }
  const auto most = hn::Mul(form, hn::Max(hn::Max(carried.x, carried.y), carried.z));
  // The comparison is false for NaN.
  return hn::IfThenElseZero(hn::Gt(most, zero), hn::Min(most, all_lanes(1e30f)));
}

/// Sets the axes about the normal.
HWY_INLINE void set_tangents(PointLanes& at) {
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const auto along_x = hn::Lt(hn::Abs(at.normal.x), all_lanes(0.6f));
  const Vectors other = select(along_x, Vectors{one, zero, zero}, Vectors{zero, one, zero});
  const Vectors across = cross(at.normal, other);
  at.tangent = scaled(hn::Div(one, hn::Sqrt(dot(across, across))), across);
  at.bitangent = cross(at.normal, at.tangent);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
