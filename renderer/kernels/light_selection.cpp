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

HWY_INLINE Lane sum_of_weights(Weights weights, std::size_t i) {
  Lane sum = 0.0f;
  for (const ShadingPoints::Floats& of_light : weights) sum += loaded(of_light, i);
  return sum;
}

/// Returns the weight that one ray represents. Lights above it have one ray each, and the remaining
/// rays are divided by the weights of the remaining lights. An overestimated highlight of one light
/// thus does not reduce the rays of the others.
HWY_INLINE Lane share_of_ray(Weights weights, Lane all, float a_point, std::size_t i) {
  constexpr int rounds = 2;
  auto share = all / a_point;
  auto goes_on = LaneMask::first(Lane::count());
  for (int round = 0; round < rounds; ++round) {
    Lane rest = 0.0f, taken = 0.0f;
    for (const ShadingPoints::Floats& of_light : weights) {
      const auto weight = loaded(of_light, i);
      const auto below = weight < share;
      rest += where(below, weight);
      taken += where(!below, 1.0f);
    }
    goes_on = goes_on && !(taken == 0.0f || rest == 0.0f);
    if (none(goes_on)) break;
    const auto of_rest = rest / max(1.0f, a_point - taken);
    share = selected(goes_on, min(share, of_rest), share);
  }
  return share;
}

/// Walks along the lights of each point and picks one per share of a ray. `walks` is the fraction
/// of a share since the last pick.
void pick(Weights weights, std::size_t points, const LightPointBatch::Fractions& at, float a_point,
          LightSelection& picks) {
  const hn::RebindToUnsigned<FloatTag> du;
  constexpr float least = 1e-30f;
  ShadingPoints::Floats shares, walks;
  for (std::size_t i = 0; i < points; i += Lane::count()) {
    const auto all = sum_of_weights(weights, i);
    const auto some = all > least && LaneMask::first(points - i);
    const auto share = share_of_ray(weights, all, a_point, i);
    // Other points pick nothing.
    store(selected(some, share, infinity), shares, i);
    const auto fraction = hn::ShiftRight<8>(hn::LoadU(du, &at[i]));
    const auto walked =
        Lane(hn::ConvertTo(FloatTag(), hn::BitCast(hn::RebindToSigned<FloatTag>(), fraction))) *
        0x1p-24f;
    store(where(some, walked), walks, i);
  }
  for (const ShadingPoints::Floats& of_light : weights) {
    const LightSelection::Room room = picks.next_light();
    std::size_t next = 0;
    for (std::size_t i = 0; i < points; i += Lane::count()) {
      const auto weight = loaded(of_light, i), share = loaded(shares, i);
      const auto strong = weight >= share;
      const auto probability = weight * (1.0f / share);
      const auto before = loaded(walks, i);
      const auto walked = before + probability;
      const auto passed = walked >= 1.0f && !strong;
      const auto left = selected(passed, walked - 1.0f, walked);
      store(selected(strong, before, left), walks, i);
      const auto picked = (strong || passed) && LaneMask::first(points - i);
      if (none(picked)) continue;
      const auto by = selected(strong, 1.0f, 1.0f / probability);
      by.store_if(picked, room.weight + next);
      const auto number = hn::Add(hn::Iota(du, 0), hn::Set(du, static_cast<std::uint32_t>(i)));
      hn::CompressStore(number, hn::RebindMask(du, picked.raw), du, room.point + next);
      next += count(picked);
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
