// The GGX lobe of a point or of a patch, as reflected_share, with one point per lane. Included once
// for each instruction set.
#if defined(ASOS_KERNELS_LOBES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_LOBES_H
#undef ASOS_KERNELS_LOBES_H
#else
#define ASOS_KERNELS_LOBES_H
#endif

#include "renderer/kernels/highlights.h"
#include "renderer/shading/lobe.h"
#include "renderer/shading/sheen.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

/// The directions that a lobe depends on.
struct LobeGeometryLanes {
  Vectors normal, to_viewer, to_light;
  Vectors half;   ///< unit
  Lanes per_sum;  ///< 1 / length of to_viewer + to_light
  Lanes n_dot_l, n_dot_v, n_dot_h;
  Lanes alpha;  ///< squared roughness
  Lanes light_nearness;
};

/// As ggx_lobe.
HWY_INLINE Lanes point_lobe(const LobeGeometryLanes& at) {
  const auto one = all_lanes(1.0f);
  const auto a2 = hn::Mul(at.alpha, at.alpha);
  const auto d = hn::Add(hn::Mul(hn::Mul(at.n_dot_h, at.n_dot_h), hn::Sub(a2, one)), one);
  const auto nl = at.n_dot_l, nv = at.n_dot_v;
  const auto left = hn::Sub(one, a2);
  const auto shadowing =
      hn::Add(hn::Mul(nl, hn::Sqrt(hn::Add(hn::Mul(hn::Mul(nv, nv), left), a2))),
              hn::Mul(nv, hn::Sqrt(hn::Add(hn::Mul(hn::Mul(nl, nl), left), a2))));
  return hn::Div(hn::Mul(a2, all_lanes(0.5f * std::numbers::inv_pi_v<float>)),
                 hn::Mul(hn::Mul(d, d), shadowing));
}

/// Returns the derivative of a unit direction along an edge of a patch. The direction's target is
/// at distance 1 / `nearness`.
HWY_INLINE Vectors turned(const Vectors& edge, const Vectors& direction, Lanes nearness) {
  return scaled(nearness, scaled(dot(direction, edge), direction) - edge);
}

/// Returns how the patch's normals turn about the half vector along an edge, as spread_about_half.
HWY_INLINE Vectors turn_about_half(const LobeGeometryLanes& at, Lanes viewer_nearness,
                                   const Vectors& spread, const Vectors& edge) {
  const Vectors d = scaled(at.per_sum, turned(edge, at.to_viewer, viewer_nearness) +
                                           turned(edge, at.to_light, at.light_nearness));
  return spread - (d - scaled(dot(at.half, d), at.half));
}

/// The matrix of PatchLobe: alpha^2 by direction in the tangent plane.
struct SlopeLanes {
  Vectors tangent, bitangent;
  Lanes xx, yy, xy;

  [[nodiscard]] HWY_INLINE Lanes quadratic(const Vectors& v) const {
    const auto x = dot(tangent, v), y = dot(bitangent, v);
    const auto both = hn::Mul(hn::Mul(hn::Add(xy, xy), x), y);
    return hn::Add(hn::Add(hn::Mul(hn::Mul(xx, x), x), both), hn::Mul(hn::Mul(yy, y), y));
  }
};

HWY_INLINE SlopeLanes slopes_of(const LobeGeometryLanes& at, const Vectors& right,
                                const Vectors& down, const Vectors& stretch, Lanes added,
                                Lanes variance) {
  constexpr float box_variance = 1.0f / 12.0f;
  const auto one = all_lanes(1.0f);
  const Vectors& n = at.normal;
  SlopeLanes lobe;
  // A tangent frame of any direction (Duff et al. 2017).
  const auto sign = hn::CopySign(one, n.z);
  const auto a = hn::Neg(hn::Div(one, hn::Add(sign, n.z)));
  const auto b = hn::Mul(hn::Mul(n.x, n.y), a);
  lobe.tangent = {hn::Add(one, hn::Mul(hn::Mul(hn::Mul(sign, n.x), n.x), a)), hn::Mul(sign, b),
                  hn::Neg(hn::Mul(sign, n.x))};
  lobe.bitangent = {b, hn::Add(sign, hn::Mul(hn::Mul(n.y, n.y), a)), hn::Neg(n.y)};

  const auto part = hn::Min(one, hn::Div(all_lanes(PatchLobe::most_added), added));
  const auto turn = hn::Mul(part, all_lanes(box_variance));
  const auto round = hn::Add(hn::Mul(at.alpha, at.alpha), hn::Mul(part, variance));
  const auto rx = dot(lobe.tangent, right), ry = dot(lobe.bitangent, right);
  const auto dx = dot(lobe.tangent, down), dy = dot(lobe.bitangent, down);
  const auto sx = dot(lobe.tangent, stretch), sy = dot(lobe.bitangent, stretch);
  lobe.xx = hn::Add(hn::Add(round, hn::Mul(sx, sx)),
                    hn::Mul(turn, hn::Add(hn::Mul(rx, rx), hn::Mul(dx, dx))));
  lobe.yy = hn::Add(hn::Add(round, hn::Mul(sy, sy)),
                    hn::Mul(turn, hn::Add(hn::Mul(ry, ry), hn::Mul(dy, dy))));
  lobe.xy = hn::Add(hn::Mul(sx, sy), hn::Mul(turn, hn::Add(hn::Mul(rx, ry), hn::Mul(dx, dy))));
  return lobe;
}

