#include "renderer/kernels/surface_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/surface_kernel.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/material_lanes.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/lobe_norms.h"
#include "renderer/shading/smooth_surface.h"
#include "renderer/shading/viewed_point.h"

#include <hwy/highway.h>
#include <limits>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

/// Bound of the relative error of n float operations in a row (Higham's gamma).
constexpr float gamma_bound(int n) {
  constexpr float half_ulp = 0.5f * std::numeric_limits<float>::epsilon();
  return static_cast<float>(n) * half_ulp / (1.0f - static_cast<float>(n) * half_ulp);
}

HWY_INLINE Vectors absolute(const Vectors& v) {
  return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)};
}
HWY_INLINE Vectors divided(const Vectors& v, Lanes by) {
  return {hn::Div(v.x, by), hn::Div(v.y, by), hn::Div(v.z, by)};
}
/// Negates the vectors where `mask` is set.
HWY_INLINE Vectors turned_if(const LaneMask& mask, const Vectors& v) {
  return select(mask, {hn::Neg(v.x), hn::Neg(v.y), hn::Neg(v.z)}, v);
}

/// Computes the geometric normals, not yet turned to the viewer. Uses double precision, because the
/// cross product of a sliver cancels badly and shadows depend on the normal.
void find_geometric_normals(const TriangleBatch& hits, ShadingPoints& points) {
  const DoubleTag d;
  for (std::size_t i = 0; i < hits.count; i += hn::Lanes(d)) {
    const auto p0 = doubles(hits.corner_0, i);
    const auto across = cross(doubles(hits.corner_1, i) - p0, doubles(hits.corner_2, i) - p0);
    const auto length = hn::Sqrt(dot(across, across));
    const auto some = hn::Gt(length, hn::Zero(d));
    const auto divisor = hn::IfThenElse(some, length, hn::Set(d, 1.0));
    store_floats(hn::IfThenElseZero(some, hn::Div(across.x, divisor)), &points.geometric.x[i]);
    store_floats(hn::IfThenElseZero(some, hn::Div(across.y, divisor)), &points.geometric.y[i]);
    store_floats(hn::IfThenElseZero(some, hn::Div(across.z, divisor)), &points.geometric.z[i]);
    store_floats(length, &points.to_edge[i]);  // twice the area, until place_points
  }
}

/// Weights of a triangle's corners.
struct Weights {
  Lanes b0, b1, b2;

  [[nodiscard]] HWY_INLINE Vectors mix(const Vectors& at_0, const Vectors& at_1,
                                       const Vectors& at_2) const {
    return (scaled(b0, at_0) + scaled(b1, at_1)) + scaled(b2, at_2);
  }
};

struct PatchLanes {
  Vectors right, down;
};

/// As PixelSpacing.
struct SpacingLanes {
  Vectors right, down, forward;
  Lanes start;
  LaneMask perspective;
};

/// The spacing of one picture for all points.
struct OneSpacing {
  const PixelSpacing* spacing;  ///< null: all samples are points

  [[nodiscard]] HWY_INLINE bool known() const { return spacing != nullptr; }
  [[nodiscard]] HWY_INLINE SpacingLanes at(std::size_t) const {
    const auto perspective = all_lanes(spacing->perspective ? 1.0f : 0.0f);
    return {all_lanes(spacing->right), all_lanes(spacing->down), all_lanes(spacing->forward),
            all_lanes(spacing->start), hn::Gt(perspective, hn::Zero(FloatTag()))};
  }
};
/// A spacing for each point.
struct OwnSpacings {
  const SpacingBatch* spacings;

  [[nodiscard]] HWY_INLINE bool known() const { return true; }
  [[nodiscard]] HWY_INLINE SpacingLanes at(std::size_t i) const {
    return {loaded(spacings->right, i), loaded(spacings->down, i), loaded(spacings->forward, i),
            loaded(spacings->start, i),
            hn::Gt(loaded(spacings->perspective, i), hn::Zero(FloatTag()))};
  }
};

