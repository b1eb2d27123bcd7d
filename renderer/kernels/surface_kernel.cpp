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
  return {abs(v.x), abs(v.y), abs(v.z)};
}
HWY_INLINE Vectors divided(const Vectors& v, Lane by) {
  return {v.x / by, v.y / by, v.z / by};
}
/// Negates the vectors where `mask` is set.
HWY_INLINE Vectors turned_if(const LaneMask& mask, const Vectors& v) {
  return selected(mask, -v, v);
}

/// Computes the geometric normals, not yet turned to the viewer. Uses double precision, because the
/// cross product of a sliver cancels badly and shadows depend on the normal.
void find_geometric_normals(const TriangleBatch& hits, ShadingPoints& points) {
  for (std::size_t i = 0; i < hits.count; i += DoubleLane::count()) {
    const auto p0 = doubles(hits.corner_0, i);
    const auto across = cross(doubles(hits.corner_1, i) - p0, doubles(hits.corner_2, i) - p0);
    const auto length = sqrt(dot(across, across));
    const auto some = length > 0.0f;
    const auto divisor = selected(some, length, 1.0);
    store_floats(where(some, across.x / divisor), &points.geometric.x[i]);
    store_floats(where(some, across.y / divisor), &points.geometric.y[i]);
    store_floats(where(some, across.z / divisor), &points.geometric.z[i]);
    store_floats(length, &points.to_edge[i]);  // twice the area, until place_points
  }
}

/// Weights of a triangle's corners.
struct Weights {
  Lane b0, b1, b2;

  [[nodiscard]] HWY_INLINE Vectors mix(const Vectors& at_0, const Vectors& at_1,
                                       const Vectors& at_2) const {
    return b0 * at_0 + b1 * at_1 + b2 * at_2;
  }
};

struct PatchLanes {
  Vectors right, down;
};

/// As PixelSpacing.
struct SpacingLanes {
  Vectors right, down, forward;
  Lane start;
  LaneMask perspective;
};

/// The spacing of one picture for all points.
struct OneSpacing {
  const PixelSpacing* spacing;  ///< null: all samples are points

  [[nodiscard]] HWY_INLINE bool known() const { return spacing != nullptr; }
  [[nodiscard]] HWY_INLINE SpacingLanes at(std::size_t) const {
    return {spacing->right, spacing->down, spacing->forward, spacing->start,
            Lane(spacing->perspective ? 1.0f : 0.0f) > 0.0f};
  }
};
/// A spacing for each point.
struct OwnSpacings {
  const SpacingBatch* spacings;

  [[nodiscard]] HWY_INLINE bool known() const { return true; }
  [[nodiscard]] HWY_INLINE SpacingLanes at(std::size_t i) const {
    return {loaded(spacings->right, i), loaded(spacings->down, i), loaded(spacings->forward, i),
            loaded(spacings->start, i), loaded(spacings->perspective, i) > 0.0f};
  }
};

/// As patch_on_plane.
HWY_INLINE PatchLanes patch_on_plane(const TriangleBatch& hits, const SpacingLanes& spacing,
                                     const Vectors& direction, const Vectors& normal,
                                     std::size_t i) {
  const auto side = loaded(hits.side, i);
  const auto ahead = spacing.start + loaded(hits.distance, i);
  const auto widened = side * (ahead * dot(direction, spacing.forward));
  const auto scale = selected(spacing.perspective, widened, side);
  const auto cosine = dot(normal, direction);
  const auto least = max(abs(cosine), steepest_patch);
  const auto per_cosine = 1.0f / copysign(least, cosine);
  const auto moved = [&](const Vectors& step) HWY_ATTR {
    return scale * (step - dot(normal, step) * per_cosine * direction);
  };
  return {moved(spacing.right), moved(spacing.down)};
}

/// A footprint in the triangle's own coordinates.
struct FootprintLanes {
  Lane right_b1, right_b2, down_b1, down_b2;
};

/// As footprint_between.
HWY_INLINE FootprintLanes footprint_between(const Vectors& e1, const Vectors& e2,
                                            const PatchLanes& patch) {
  const auto g11 = dot(e1, e1), g12 = dot(e1, e2), g22 = dot(e2, e2);
  const auto det = g11 * g22 - g12 * g12;
  const auto spans = det > 0.0f;
  const auto per_det = 1.0f / selected(spans, det, 1.0f);
  const auto first = [&](Lane p1, Lane p2) HWY_ATTR { return (g22 * p1 - g12 * p2) * per_det; };
  const auto second = [&](Lane p1, Lane p2) HWY_ATTR { return (g11 * p2 - g12 * p1) * per_det; };
  const auto right_1 = dot(e1, patch.right), right_2 = dot(e2, patch.right);
  const auto down_1 = dot(e1, patch.down), down_2 = dot(e2, patch.down);
  const FootprintLanes f{first(right_1, right_2), second(right_1, right_2), first(down_1, down_2),
                         second(down_1, down_2)};
  const auto sum = f.right_b1 + f.right_b2 + f.down_b1 + f.down_b2;
  const auto sound = spans && finite(sum);
  return {where(sound, f.right_b1), where(sound, f.right_b2), where(sound, f.down_b1),
          where(sound, f.down_b2)};
}

