// The reflection of materials, with one point per lane. Included once for each instruction set.
#if defined(ASOS_KERNELS_MATERIAL_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_MATERIAL_LANES_H
#undef ASOS_KERNELS_MATERIAL_LANES_H
#else
#define ASOS_KERNELS_MATERIAL_LANES_H
#endif

#include "renderer/kernels/lanes.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/lobe_norms.h"
#include "renderer/shading/viewed_point.h"

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

HWY_INLINE LaneMask differ(const Vectors& a, const Vectors& b) {
  return hn::Or(hn::Ne(a.x, b.x), hn::Or(hn::Ne(a.y, b.y), hn::Ne(a.z, b.z)));
}
HWY_INLINE LaneMask finite(Lanes value) {
  return hn::Lt(hn::Abs(value), hn::Inf(FloatTag()));
}

/// As lobe_norms.
struct NormLanes {
  Lanes lobe, fresnel;
};
HWY_INLINE NormLanes lobe_norms(const LobeNormTable& table, Lanes n_dot_v, Lanes roughness) {
  const FloatTag d;
  const hn::RebindToSigned<FloatTag> di;
  constexpr auto last_c = static_cast<float>(LobeNormTable::cosines - 1);
  constexpr auto last_r = static_cast<float>(LobeNormTable::roughnesses - 1);
  const auto zero = hn::Zero(d), one = all_lanes(1.0f);
  const auto c = hn::Mul(hn::Sqrt(clamped(n_dot_v, zero, one)), all_lanes(last_c));
  const auto r = hn::Mul(clamped(roughness, zero, one), all_lanes(last_r));
  // A NaN must not become an array index.
  const auto place = [&](Lanes x, float last) HWY_ATTR {
    return hn::IfThenElseZero(hn::Ge(x, zero), hn::Min(hn::Floor(x), all_lanes(last - 1.0f)));
  };
  const auto column = place(c, last_c), row = place(r, last_r);
  constexpr auto row_length = static_cast<std::int32_t>(LobeNormTable::cosines);
  const auto first =
      hn::Add(hn::Mul(hn::ConvertTo(di, row), hn::Set(di, row_length)), hn::ConvertTo(di, column));
  const auto by_c = hn::Sub(c, column), by_r = hn::Sub(r, row);
  const auto between = [&](const float* values) HWY_ATTR {
    const auto along = [&](std::int32_t offset) HWY_ATTR {
      const auto at = hn::Add(first, hn::Set(di, offset));
      const auto low = hn::GatherIndex(d, values, at);
      const auto high = hn::GatherIndex(d, values, hn::Add(at, hn::Set(di, 1)));
      return hn::Add(low, hn::Mul(hn::Sub(high, low), by_c));
    };
    const auto low = along(0);
    return hn::Add(low, hn::Mul(hn::Sub(along(row_length), low), by_r));
  };
  return {between(table.lobe.data()), between(table.fresnel.data())};
}

HWY_INLINE Lanes environment_specular(const NormLanes& norms, Lanes f0, Lanes f90) {
  const auto all = hn::Add(hn::Mul(f0, norms.lobe), hn::Mul(hn::Sub(f90, f0), norms.fresnel));
  return clamped(all, hn::Zero(FloatTag()), all_lanes(1.0f));
}

/// Stores the material of ShadingPoints except its diffuse part.
HWY_INLINE void store_lobe(const Vectors& f0, Lanes f90, Lanes roughness, ShadingPoints& points,
                           std::size_t i) {
  const auto zero = hn::Zero(FloatTag());
  store(f0, points.f0, i);
  store(Vectors{hn::Sub(f90, f0.x), hn::Sub(f90, f0.y), hn::Sub(f90, f0.z)}, points.f90_less_f0, i);
  const auto floored = clamped(roughness, all_lanes(roughness_floor), all_lanes(1.0f));
  store(hn::Mul(floored, floored), points.alpha, i);
  store(zero, points.shows_lights, i);
  store(zero, points.sheen, i);
  const Vectors none{zero, zero, zero};
  store(none, points.stretch, i);
  // Broad highlights need no patch.
  const auto narrow = hn::Lt(roughness, all_lanes(least_broad_roughness));
  const Vectors right = select(narrow, loaded(points.patch_right, i), none);
  const Vectors down = select(narrow, loaded(points.patch_down, i), none);
  store(right, points.patch_right, i);
  store(down, points.patch_down, i);
  store(hn::IfThenElseZero(narrow, loaded(points.viewer_nearness, i)), points.viewer_nearness, i);
  const auto turns = hn::Or(hn::Or(differ(right, none), differ(down, none)),
                            hn::Or(hn::Ne(loaded(points.spread_variance, i), zero),
                                   hn::Or(differ(loaded(points.spread_right, i), none),
                                          differ(loaded(points.spread_down, i), none))));
  store(hn::IfThenElseZero(turns, all_lanes(1.0f)), points.turns, i);
}

HWY_INLINE Lanes sum_of(const Vectors& v) {
  return hn::Add(hn::Add(v.x, v.y), v.z);
}

/// As mirroring_cosine.
HWY_INLINE Lanes mirroring_cosine(const Vectors& normal, const Vectors& geometric,
                                  const Vectors& to_viewer, Lanes n_dot_v) {
  const auto one = all_lanes(1.0f), two = all_lanes(2.0f), half = all_lanes(0.5f);
  const auto least = all_lanes(least_mirrored_rise);
  const auto cosine = dot(normal, to_viewer), height = dot(to_viewer, geometric);
  const auto rise = hn::Sub(hn::Mul(hn::Mul(two, cosine), dot(normal, geometric)), height);
  const auto bends = hn::And(differ(normal, geometric), hn::Lt(rise, least));
  if (hn::AllFalse(FloatTag(), bends)) return n_dot_v;
  const auto more = hn::Sub(least, rise);
  const auto along =
      hn::Add(hn::Sub(hn::Mul(hn::Mul(two, cosine), cosine), one), hn::Mul(more, height));
  const auto length = hn::Sqrt(hn::Add(one, hn::Mul(more, hn::Add(hn::Mul(two, rise), more))));
  const auto square = hn::Mul(half, hn::Add(one, hn::Div(along, length)));
  const auto bent = hn::Sqrt(hn::Max(hn::Zero(FloatTag()), square));
  return hn::IfThenElse(bends, hn::Max(all_lanes(grazing_cosine), bent), n_dot_v);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