/// As patch_on_plane.
HWY_INLINE PatchLanes patch_on_plane(const TriangleBatch& hits, const SpacingLanes& spacing,
                                     const Vectors& direction, const Vectors& normal,
                                     std::size_t i) {
  const auto side = loaded(hits.side, i);
  const auto ahead = hn::Add(spacing.start, loaded(hits.distance, i));
  const auto widened = hn::Mul(side, hn::Mul(ahead, dot(direction, spacing.forward)));
  const auto scale = hn::IfThenElse(spacing.perspective, widened, side);
  const auto cosine = dot(normal, direction);
  const auto least = hn::Max(hn::Abs(cosine), all_lanes(steepest_patch));
  const auto per_cosine = hn::Div(all_lanes(1.0f), hn::CopySign(least, cosine));
  const auto moved = [&](const Vectors& step) HWY_ATTR {
    return scaled(scale, step - scaled(hn::Mul(dot(normal, step), per_cosine), direction));
  };
  return {moved(spacing.right), moved(spacing.down)};
}

/// A footprint in the triangle's own coordinates.
struct FootprintLanes {
  Lanes right_b1, right_b2, down_b1, down_b2;
};

/// As footprint_between.
HWY_INLINE FootprintLanes footprint_between(const Vectors& e1, const Vectors& e2,
                                            const PatchLanes& patch) {
  const auto g11 = dot(e1, e1), g12 = dot(e1, e2), g22 = dot(e2, e2);
  const auto det = hn::Sub(hn::Mul(g11, g22), hn::Mul(g12, g12));
  const auto spans = hn::Gt(det, hn::Zero(FloatTag()));
  const auto one = all_lanes(1.0f);
  const auto per_det = hn::Div(one, hn::IfThenElse(spans, det, one));
  const auto first = [&](Lanes p1, Lanes p2) HWY_ATTR {
    return hn::Mul(hn::Sub(hn::Mul(g22, p1), hn::Mul(g12, p2)), per_det);
  };
  const auto second = [&](Lanes p1, Lanes p2) HWY_ATTR {
    return hn::Mul(hn::Sub(hn::Mul(g11, p2), hn::Mul(g12, p1)), per_det);
  };
  const auto right_1 = dot(e1, patch.right), right_2 = dot(e2, patch.right);
  const auto down_1 = dot(e1, patch.down), down_2 = dot(e2, patch.down);
  const FootprintLanes f{first(right_1, right_2), second(right_1, right_2), first(down_1, down_2),
                         second(down_1, down_2)};
  const auto sum = hn::Add(hn::Add(hn::Add(f.right_b1, f.right_b2), f.down_b1), f.down_b2);
  const auto sound = hn::And(spans, finite(sum));
  return {hn::IfThenElseZero(sound, f.right_b1), hn::IfThenElseZero(sound, f.right_b2),
          hn::IfThenElseZero(sound, f.down_b1), hn::IfThenElseZero(sound, f.down_b2)};
}

/// Returns how an interpolated normal turns along a footprint's edge. `length` is the interpolated
/// normal's length before it became the unit `normal`.
HWY_INLINE Vectors turn_along(const Lanes& b1, const Lanes& b2, const Vectors& by_1,
                              const Vectors& by_2, const Vectors& normal, Lanes length) {
  const Vectors step = scaled(b1, by_1) + scaled(b2, by_2);
  return divided(step - scaled(dot(step, normal), normal), length);
}

/// Computes, for points from i on, the position, its error, the height that clears the surface, and
/// the bound of the distance to the triangle's border. Needs find_geometric_normals first.
HWY_INLINE void place_points(const TriangleBatch& hits, const Weights& w, const Vectors& geometric,
                             SurfaceRest& rest, ShadingPoints& points, std::size_t i) {
  const Vectors p0 = loaded(hits.corner_0, i), p1 = loaded(hits.corner_1, i),
                p2 = loaded(hits.corner_2, i);
  const Vectors w0 = scaled(w.b0, p0), w1 = scaled(w.b1, p1), w2 = scaled(w.b2, p2);
  store((w0 + w1) + w2, points.position, i);
  const Vectors error =
      scaled(all_lanes(gamma_bound(7)), (absolute(w0) + absolute(w1)) + absolute(w2));
  store(error, rest.error, i);
  const auto size = [&](Lanes a, Lanes b, Lanes c) HWY_ATTR {
    return hn::Sub(hn::Max(a, hn::Max(b, c)), hn::Min(a, hn::Min(b, c)));
  };
  const auto extent =
      hn::Max(size(p0.x, p1.x, p2.x), hn::Max(size(p0.y, p1.y, p2.y), size(p0.z, p1.z, p2.z)));
  store(extent, rest.extent, i);
  const auto along_normal = dot(absolute(geometric), error);
  const auto by_test = hn::Mul(all_lanes(gamma_bound(12)), extent);
  store(hn::Mul(all_lanes(2.0f), hn::Add(along_normal, by_test)), points.clear_height, i);
  const auto least = hn::Min(w.b0, hn::Min(w.b1, w.b2));
  const auto longest = hn::Mul(all_lanes(longest_side), extent);
  store(hn::Div(hn::Mul(least, loaded(points.to_edge, i)), longest), points.to_edge, i);
}