/// Returns how an interpolated normal turns along a footprint's edge. `length` is the interpolated
/// normal's length before it became the unit `normal`.
HWY_INLINE Vectors turn_along(const Lane& b1, const Lane& b2, const Vectors& by_1,
                              const Vectors& by_2, const Vectors& normal, Lane length) {
  const Vectors step = b1 * by_1 + b2 * by_2;
  return divided(step - dot(step, normal) * normal, length);
}

/// Computes, for points from i on, the position, its error, the height that clears the surface, and
/// the bound of the distance to the triangle's border. Needs find_geometric_normals first.
HWY_INLINE void place_points(const TriangleBatch& hits, const Weights& w, const Vectors& geometric,
                             SurfaceRest& rest, ShadingPoints& points, std::size_t i) {
  const Vectors p0 = loaded(hits.corner_0, i), p1 = loaded(hits.corner_1, i),
                p2 = loaded(hits.corner_2, i);
  const Vectors w0 = w.b0 * p0, w1 = w.b1 * p1, w2 = w.b2 * p2;
  store((w0 + w1) + w2, points.position, i);
  const Vectors error = gamma_bound(7) * (absolute(w0) + absolute(w1) + absolute(w2));
  store(error, rest.error, i);
  const auto size = [&](Lane a, Lane b, Lane c)
                        HWY_ATTR { return max(a, max(b, c)) - min(a, min(b, c)); };
  const auto extent =
      max(size(p0.x, p1.x, p2.x), max(size(p0.y, p1.y, p2.y), size(p0.z, p1.z, p2.z)));
  store(extent, rest.extent, i);
  const auto along_normal = dot(absolute(geometric), error);
  const auto by_test = gamma_bound(12) * extent;
  store(2.0f * (along_normal + by_test), points.clear_height, i);
  const auto least = min(w.b0, min(w.b1, w.b2));
  const auto longest = longest_side * extent;
  store(least * loaded(points.to_edge, i) / longest, points.to_edge, i);
}

/// The interpolated normals of points from i on.
struct SmoothLanes {
  Vectors normal;  ///< unit; the geometric normal where there is none
  Lane length;     ///< before it became unit
};
HWY_INLINE SmoothLanes smooth_normal(const TriangleBatch& hits, const Weights& w,
                                     const Vectors& geometric, std::size_t i) {
  const Vectors mixed =
      w.mix(loaded(hits.normal_0, i), loaded(hits.normal_1, i), loaded(hits.normal_2, i));
  const auto length2 = dot(mixed, mixed);
  const auto sound = length2 > 0.0f && finite(length2);
  const auto length = sqrt(length2);
  const auto divisor = selected(sound, length, 1.0f);
  return {selected(sound, divided(mixed, divisor), geometric), length};
}

/// As height_of_smooth: the height of the smooth surface above the triangles of points from i on.
HWY_INLINE Vectors height_of_smooth(const TriangleBatch& hits, const Weights& w,
                                    const Vectors& geometric, Lane side, Lane extent,
                                    std::size_t i) {
  const Vectors corner[3] = {loaded(hits.corner_0, i), loaded(hits.corner_1, i),
                             loaded(hits.corner_2, i)};
  const Vectors normal[3] = {loaded(hits.normal_0, i), loaded(hits.normal_1, i),
                             loaded(hits.normal_2, i)};
  const Lane weights[3] = {w.b0, w.b1, w.b2};
  Vectors lift{0.0f, 0.0f, 0.0f};
  const auto bends = differ(normal[0], normal[1]) || differ(normal[0], normal[2]);
  if (none(bends)) return lift;
  Lane highest = 0.0f, least_cosine = 1.0f;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const Vectors n = side * normal[a];
    least_cosine = min(least_cosine, dot(n, geometric));
    const auto above_b = dot(corner[a] - corner[b], n), above_c = dot(corner[a] - corner[c], n);
    highest = max(highest, max(above_b, above_c));
    const auto above = weights[b] * above_b + weights[c] * above_c;
    lift = lift + weights[a] * max(0.0f, above) * n;
  }
  const auto bulges = highest > least_bulge * extent;
  const auto smooth = bends && bulges && least_cosine > least_smooth_cosine;
  return where(smooth, lift);
}

/// Moves points from i on to the smooth surface, after place_points. The triangle's normal is
/// replaced by that of the horizon.
HWY_INLINE void lift_points(const TriangleBatch& hits, const Weights& w, const Vectors& geometric,
                            const Vectors& normal, Lane side, SurfaceRest& rest,
                            ShadingPoints& points, std::size_t i) {
  const Vectors nothing{0.0f, 0.0f, 0.0f};
  const Vectors lift = height_of_smooth(hits, w, geometric, side, loaded(rest.extent, i), i);
  const auto lifted = differ(lift, nothing);
  const Vectors position = loaded(points.position, i);
  store(position, rest.position, i);
  store(geometric, rest.geometric, i);
  store(lift, rest.lift, i);
  store(where(lifted, normal), rest.smooth_normal, i);
  store(position + lift, points.position, i);
  store(selected(lifted, normal, geometric), points.geometric, i);
}

