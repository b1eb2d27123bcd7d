// The GGX lobe of a point or of a patch, as reflected_share, with one point per lane. Included once
// for each instruction set.
#if defined(ASOS_KERNELS_LOBES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_LOBES_H
#undef ASOS_KERNELS_LOBES_H
#else
#define ASOS_KERNELS_LOBES_H
#endif

#include "renderer/kernels/lanes.h"
#include "renderer/kernels/light_samples.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/patch_lobe.h"
#include "renderer/shading/sheen.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

/// The directions that a lobe depends on.
struct LobeGeometryLanes {
  Vectors normal, to_viewer, to_light;
  Vectors half;  ///< unit
  Lane per_sum;  ///< 1 / length of to_viewer + to_light
  Lane n_dot_l, n_dot_v, n_dot_h;
  Lane alpha;  ///< squared roughness
  Lane light_nearness;
};

/// As ggx_lobe.
HWY_INLINE Lane point_lobe(const LobeGeometryLanes& at) {
  const Lane a2 = at.alpha * at.alpha, nl = at.n_dot_l, nv = at.n_dot_v;
  return ggx_over(a2, ggx_stretched(a2, at.n_dot_h),
                  smith_shadowing(nl, smith_root(nl, a2), nv, smith_root(nv, a2)));
}

/// Returns the derivative of a unit direction along an edge of a patch. The direction's target is
/// at distance 1 / `nearness`.
HWY_INLINE Vectors turned(const Vectors& edge, const Vectors& direction, Lane nearness) {
  return nearness * (dot(direction, edge) * direction - edge);
}

/// Returns how the patch's normals turn about the half vector along an edge, as spread_about_half.
HWY_INLINE Vectors turn_about_half(const LobeGeometryLanes& at, Lane viewer_nearness,
                                   const Vectors& spread, const Vectors& edge) {
  const Vectors d = at.per_sum * (turned(edge, at.to_viewer, viewer_nearness) +
                                  turned(edge, at.to_light, at.light_nearness));
  return spread - (d - dot(at.half, d) * at.half);
}

/// As PatchLobe. `added` and `variance` are those of the patch's normals.
HWY_INLINE Lane patch_lobe(const LobeGeometryLanes& at, const Vectors& right, const Vectors& down,
                           const Vectors& stretch, Lane added, Lane variance) {
  constexpr double box_variance = 1.0 / 12.0;
  const LobeAxes<Lane> axes = axes_about<Lane>(at.normal.x, at.normal.y, at.normal.z);
  const auto vectors = [](const LobeVector<Lane>& v) HWY_ATTR { return Vectors{v.x, v.y, v.z}; };
  const Vectors x = vectors(axes.right), y = vectors(axes.up);
  const Lane alpha = at.alpha, nl = at.n_dot_l, nv = at.n_dot_v;
  const Lane part = min(1.0f, PatchLobe::most_added / added);
  const auto along = [&](const Vectors& axis) HWY_ATTR {
    return LobeSpread<Lane>{dot(axis, stretch), dot(axis, right), dot(axis, down)};
  };
  const auto slopes =
      GgxSlopes<Lane>::of(alpha * alpha + part * variance, part * box_variance, along(x), along(y));
  const auto root = [&](Lane cosine, const Vectors& v) HWY_ATTR {
    return sqrt(cosine * cosine + slopes.quadratic(dot(x, v), dot(y, v)));
  };
  const Lane det = slopes.determinant();
  return ggx_over(GgxSlopes<Lane>::alpha2(det),
                  slopes.stretched(dot(x, at.half), dot(y, at.half), at.n_dot_h, det),
                  smith_shadowing(nl, root(nl, at.to_light), nv, root(nv, at.to_viewer)));
}

/// Replaces the lobe by sheen_lobe where there is sheen, lane by lane, since it is rare and uses
/// powers.
HWY_INLINE Lane with_sheen(const ShadingPoints& points, const LobeGeometryLanes& at, Lane others,
                           std::size_t i) {
  if (none(loaded(points.sheen, i) > 0.0f)) return others;
  struct alignas(64) Floats : std::array<float, hn::MaxLanes(FloatTag())> {};
  Floats n_dot_l, n_dot_v, n_dot_h, value;
  at.n_dot_l.store(n_dot_l.data());
  at.n_dot_v.store(n_dot_v.data());
  at.n_dot_h.store(n_dot_h.data());
  others.store(value.data());
  for (std::size_t k = 0; k < Lane::count() && i + k < points.count; ++k) {
    if (points.sheen[i + k] > 0.0f)
      value[k] = sheen_lobe(points.sheen[i + k], {n_dot_l[k], n_dot_v[k], n_dot_h[k], 0.0f});
  }
  return Lane::loaded(value.data());
}

/// Returns the lobe of points from i on. It is a patch's lobe where its normals differ enough to
/// matter.
HWY_INLINE Lane lobe(const ShadingPoints& points, const LobeGeometryLanes& at, std::size_t i) {
  Lane of_point = point_lobe(at);
  const auto turns = loaded(points.turns, i) > 0.0f;
  if (none(turns)) return of_point;
  of_point = with_sheen(points, at, of_point, i);
  const auto nearness = loaded(points.viewer_nearness, i);
  const Vectors stretch = loaded(points.stretch, i);
  Vectors right =
      turn_about_half(at, nearness, loaded(points.spread_right, i), loaded(points.patch_right, i));
  Vectors down =
      turn_about_half(at, nearness, loaded(points.spread_down, i), loaded(points.patch_down, i));
  auto variance = loaded(points.spread_variance, i);
  const auto added = (dot(right, right) + dot(down, down)) * (1.0f / 12.0f) + (variance + variance);
  const auto least = 1e-3f * (at.alpha * at.alpha);
  const auto glossy = turns && !(loaded(points.sheen, i) > 0.0f);
  const auto spreads = added > least && added < infinity;
  const auto stretched = dot(stretch, stretch) > 0.0f;
  const auto wider = glossy && (spreads || stretched);
  if (none(wider)) return of_point;
  const auto kept = [&](const Vectors& v) -> Vectors {
    return {where(spreads, v.x), where(spreads, v.y), where(spreads, v.z)};
  };
  right = kept(right), down = kept(down), variance = where(spreads, variance);
  const auto all = selected(spreads, added, 1.0f);
  return selected(wider, patch_lobe(at, right, down, stretch, all, variance), of_point);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