/// The interpolated normals of points from i on.
struct SmoothLanes {
  Vectors normal;  ///< unit; the geometric normal where there is none
  Lanes length;    ///< before it became unit
};
HWY_INLINE SmoothLanes smooth_normal(const TriangleBatch& hits, const Weights& w,
                                     const Vectors& geometric, std::size_t i) {
  const Vectors mixed =
      w.mix(loaded(hits.normal_0, i), loaded(hits.normal_1, i), loaded(hits.normal_2, i));
  const auto length2 = dot(mixed, mixed);
  const auto sound = hn::And(hn::Gt(length2, hn::Zero(FloatTag())), finite(length2));
  const auto length = hn::Sqrt(length2);
  const auto divisor = hn::IfThenElse(sound, length, all_lanes(1.0f));
  return {select(sound, divided(mixed, divisor), geometric), length};
}

/// As height_of_smooth: the height of the smooth surface above the triangles of points from i on.
HWY_INLINE Vectors height_of_smooth(const TriangleBatch& hits, const Weights& w,
                                    const Vectors& geometric, Lanes side, Lanes extent,
                                    std::size_t i) {
  const auto zero = hn::Zero(FloatTag());
  const Vectors corner[3] = {loaded(hits.corner_0, i), loaded(hits.corner_1, i),
                             loaded(hits.corner_2, i)};
  const Vectors normal[3] = {loaded(hits.normal_0, i), loaded(hits.normal_1, i),
                             loaded(hits.normal_2, i)};
  const Lanes weights[3] = {w.b0, w.b1, w.b2};
  Vectors lift{zero, zero, zero};
  const auto bends = hn::Or(differ(normal[0], normal[1]), differ(normal[0], normal[2]));
  if (hn::AllFalse(FloatTag(), bends)) return lift;
  auto highest = zero, least_cosine = all_lanes(1.0f);
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const Vectors n = scaled(side, normal[a]);
    least_cosine = hn::Min(least_cosine, dot(n, geometric));
    const auto above_b = dot(corner[a] - corner[b], n), above_c = dot(corner[a] - corner[c], n);
    highest = hn::Max(highest, hn::Max(above_b, above_c));
    const auto above = hn::Add(hn::Mul(weights[b], above_b), hn::Mul(weights[c], above_c));
    lift = lift + scaled(hn::Mul(weights[a], hn::Max(zero, above)), n);
  }
  const auto bulges = hn::Gt(highest, hn::Mul(all_lanes(least_bulge), extent));
  const auto smooth =
      hn::And(hn::And(bends, bulges), hn::Gt(least_cosine, all_lanes(least_smooth_cosine)));
  return select(smooth, lift, {zero, zero, zero});
}

/// Moves points from i on to the smooth surface, after place_points. The triangle's normal is
/// replaced by that of the horizon.
HWY_INLINE void lift_points(const TriangleBatch& hits, const Weights& w, const Vectors& geometric,
                            const Vectors& normal, Lanes side, SurfaceRest& rest,
                            ShadingPoints& points, std::size_t i) {
  const auto zero = hn::Zero(FloatTag());
  const Vectors none{zero, zero, zero};
  const Vectors lift = height_of_smooth(hits, w, geometric, side, loaded(rest.extent, i), i);
  const auto lifted = differ(lift, none);
  const Vectors position = loaded(points.position, i);
  store(position, rest.position, i);
  store(geometric, rest.geometric, i);
  store(lift, rest.lift, i);
  store(select(lifted, normal, none), rest.smooth_normal, i);
  store(position + lift, points.position, i);
  store(select(lifted, normal, geometric), points.geometric, i);
}

