#include "renderer/kernels/weigh_lights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/weigh_lights.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/lanes.h"
#include "renderer/shading/lobe.h"
#include "renderer/shading/viewed_point.h"

#include <algorithm>
#include <cmath>
#include <hwy/highway.h>
#include <limits>
#include <numbers>
#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

HWY_INLINE Lanes field(const LightTable& lights, LightTable::Field field, std::size_t k) {
  return hn::LoadU(FloatTag(), lights.of(field) + k);
}
HWY_INLINE Vectors fields(const LightTable& lights, LightTable::Field first, std::size_t k) {
  const auto next = [&](std::size_t i) {
    return field(lights, static_cast<LightTable::Field>(first + i), k);
  };
  return {next(0), next(1), next(2)};
}
HWY_INLINE Lanes square(Lanes x) {
  return hn::Mul(x, x);
}

/// One point, the same in all lanes, for a light in each lane.
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
HWY_INLINE Lanes reach_along(const LightTable& lights, const Vectors& direction, std::size_t k) {
  using enum LightTable::Field;
  const auto u = dot(direction, fields(lights, half_u_x, k));
  const auto v = dot(direction, fields(lights, half_v_x, k));
  return hn::Add(field(lights, round, k), hn::Add(hn::Abs(u), hn::Abs(v)));
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
HWY_INLINE SeenLanes seen(const LightTable& lights, const PointLanes& at, const Vectors& offset,
                          Lanes size, const ReachLanes& reach, Lanes by_distance, std::size_t k) {
  using enum LightTable::Field;
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const Vectors towards = fields(lights, towards_x, k);
  const auto is_far = hn::Gt(field(lights, far, k), zero);
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
  const auto both = hn::Gt(field(lights, two_sided, k), zero);
  const auto leaves = hn::IfThenElse(both, hn::Abs(axis), hn::Max(zero, hn::Neg(axis)));
  const auto by_face = hn::IfThenElse(hn::Gt(field(lights, flat, k), zero), leaves, one);
  auto left = one;
  if (lights.attenuates()) {
    const auto cone =
        clamped(hn::Add(hn::Mul(axis, field(lights, cone_scale, k)), field(lights, cone_offset, k)),
                zero, one);
    const auto r2 = square(hn::Min(one, hn::Mul(distance, field(lights, inverse_range, k))));
    left = hn::Mul(square(cone), hn::Sub(one, square(r2)));
  }
  const auto fall = hn::Max(hn::Add(distance2, hn::Add(hn::Mul(distance, by_distance),
                                                       hn::Mul(size, field(lights, near_size, k)))),
                            field(lights, least, k));
  const auto by_place = hn::IfThenElse(is_far, one, hn::Div(left, fall));
  const auto form = hn::Mul(hn::Mul(size, by_place), hn::Mul(at_light.n_dot_l, by_face));
  at_light.form = hn::IfThenElseZero(above, form);
  // Bend the direction towards the part above the horizon.
  at_light.direction = at_light.direction + scaled(hn::Sub(at_light.n_dot_l, cosine), at.normal);
  return at_light;
}

/// Returns the vector from the point to the nearest point of a light with edges.
HWY_INLINE Vectors to_nearest(const LightTable& lights, const Vectors& offset, std::size_t k) {
  using enum LightTable::Field;
  const auto one = all_lanes(1.0f);
  const Vectors u = fields(lights, half_u_x, k), v = fields(lights, half_v_x, k);
  const auto along = [&](const Vectors& half, LightTable::Field per_square) {
    return clamped(hn::Neg(hn::Mul(dot(offset, half), field(lights, per_square, k))), hn::Neg(one),
                   one);
  };
  return offset + (scaled(along(u, per_u2), u) + scaled(along(v, per_v2), v));
}

/// The highlight: the lobe in the direction of the light's centre, widened by the light's spread of
/// half vectors.
struct ShineLanes {
  Lanes lobe, fresnel;
};
HWY_INLINE ShineLanes shine(const LightTable& lights, const PointLanes& at, const SeenLanes& seen,
                            std::size_t k) {
  using enum LightTable::Field;
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const Vectors sum = seen.direction + at.to_viewer;
  const auto length = hn::Sqrt(hn::Max(dot(sum, sum), all_lanes(1e-12f)));
  const auto per_sum = hn::Div(one, length);
  const auto spread = hn::Mul(seen.nearness, per_sum);
  const auto round2 = square(hn::Mul(field(lights, round, k), spread));
  const auto u = turn_to_end(at, seen.direction, spread, fields(lights, half_u_x, k));
  const auto v = turn_to_end(at, seen.direction, spread, fields(lights, half_v_x, k));
  const auto by_edges_x = hn::Add(square(u.x), square(v.x));
  const auto by_edges_y = hn::Add(square(u.y), square(v.y));
  // No lobe is broader than a uniform one.
  const auto added = hn::Add(hn::Add(round2, round2), hn::Add(by_edges_x, by_edges_y));
  const auto part = hn::Div(one, hn::Max(one, added));
  const auto xx = hn::Add(at.alpha2, hn::Mul(part, hn::Add(round2, by_edges_x)));
  const auto yy = hn::Add(at.alpha2, hn::Mul(part, hn::Add(round2, by_edges_y)));
  const auto xy = hn::Mul(part, hn::Add(hn::Mul(u.x, u.y), hn::Mul(v.x, v.y)));
  const auto det = hn::Max(hn::Sub(hn::Mul(xx, yy), square(xy)), square(at.alpha2));

  const auto hx = hn::Mul(per_sum, dot(at.tangent, sum));
  const auto hy = hn::Mul(per_sum, dot(at.bitangent, sum));
  const auto up = hn::Mul(per_sum, dot(at.normal, sum));
  // 1 / (2 pi root d^2 shadowing) with d = slopes / det + up^2, by one quotient.
  const auto both = hn::Mul(hn::Mul(hn::Add(xy, xy), hx), hy);
  const auto slopes = hn::Add(hn::Sub(hn::Mul(yy, square(hx)), both), hn::Mul(xx, square(hy)));
  const auto d = hn::Add(slopes, hn::Mul(square(up), det));
  const auto root = hn::Sqrt(det);
  // Smith's shadowing without its roots (Hammon 2017).
  const auto alpha = hn::Min(one, hn::Sqrt(root)), left = hn::Sub(one, alpha);
  const auto nl = hn::Max(seen.n_dot_l, all_lanes(grazing_cosine)), nv = at.n_dot_v;
  const auto shadowing =
      hn::Add(hn::Mul(hn::Mul(hn::Add(nl, nl), nv), left), hn::Mul(hn::Add(nl, nv), alpha));
  const auto lobe =
      hn::Div(hn::Mul(all_lanes(0.5f * std::numbers::inv_pi_v<float>), hn::Mul(root, det)),
              hn::Mul(square(d), shadowing));
  const auto m = clamped(hn::Sub(one, hn::Mul(all_lanes(0.5f), length)), zero, one);
  return {lobe, hn::Mul(square(square(m)), m)};
}

template <bool shiny>
HWY_INLINE Lanes weight(const LightTable& lights, const PointLanes& at, std::size_t k) {
  using enum LightTable::Field;
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const Vectors offset = fields(lights, position_x, k) - at.position;
  const auto across = field(lights, radius, k), all = field(lights, extent, k);
  const ReachLanes reach{reach_along(lights, at.normal, k), reach_along(lights, at.geometric, k)};
  const SeenLanes middle = seen(lights, at, offset, all, reach, field(lights, near_linear, k), k);
  auto form = middle.form;
  // The nearest part of a light with a large angular extent may contribute more than the light's
  // centre.
  const auto has_edges = hn::Gt(field(lights, per_u2, k), zero);
  const auto large = hn::Gt(hn::Mul(across, middle.nearness), all_lanes(0.25f));
  if (const auto near = hn::And(has_edges, large); !hn::AllFalse(FloatTag(), near)) {
    const Vectors nearest = to_nearest(lights, offset, k);
    const auto distance2 = dot(nearest, nearest);
    const auto distance = hn::Sqrt(distance2);
    const auto part = hn::Min(all, hn::Add(hn::Mul(field(lights, part_linear, k), distance),
                                           hn::Mul(field(lights, part_square, k), distance2)));
    const ReachLanes of_near{hn::Min(reach.normal, distance), hn::Min(reach.geometric, distance)};
    const auto of_part = seen(lights, at, nearest, part, of_near, zero, k).form;
    form = hn::IfThenElse(near, hn::Max(form, of_part), form);
  }

  if (hn::AllFalse(FloatTag(), hn::Gt(form, zero))) return zero;
  const Vectors power = fields(lights, power_x, k);
  Vectors carried{hn::Mul(power.x, at.diffuse.x), hn::Mul(power.y, at.diffuse.y),
                  hn::Mul(power.z, at.diffuse.z)};
  if constexpr (shiny) {
    const ShineLanes shown = shine(lights, at, middle, k);
    const auto mirrors = hn::Lt(at.shows_lights, field(lights, shown_from, k));
    const auto lobe = hn::IfThenElseZero(mirrors, shown.lobe);
    const auto scatters = hn::Sub(one, hn::Mul(at.falloff, shown.fresnel));
    const auto channel = [&](Lanes by, Lanes scattered, Lanes f0, Lanes rest) {
      const auto f = hn::Add(f0, hn::Mul(rest, shown.fresnel));
      return hn::Mul(by, hn::Add(hn::Mul(scattered, scatters), hn::Mul(f, lobe)));
    };
    carried = {channel(power.x, at.diffuse.x, at.f0.x, at.f90_less_f0.x),
               channel(power.y, at.diffuse.y, at.f0.y, at.f90_less_f0.y),
               channel(power.z, at.diffuse.z, at.f0.z, at.f90_less_f0.z)};
  }
  const auto most = hn::Mul(form, hn::Max(hn::Max(carried.x, carried.y), carried.z));
  // The comparison is false for NaN.
  return hn::IfThenElseZero(hn::Gt(most, zero), hn::Min(most, all_lanes(1e30f)));
}

template <bool shiny>
void weigh_all(const LightTable& lights, const PointLanes& at, float* weights) {
  for (std::size_t k = 0; k < lights.padded_size(); k += hn::Lanes(FloatTag()))
    hn::StoreU(weight<shiny>(lights, at, k), FloatTag(), weights + k);
}

/// Returns alpha^2 of the point's lobe, or of an isotropic lobe about as wide as the patch's lobe.
float alpha2_of(const ShadingPoints& points, std::size_t i) {
  const float alpha = points.alpha[i];
  if (points.turns[i] == 0.0f) return alpha * alpha;
  if (points.sheen[i] > 0.0f) return 1.0f;
  const auto square_of = [&](const ShadingPoints::Vectors& v) {
    return glm::dot(v.at(i), v.at(i));
  };
  const float by_normals =
      (square_of(points.spread_right) + square_of(points.spread_down)) / 24.0f +
      points.spread_variance[i];
  const float by_stretch = 0.5f * square_of(points.stretch);
  return alpha * alpha + std::min(by_normals, PatchLobe::most_added) + by_stretch;
}

void weigh(const LightTable& lights, const ShadingPoints& points, std::size_t i, float* weights) {
  PointLanes at;
  at.position = all_lanes(points.position.at(i));
  at.geometric = all_lanes(points.geometric.at(i));
  at.normal = all_lanes(points.normal.at(i));
  at.to_viewer = all_lanes(points.to_viewer.at(i));
  at.diffuse = all_lanes(points.diffuse.at(i));
  at.f0 = all_lanes(points.f0.at(i));
  at.f90_less_f0 = all_lanes(points.f90_less_f0.at(i));
  at.falloff = all_lanes(points.falloff[i]);
  at.n_dot_v = all_lanes(points.n_dot_v[i]);
  at.alpha2 = all_lanes(std::min(1.0f, alpha2_of(points, i)));
  const glm::vec3 n = points.normal.at(i);
  const glm::vec3 other = std::abs(n.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 tangent = glm::normalize(glm::cross(n, other));
  at.tangent = all_lanes(tangent);
  at.bitangent = all_lanes(glm::cross(n, tangent));
  at.shows_lights = all_lanes(points.shows_lights[i]);
  const glm::vec3 most = points.f0.at(i) + points.f90_less_f0.at(i);
  if (most == glm::vec3(0.0f)) {
    weigh_all<false>(lights, at, weights);
  } else {
    weigh_all<true>(lights, at, weights);
  }
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(weigh);

float weigh_lights(const LightTable& lights, const ShadingPoints& points, std::size_t i,
                   std::span<float> weights) {
  HWY_DYNAMIC_DISPATCH(weigh)(lights, points, i, weights.data());
  // Add up sixteen partial sums, independent of the number of lanes.
  std::array<float, LightTable::step> sums{};
  for (std::size_t k = 0; k < lights.padded_size(); k += sums.size())
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += weights[k + j];
  return std::accumulate(sums.begin(), sums.end(), 0.0f);
}

}  // namespace asos
#endif
