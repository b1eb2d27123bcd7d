#include "renderer/kernels/light_selection.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/light_selection.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/weight_lanes.h"
#include "renderer/shading/lobe.h"

#include <algorithm>
#include <hwy/highway.h>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

/// Returns alpha^2 of the lobes of points from i on, as for weigh_lights.
HWY_INLINE Lanes alpha2_of_lanes(const ShadingPoints& points, std::size_t i) {
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const auto alpha2 = square(loaded(points.alpha, i));
  const auto turns = hn::Ne(loaded(points.turns, i), zero);
  if (hn::AllFalse(FloatTag(), turns)) return hn::Min(one, alpha2);
  const auto square_of = [&](const ShadingPoints::Vectors& v) HWY_ATTR {
    const Vectors at = loaded(v, i);
    return dot(at, at);
  };
  const auto both = hn::Add(square_of(points.spread_right), square_of(points.spread_down));
  const auto by_normals =
      hn::Add(hn::Div(both, all_lanes(24.0f)), loaded(points.spread_variance, i));
  const auto added = hn::Add(hn::Add(alpha2, hn::Min(by_normals, all_lanes(PatchLobe::most_added))),
                             hn::Mul(all_lanes(0.5f), square_of(points.stretch)));
  const auto sheen = hn::Gt(loaded(points.sheen, i), zero);
  return hn::Min(one, hn::IfThenElse(turns, hn::IfThenElse(sheen, one, added), alpha2));
}

void weigh_batch(const LightTable& lights, const ShadingPoints& points,
                 ShadingPoints::Floats* weights) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    PointLanes at;
    at.position = loaded(points.position, i);
    at.geometric = loaded(points.geometric, i);
    at.normal = loaded(points.normal, i);
    at.to_viewer = loaded(points.to_viewer, i);
    at.diffuse = loaded(points.diffuse, i);
    at.f0 = loaded(points.f0, i);
    at.f90_less_f0 = loaded(points.f90_less_f0, i);
    at.falloff = loaded(points.falloff, i);
    at.n_dot_v = loaded(points.n_dot_v, i);
    at.alpha2 = alpha2_of_lanes(points, i);
    at.shows_lights = loaded(points.shows_lights, i);
    set_tangents(at);
    const Vectors most = at.f0 + at.f90_less_f0;
    const auto shines =
        hn::Or(hn::Or(hn::Ne(most.x, zero), hn::Ne(most.y, zero)), hn::Ne(most.z, zero));
    for (std::size_t k = 0; k < lights.size(); ++k)
      store(weight(OneLight{lights, k}, at, shines), weights[k], i);
  }
}

/// Adds up the weights of points from i on as weigh_lights does: in LightTable::step partial sums.
using Weights = std::span<const ShadingPoints::Floats>;

HWY_INLINE Lanes sum_of_weights(Weights weights, std::size_t i) {
  const std::size_t lights = weights.size();
  const FloatTag d;
  auto sum = hn::Zero(d);
  for (std::size_t j = 0; j < std::min(lights, LightTable::step); ++j) {
    auto part = hn::Zero(d);
    for (std::size_t k = j; k < lights; k += LightTable::step)
      part = hn::Add(part, loaded(weights[k], i));
    sum = hn::Add(sum, part);
  }
  return sum;
}

/// Returns the weight that one ray represents. Lights above it have one ray each, and the remaining
/// rays are divided by the weights of the remaining lights. An overestimated highlight of one light
/// thus does not reduce the rays of the others.
HWY_INLINE Lanes share_of_ray(Weights weights, Lanes all, float a_point, std::size_t i) {
  const FloatTag d;
  const auto zero = hn::Zero(d), one = all_lanes(1.0f);
  constexpr int rounds = 2;
  auto share = hn::Div(all, all_lanes(a_point));
  auto goes_on = hn::FirstN(d, hn::Lanes(d));
  for (int round = 0; round < rounds; ++round) {
    auto rest = zero, taken = zero;
    for (const ShadingPoints::Floats& of_light : weights) {
      const auto weight = loaded(of_light, i);
      const auto below = hn::Lt(weight, share);
      rest = hn::Add(rest, hn::IfThenElseZero(below, weight));
      taken = hn::Add(taken, hn::IfThenZeroElse(below, one));
    }
    goes_on = hn::AndNot(hn::Or(hn::Eq(taken, zero), hn::Eq(rest, zero)), goes_on);
    if (hn::AllFalse(d, goes_on)) break;
    const auto of_rest = hn::Div(rest, hn::Max(one, hn::Sub(all_lanes(a_point), taken)));
    share = hn::IfThenElse(goes_on, hn::Min(share, of_rest), share);
  }
  return share;
}

/// Walks along the lights of each point and picks one per share of a ray. `walks` is the fraction
/// of a share since the last pick.
void pick(Weights weights, std::size_t points, const LightPointBatch::Fractions& at, float a_point,
          LightSelection& picks) {
  const FloatTag d;
  const hn::RebindToUnsigned<FloatTag> du;
  constexpr float least = 1e-30f;
  ShadingPoints::Floats shares, walks;
  for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
    const auto all = sum_of_weights(weights, i);
    const auto some = hn::And(hn::Gt(all, all_lanes(least)), hn::FirstN(d, points - i));
    const auto share = share_of_ray(weights, all, a_point, i);
    // Other points pick nothing.
    store(hn::IfThenElse(some, share, hn::Inf(d)), shares, i);
    const auto fraction = hn::ShiftRight<8>(hn::LoadU(du, &at[i]));
    const auto walked =
        hn::Mul(hn::ConvertTo(d, hn::BitCast(hn::RebindToSigned<FloatTag>(), fraction)),
                all_lanes(0x1p-24f));
    store(hn::IfThenElseZero(some, walked), walks, i);
  }
  const auto one = all_lanes(1.0f);
  for (const ShadingPoints::Floats& of_light : weights) {
    const LightSelection::Room room = picks.next_light();
    std::size_t next = 0;
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
      const auto weight = loaded(of_light, i), share = loaded(shares, i);
      const auto strong = hn::Ge(weight, share);
      const auto probability = hn::Mul(weight, hn::Div(one, share));
      const auto before = loaded(walks, i);
      const auto walked = hn::Add(before, probability);
      const auto passed = hn::AndNot(strong, hn::Ge(walked, one));
      const auto left = hn::IfThenElse(passed, hn::Sub(walked, one), walked);
      store(hn::IfThenElse(strong, before, left), walks, i);
      const auto picked = hn::And(hn::Or(strong, passed), hn::FirstN(d, points - i));
      if (hn::AllFalse(d, picked)) continue;
      const auto by = hn::IfThenElse(strong, one, hn::Div(one, probability));
      hn::CompressStore(by, picked, d, room.weight + next);
      const auto number = hn::Add(hn::Iota(du, 0), hn::Set(du, static_cast<std::uint32_t>(i)));
      hn::CompressStore(number, hn::RebindMask(du, picked), du, room.point + next);
      next += hn::CountTrue(d, picked);
    }
    picks.picked(next);
  }
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(weigh_batch);
HWY_EXPORT(pick);

void LightSelection::pick(const LightTable& lights, const ShadingPoints& points,
                          const LightPointBatch::Fractions& at, float a_point) {
  weights_.resize(lights.size());
  first_.assign(1, 0);
  if (lights.size() == 0) return;
  HWY_DYNAMIC_DISPATCH(weigh_batch)(lights, points, weights_.data());
  HWY_DYNAMIC_DISPATCH(pick)({weights_.data(), weights_.size()}, points.count, at, a_point, *this);
}

}  // namespace asos
#endif