/// Computes the patches of points from i on, where they matter.
template <class Spacings>
HWY_INLINE void place_patches(const TriangleBatch& hits, const Spacings& spacings,
                              const Vectors& geometric, const SmoothLanes& smooth,
                              SurfaceRest& rest, ShadingPoints& points, std::size_t i) {
  const auto zero = hn::Zero(FloatTag());
  const Vectors none{zero, zero, zero};
  PatchLanes patch{none, none}, spread{none, none};
  FootprintLanes footprint{zero, zero, zero, zero};
  auto nearness = zero;
  const auto textured = hn::Gt(loaded(hits.textured, i), zero);
  const auto shiny = hn::Gt(loaded(hits.shiny, i), zero);
  const auto wide = hn::And(hn::Gt(loaded(hits.side, i), zero), hn::Or(textured, shiny));
  if (spacings.known() && !hn::AllFalse(FloatTag(), wide)) {
    const SpacingLanes spacing = spacings.at(i);
    patch = patch_on_plane(hits, spacing, loaded(hits.direction, i), geometric, i);
    patch = {select(wide, patch.right, none), select(wide, patch.down, none)};
    const auto distance = hn::Add(spacing.start, loaded(hits.distance, i));
    nearness =
        hn::IfThenElseZero(hn::And(wide, spacing.perspective), hn::Div(all_lanes(1.0f), distance));
    const Vectors n0 = loaded(hits.normal_0, i), n1 = loaded(hits.normal_1, i),
                  n2 = loaded(hits.normal_2, i);
    const auto turns = hn::Or(differ(n0, n1), differ(n0, n2));
    const auto shows = hn::And(wide, hn::Or(textured, hn::And(shiny, turns)));
    if (!hn::AllFalse(FloatTag(), shows)) {
      const Vectors p0 = loaded(hits.corner_0, i);
      footprint =
          footprint_between(loaded(hits.corner_1, i) - p0, loaded(hits.corner_2, i) - p0, patch);
      footprint = {hn::IfThenElseZero(shows, footprint.right_b1),
                   hn::IfThenElseZero(shows, footprint.right_b2),
                   hn::IfThenElseZero(shows, footprint.down_b1),
                   hn::IfThenElseZero(shows, footprint.down_b2)};
      // Opposite normals may cancel to length 0.
      const auto some = hn::Gt(smooth.length, zero);
      const auto length = hn::IfThenElse(some, smooth.length, hn::Inf(FloatTag()));
      const Vectors by_1 = n1 - n0, by_2 = n2 - n0;
      spread = {
          turn_along(footprint.right_b1, footprint.right_b2, by_1, by_2, smooth.normal, length),
          turn_along(footprint.down_b1, footprint.down_b2, by_1, by_2, smooth.normal, length)};
    }
  }
  store(patch.right, points.patch_right, i);
  store(patch.down, points.patch_down, i);
  store(nearness, points.viewer_nearness, i);
  store(spread.right, points.spread_right, i);
  store(spread.down, points.spread_down, i);
  store(zero, points.spread_variance, i);
  store(footprint.right_b1, rest.right_b1, i);
  store(footprint.right_b2, rest.right_b2, i);
  store(footprint.down_b1, rest.down_b1, i);
  store(footprint.down_b2, rest.down_b2, i);
}

template <class Spacings>
HWY_INLINE void place(const TriangleBatch& hits, const Spacings& spacings, SurfaceRest& rest,
                      ShadingPoints& points) {
  const FloatTag d;
  const auto zero = hn::Zero(d), one = all_lanes(1.0f);
  points.count = hits.count;
  find_geometric_normals(hits, points);
  for (std::size_t i = 0; i < hits.count; i += hn::Lanes(d)) {
    const auto b1 = loaded(hits.b1, i), b2 = loaded(hits.b2, i);
    const Weights w{hn::Sub(hn::Sub(one, b1), b2), b1, b2};
    const Vectors direction = loaded(hits.direction, i);
    const Vectors to_viewer{hn::Neg(direction.x), hn::Neg(direction.y), hn::Neg(direction.z)};
    store(to_viewer, points.to_viewer, i);
    Vectors geometric = loaded(points.geometric, i);
    geometric = turned_if(hn::Lt(dot(geometric, to_viewer), zero), geometric);
    place_points(hits, w, geometric, rest, points, i);

    const SmoothLanes smooth = smooth_normal(hits, w, geometric, i);
    const auto below = hn::Lt(dot(smooth.normal, geometric), zero);
    const Vectors normal = turned_if(below, smooth.normal);
    const auto side = hn::IfThenElse(below, hn::Neg(one), one);
    store(normal, points.normal, i);
    store(side, rest.normal_side, i);
    lift_points(hits, w, geometric, normal, side, rest, points, i);
    place_patches(hits, spacings, geometric, smooth, rest, points, i);
  }
}

