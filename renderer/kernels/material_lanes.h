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
  return a.x != b.x || a.y != b.y || a.z != b.z;
}
HWY_INLINE LaneMask finite(Lane value) {
  return abs(value) < infinity;
}

/// As lobe_norms.
struct NormLanes {
  Lane lobe, fresnel;
};
HWY_INLINE NormLanes lobe_norms(const LobeNormTable& table, Lane n_dot_v, Lane roughness) {
  const hn::RebindToSigned<FloatTag> di;
  constexpr auto last_c = static_cast<float>(LobeNormTable::cosines - 1);
  constexpr auto last_r = static_cast<float>(LobeNormTable::roughnesses - 1);

  const auto c = sqrt(clamp(n_dot_v, 0.0f, 1.0f)) * last_c;
  const auto r = clamp(roughness, 0.0f, 1.0f) * last_r;
  // A NaN must not become an array index.
  const auto place = [&](Lane x, float last)
                         HWY_ATTR { return where(x >= 0.0f, min(floor(x), last - 1.0f)); };
  const auto column = place(c, last_c), row = place(r, last_r);
  constexpr auto row_length = static_cast<std::int32_t>(LobeNormTable::cosines);
  const auto first = hn::Add(hn::Mul(hn::ConvertTo(di, row.raw), hn::Set(di, row_length)),
                             hn::ConvertTo(di, column.raw));
  const auto by_c = c - column, by_r = r - row;
  const auto between = [&](const float* values) HWY_ATTR {
    const auto along = [&](std::int32_t offset) HWY_ATTR {
      const auto at = hn::Add(first, hn::Set(di, offset));
      const Lane low = hn::GatherIndex(FloatTag(), values, at);
      const Lane high = hn::GatherIndex(FloatTag(), values, hn::Add(at, hn::Set(di, 1)));
      return low + (high - low) * by_c;
    };
    const auto low = along(0);
    return low + (along(row_length) - low) * by_r;
  };
  return {between(table.lobe.data()), between(table.fresnel.data())};
}

HWY_INLINE Lane environment_specular(const NormLanes& norms, Lane f0, Lane f90) {
  const auto all = f0 * norms.lobe + (f90 - f0) * norms.fresnel;
  return clamp(all, 0.0f, 1.0f);
}

/// Stores the material of ShadingPoints except its diffuse part.
HWY_INLINE void store_lobe(const Vectors& f0, Lane f90, Lane roughness, ShadingPoints& points,
                           std::size_t i) {
  store(f0, points.f0, i);
  store(Vectors{f90 - f0.x, f90 - f0.y, f90 - f0.z}, points.f90_less_f0, i);
  const auto floored = clamp(roughness, roughness_floor, 1.0f);
  store(floored * floored, points.alpha, i);
  store(0.0f, points.shows_lights, i);
  store(0.0f, points.sheen, i);
  const Vectors nothing{0.0f, 0.0f, 0.0f};
  store(nothing, points.stretch, i);
  // Broad highlights need no patch.
  const auto narrow = roughness < least_broad_roughness;
  const Vectors right = where(narrow, loaded(points.patch_right, i));
  const Vectors down = where(narrow, loaded(points.patch_down, i));
  store(right, points.patch_right, i);
  store(down, points.patch_down, i);
  store(where(narrow, loaded(points.viewer_nearness, i)), points.viewer_nearness, i);
  const auto turns = differ(right, nothing) || differ(down, nothing) ||
                     loaded(points.spread_variance, i) != 0.0f ||
                     differ(loaded(points.spread_right, i), nothing) ||
                     differ(loaded(points.spread_down, i), nothing);
  store(where(turns, 1.0f), points.turns, i);
}

HWY_INLINE Lane sum_of(const Vectors& v) {
  return v.x + v.y + v.z;
}

/// As mirroring_cosine.
HWY_INLINE Lane mirroring_cosine(const Vectors& normal, const Vectors& geometric,
                                 const Vectors& to_viewer, Lane n_dot_v) {
  constexpr float half = 0.5f;
  const auto least = least_mirrored_rise;
  const auto cosine = dot(normal, to_viewer), height = dot(to_viewer, geometric);
  const auto rise = 2.0f * cosine * dot(normal, geometric) - height;
  const auto bends = differ(normal, geometric) && rise < least;
  if (none(bends)) return n_dot_v;
  const auto more = least - rise;
  const auto along = 2.0f * cosine * cosine - 1.0f + more * height;
  const auto length = sqrt(1.0f + more * (2.0f * rise + more));
  const auto square = half * (1.0f + along / length);
  const auto bent = sqrt(max(0.0f, square));
  return selected(bends, max(grazing_cosine, bent), n_dot_v);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