HWY_INLINE Lanes patch_lobe(const LobeGeometryLanes& at, const SlopeLanes& lobe) {
  const auto x = dot(lobe.tangent, at.half), y = dot(lobe.bitangent, at.half);
  const auto det = hn::Sub(hn::Mul(lobe.xx, lobe.yy), hn::Mul(lobe.xy, lobe.xy));
  const auto both = hn::Mul(hn::Mul(hn::Add(lobe.xy, lobe.xy), x), y);
  const auto slopes = hn::Div(
      hn::Add(hn::Sub(hn::Mul(hn::Mul(lobe.yy, x), x), both), hn::Mul(hn::Mul(lobe.xx, y), y)),
      det);
  const auto d = hn::Add(slopes, hn::Mul(at.n_dot_h, at.n_dot_h));
  const auto nl = at.n_dot_l, nv = at.n_dot_v;
  const auto shadowing =
      hn::Add(hn::Mul(nl, hn::Sqrt(hn::Add(hn::Mul(nv, nv), lobe.quadratic(at.to_viewer)))),
              hn::Mul(nv, hn::Sqrt(hn::Add(hn::Mul(nl, nl), lobe.quadratic(at.to_light)))));
  return hn::Div(all_lanes(0.5f * std::numbers::inv_pi_v<float>),
                 hn::Mul(hn::Mul(hn::Sqrt(det), hn::Mul(d, d)), shadowing));
}

/// Replaces the lobe by sheen_lobe where there is sheen, lane by lane, since it is rare and uses
/// powers.
HWY_INLINE Lanes with_sheen(const ShadingPoints& points, const LobeGeometryLanes& at, Lanes others,
                            std::size_t i) {
  const FloatTag d;
  if (hn::AllFalse(d, hn::Gt(loaded(points.sheen, i), hn::Zero(d)))) return others;
  struct alignas(64) Floats : std::array<float, hn::MaxLanes(FloatTag())> {};
  Floats n_dot_l, n_dot_v, n_dot_h, value;
  hn::Store(at.n_dot_l, d, n_dot_l.data());
  hn::Store(at.n_dot_v, d, n_dot_v.data());
  hn::Store(at.n_dot_h, d, n_dot_h.data());
  hn::Store(others, d, value.data());
  for (std::size_t k = 0; k < hn::Lanes(d) && i + k < points.count; ++k) {
    if (points.sheen[i + k] > 0.0f)
      value[k] = sheen_lobe(points.sheen[i + k], {n_dot_l[k], n_dot_v[k], n_dot_h[k], 0.0f});
  }
  return hn::Load(d, value.data());
}

/// Returns the lobe of points from i on. It is a patch's lobe where its normals differ enough to
/// matter.
HWY_INLINE Lanes lobe(const ShadingPoints& points, const LobeGeometryLanes& at, std::size_t i) {
  const FloatTag d;
  Lanes of_point = point_lobe(at);
  const auto turns = hn::Gt(loaded(points.turns, i), hn::Zero(d));
  if (hn::AllFalse(d, turns)) return of_point;
  of_point = with_sheen(points, at, of_point, i);
  const auto nearness = loaded(points.viewer_nearness, i);
  const Vectors stretch = loaded(points.stretch, i);
  Vectors right =
      turn_about_half(at, nearness, loaded(points.spread_right, i), loaded(points.patch_right, i));
  Vectors down =
      turn_about_half(at, nearness, loaded(points.spread_down, i), loaded(points.patch_down, i));
  auto variance = loaded(points.spread_variance, i);
  const auto added =
      hn::Add(hn::Mul(hn::Add(dot(right, right), dot(down, down)), all_lanes(1.0f / 12.0f)),
              hn::Add(variance, variance));
  const auto least = hn::Mul(all_lanes(1e-3f), hn::Mul(at.alpha, at.alpha));
  const auto glossy = hn::AndNot(hn::Gt(loaded(points.sheen, i), hn::Zero(d)), turns);
  const auto spreads = hn::And(hn::Gt(added, least), hn::Lt(added, hn::Inf(d)));
  const auto stretched = hn::Gt(dot(stretch, stretch), hn::Zero(d));
  const auto wider = hn::And(glossy, hn::Or(spreads, stretched));
  if (hn::AllFalse(d, wider)) return of_point;
  const auto kept = [&](const Vectors& v) -> Vectors {
    return {hn::IfThenElseZero(spreads, v.x), hn::IfThenElseZero(spreads, v.y),
            hn::IfThenElseZero(spreads, v.z)};
  };
  right = kept(right), down = kept(down), variance = hn::IfThenElseZero(spreads, variance);
  const auto all = hn::IfThenElse(spreads, added, hn::Set(d, 1.0f));
  return hn::IfThenElse(wider, patch_lobe(at, slopes_of(at, right, down, stretch, all, variance)),
                        of_point);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