void place_in_one(const TriangleBatch& hits, const PixelSpacing* spacing, SurfaceRest& rest,
                  ShadingPoints& points) {
  place(hits, OneSpacing{spacing}, rest, points);
}
void place_in_own(const TriangleBatch& hits, const SpacingBatch& spacing, SurfaceRest& rest,
                  ShadingPoints& points) {
  place(hits, OwnSpacings{&spacing}, rest, points);
}

bool view(const LobeNormTable& table, const SurfaceRest& rest, MaterialBatch& materials,
          ShadingPoints& points) {
  const FloatTag d;
  const auto zero = hn::Zero(d), one = all_lanes(1.0f);
  auto all_finite = true;
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const auto n_dot_v = hn::Max(dot(loaded(points.normal, i), loaded(points.to_viewer, i)),
                                 all_lanes(grazing_cosine));
    store(n_dot_v, points.n_dot_v, i);
    const auto roughness = loaded(materials.roughness, i), f90 = loaded(materials.f90, i);
    const Vectors f0 = loaded(materials.f0, i);
    const auto mirroring = mirroring_cosine(loaded(points.normal, i), loaded(rest.geometric, i),
                                            loaded(points.to_viewer, i), n_dot_v);
    const NormLanes norms = lobe_norms(table, mirroring, roughness);
    const Vectors shine{environment_specular(norms, f0.x, f90),
                        environment_specular(norms, f0.y, f90),
                        environment_specular(norms, f0.z, f90)};
    store(shine, materials.specular, i);
    const auto dielectric = loaded(materials.dielectric_f0, i);
    const auto dielectric_f90 = loaded(materials.dielectric_f90, i);
    const auto below = hn::Sub(one, environment_specular(norms, dielectric, dielectric_f90));
    store(below, materials.below, i);
    const Vectors albedo =
        scaled(hn::Sub(one, loaded(materials.metallic, i)), loaded(materials.base_color, i));
    const Vectors ambient = scaled(hn::Mul(loaded(materials.occlusion, i), below), albedo);
    store(ambient, materials.ambient, i);
    const auto left = hn::Sub(one, dielectric);
    const Vectors diffuse = scaled(hn::Mul(all_lanes(std::numbers::inv_pi_v<float>), left), albedo);
    const auto some_left = hn::Gt(left, zero);
    const auto falloff =
        hn::Div(hn::Sub(dielectric_f90, dielectric), hn::IfThenElse(some_left, left, one));
    store(hn::IfThenElseZero(some_left, falloff), points.falloff, i);
    store(diffuse, points.diffuse, i);
    store_lobe(f0, f90, roughness, points, i);
    const auto sum =
        hn::Add(hn::Add(sum_of(diffuse), sum_of(shine)), sum_of(loaded(points.position, i)));
    const auto lost = hn::AndNot(finite(sum), hn::FirstN(d, points.count - i));
    all_finite = all_finite && hn::AllFalse(d, lost);
  }
  return all_finite;
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(place_in_one);
HWY_EXPORT(place_in_own);
HWY_EXPORT(view);

void place_surfaces(const TriangleBatch& hits, const PixelSpacing* spacing, SurfaceRest& rest,
                    ShadingPoints& points) {
  HWY_DYNAMIC_DISPATCH(place_in_one)(hits, spacing, rest, points);
}

void place_surfaces(const TriangleBatch& hits, const SpacingBatch& spacing, SurfaceRest& rest,
                    ShadingPoints& points) {
  HWY_DYNAMIC_DISPATCH(place_in_own)(hits, spacing, rest, points);
}

bool view_materials(const SurfaceRest& rest, MaterialBatch& materials, ShadingPoints& points) {
  return HWY_DYNAMIC_DISPATCH(view)(lobe_norm_table(), rest, materials, points);
}

}  // namespace asos
#endif