/// Computes the patches of points from i on, where they matter.
template <class Spacings>
HWY_INLINE void place_patches(const TriangleBatch& hits, const Spacings& spacings,
                              const Vectors& geometric, const SmoothLanes& smooth,
                              SurfaceRest& rest, ShadingPoints& points, std::size_t i) {
  const Vectors nothing{0.0f, 0.0f, 0.0f};
  PatchLanes patch{nothing, nothing}, spread{nothing, nothing};
  FootprintLanes footprint{0.0f, 0.0f, 0.0f, 0.0f};
  Lane nearness = 0.0f;
  const auto textured = loaded(hits.textured, i) > 0.0f;
  const auto shiny = loaded(hits.shiny, i) > 0.0f;
  const auto wide = loaded(hits.side, i) > 0.0f && (textured || shiny);
  if (spacings.known() && !none(wide)) {
    const SpacingLanes spacing = spacings.at(i);
    patch = patch_on_plane(hits, spacing, loaded(hits.direction, i), geometric, i);
    patch = {where(wide, patch.right), where(wide, patch.down)};
    const auto distance = spacing.start + loaded(hits.distance, i);
    nearness = where(wide && spacing.perspective, 1.0f / distance);
    const Vectors n0 = loaded(hits.normal_0, i), n1 = loaded(hits.normal_1, i),
                  n2 = loaded(hits.normal_2, i);
    const auto turns = differ(n0, n1) || differ(n0, n2);
    const auto shows = wide && (textured || (shiny && turns));
    if (!none(shows)) {
      const Vectors p0 = loaded(hits.corner_0, i);
      footprint =
          footprint_between(loaded(hits.corner_1, i) - p0, loaded(hits.corner_2, i) - p0, patch);
      footprint = {where(shows, footprint.right_b1), where(shows, footprint.right_b2),
                   where(shows, footprint.down_b1), where(shows, footprint.down_b2)};
      // Opposite normals may cancel to length 0.
      const auto some = smooth.length > 0.0f;
      const auto length = selected(some, smooth.length, infinity);
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
  store(0.0f, points.spread_variance, i);
  store(footprint.right_b1, rest.right_b1, i);
  store(footprint.right_b2, rest.right_b2, i);
  store(footprint.down_b1, rest.down_b1, i);
  store(footprint.down_b2, rest.down_b2, i);
}

template <class Spacings>
HWY_INLINE void place(const TriangleBatch& hits, const Spacings& spacings, SurfaceRest& rest,
                      ShadingPoints& points) {
  points.count = hits.count;
  find_geometric_normals(hits, points);
  for (std::size_t i = 0; i < hits.count; i += Lane::count()) {
    const auto b1 = loaded(hits.b1, i), b2 = loaded(hits.b2, i);
    const Weights w{1.0f - b1 - b2, b1, b2};
    const Vectors direction = loaded(hits.direction, i);
    const Vectors to_viewer = -direction;
    store(to_viewer, points.to_viewer, i);
    Vectors geometric = loaded(points.geometric, i);
    geometric = turned_if(dot(geometric, to_viewer) < 0.0f, geometric);
    place_points(hits, w, geometric, rest, points, i);

    const SmoothLanes smooth = smooth_normal(hits, w, geometric, i);
    const auto below = dot(smooth.normal, geometric) < 0.0f;
    const Vectors normal = turned_if(below, smooth.normal);
    const auto side = selected(below, -1.0f, 1.0f);
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
  auto all_finite = true;
  for (std::size_t i = 0; i < points.count; i += Lane::count()) {
    const auto n_dot_v =
        max(dot(loaded(points.normal, i), loaded(points.to_viewer, i)), grazing_cosine);
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
    const auto below = 1.0f - environment_specular(norms, dielectric, dielectric_f90);
    store(below, materials.below, i);
    const Vectors albedo = (1.0f - loaded(materials.metallic, i)) * loaded(materials.base_color, i);
    const Vectors ambient = loaded(materials.occlusion, i) * below * albedo;
    store(ambient, materials.ambient, i);
    const auto left = 1.0f - dielectric;
    const Vectors diffuse = (std::numbers::inv_pi_v<float> * left) * albedo;
    const auto some_left = left > 0.0f;
    const auto falloff = (dielectric_f90 - dielectric) / selected(some_left, left, 1.0f);
    store(where(some_left, falloff), points.falloff, i);
    store(diffuse, points.diffuse, i);
    store_lobe(f0, f90, roughness, points, i);
    const auto sum = sum_of(diffuse) + sum_of(shine) + sum_of(loaded(points.position, i));
    const auto lost = LaneMask::first(points.count - i) && !finite(sum);
    all_finite = all_finite && none(lost);
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
