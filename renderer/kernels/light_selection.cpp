#include "renderer/kernels/light_selection.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/light_selection.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/lanes.h"

#include <hwy/highway.h>
#include <span>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

using Weights = std::span<const ShadingPoints::Floats>;

HWY_INLINE Lanes sum_of_weights(Weights weights, std::size_t i) {
  auto sum = hn::Zero(FloatTag());
  for (const ShadingPoints::Floats& of_light : weights) sum = hn::Add(sum, loaded(of_light, i));
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

HWY_EXPORT(pick);

void LightSelection::pick(std::span<const LightBounds> lights, const ShadingPoints& points,
                          const LightPointBatch::Fractions& at, float a_point) {
  weights_.resize(lights.size());
  first_.assign(1, 0);
  if (lights.empty()) return;
  weigh_lights(lights, points, weights_);
  HWY_DYNAMIC_DISPATCH(pick)(weights_, points.count, at, a_point, *this);
}

}  // namespace asos
#endif
