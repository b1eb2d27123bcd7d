#include "renderer/kernels/light_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/light_kernel.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/contour_forms.h"
#include "renderer/kernels/lobe_samples.h"
#include "renderer/kernels/unshadowed_lanes.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

template <LightShape shape>
HWY_INLINE ShineLanes shine_of(const ShadingPoints& points, const LightConstants& light,
                               const Vectors& normal, const Vectors& middle,
                               const SampleLanes& sample, std::size_t i) {
  if (light.rule == LightRule::physical) {
    ShineLanes shown{sample.direction, 1.0f / sample.distance, 1.0f};
    if constexpr (traits_of(shape).has_area()) {
      // Balance heuristic: samples of the lobe contribute the rest.
      const auto cosine = max(dot(normal, sample.direction), 0.0f);
      const auto some = sample.form > 0.0f;
      const auto density = cosine / selected(some, sample.form, 1.0f);
      const auto both = density + lobe_density(points, normal, sample.direction, i);
      const auto shared = some && density > 0.0f && samples_lobe(points, light, normal, i);
      shown.ratio = selected(shared, density / both, 1.0f);
    }
    return shown;
  }
  const Vectors to_viewer = loaded(points.to_viewer, i);
  const auto along = dot(normal, to_viewer);
  const Vectors mirrored = (along + along) * normal - to_viewer;
  const auto shown = SharedGeometry<shape>::highlight(light, middle, mirrored);
  const auto alpha = loaded(points.alpha, i);
  const auto broader = alpha + 0.5f * shown.half_angle_tangent;
  auto ratio = alpha / broader;
  if constexpr (!traits_of(shape).line) ratio *= ratio;
  const auto nearness = traits_of(shape).infinite ? 0.0f : 1.0f / sqrt(dot(middle, middle));
  return {shown.direction, nearness, ratio};
}

template <LightShape shape>
void shade_shape(const ShadingPoints& points, const LightConstants& light, const LightArcs& arc,
                 const LightPointBatch& places, ShadowRayBatch& rays) {
  for (std::size_t i = 0; i < points.count; i += Lane::count()) {
    const ReceiverLanes receiver = receivers(points, i);
    const Vectors middle = to_middle(light, receiver);
    const SampleLanes sample =
        SharedGeometry<shape>::sample(SampleQuery{light, receiver, middle, arc, places, i});
    const auto reached = LaneMask::first(points.count - i) && !(sample.form <= 0.0f);
    if (none(reached)) continue;

    const ShineLanes shown = shine_of<shape>(points, light, receiver.normal, middle, sample, i);
    const auto [carried, kept] = carried_from(
        points, light, shown, {sample.form, sample.form, sample.form}, reached, i, rays);
    if (none(kept)) continue;
    append(ray_to(points, receiver, sample, i), sample.direction, kept, rays);
    append({carried, kept}, i, rays);
  }
}

/// Computes the unshadowed contribution of samples of the lobe that hit the light.
template <LightShape shape>
void shade_lobe_of(const ShadingPoints& points, const LightConstants& light, const LobeBatch& lobes,
                   const LightArcs& arc, ShadowRayBatch& rays) {
  for (std::size_t i = 0; i < points.count; i += Lane::count()) {
    const ReceiverLanes receiver = receivers(points, i);
    const auto samples =
        LaneMask::first(points.count - i) && samples_lobe(points, light, receiver.normal, i);
    if (none(samples)) continue;
    const Vectors middle = to_middle(light, receiver);
    const Vectors direction = loaded(lobes.direction, i);
    const LightHitLanes met = met_light<shape>({light, receiver, middle, arc, direction, i});
    auto form = cosine_above(direction, receiver);
    const auto reached = samples && met.met && form > 0.0f;
    if (none(reached)) continue;
    auto density = met.density;
    const auto left = attenuation_towards(light, middle);
    form *= left;
    density = density / max(left, 1e-30f);
    const auto both = density + lobe_density(points, receiver.normal, direction, i);
    form = where(reached, form / both);
    const ShineLanes shown{direction, 1.0f / met.distance, 1.0f};
    const UnshadowedLanes found =
        carried_from(points, light, shown, {0.0f, form, 0.0f}, reached, i, rays);
    if (none(found.kept)) continue;
    append(ray_to(points, receiver, {direction, met.distance, form}, i), direction, found.kept,
           rays);
    append(found, i, rays);
  }
}

/// Returns whether any direction hits a light sampled by solid angle. Only then is the solid angle
/// needed, which costs more.
template <LightShape shape>
bool any_meets(const ShadingPoints& points, const LightConstants& light, const LobeBatch& lobes,
               const LightArcs& arc) {
  for (std::size_t i = 0; i < points.count; i += Lane::count()) {
    const ReceiverLanes receiver = receivers(points, i);
    const Vectors middle = to_middle(light, receiver);
    const Vectors direction = loaded(lobes.direction, i);
    const LightHitLanes met = SharedFlat<SharedGeometry<shape>>::meet(
        LobeQuery{light, receiver, middle, arc, direction, i});
    const auto samples =
        LaneMask::first(points.count - i) && samples_lobe(points, light, receiver.normal, i);
    if (!none(samples && met.met)) return true;
  }
  return false;
}

void shade_lobe(const ShadingPoints& points, const LightConstants& light, const LobeBatch& lobes,
                LightArcs& arc, ShadowRayBatch& rays) {
  rays.count = 0;
  rays.rejected = 0;
  if (light.rule == LightRule::published) return;
  with_shape(light.shape, [&](auto shape) HWY_ATTR {
    if constexpr (traits_of(shape).has_area()) {
      if constexpr (by_solid_angle<shape>) {
        if (!any_meets<shape>(points, light, lobes, arc)) return;
        find_arcs<shape>(points, *light.light, arc);
      }
      shade_lobe_of<shape>(points, light, lobes, arc, rays);
    }
  });
}

void choose_lobes(const ShadingPoints& points, const LightPointBatch& places, LobeBatch& lobes) {
  for (std::size_t i = 0; i < points.count; i += Lane::count())
    store(lobe_direction(points, places, i), lobes.direction, i);
}

template <LightShape shape>
void shade_closed_form(const ShadingPoints& points, const LightConstants& light,
                       const LightPointBatch& places, ShadowRayBatch& rays) {
  rays.count = 0;
  rays.rejected = 0;
  LightArcs forms, arc;
  rectangle_forms(points, *light.light, forms);
  find_places<shape>(points, *light.light, places, arc);
  for (std::size_t i = 0; i < points.count; i += Lane::count()) {
    const ReceiverLanes receiver = receivers(points, i);
    const Vectors middle = to_middle(light, receiver);
    const auto form = loaded(forms.first, i);
    const auto reached = LaneMask::first(points.count - i) && !(form <= 0.0f);
    if (none(reached)) continue;
    const SampleLanes sample =
        SharedGeometry<shape>::sample(SampleQuery{light, receiver, middle, arc, places, i});
    const ShineLanes shown = shine_of<shape>(points, light, receiver.normal, middle, sample, i);
    append(carried_from(points, light, shown, {form, sample.form, sample.form}, reached, i, rays),
           i, rays);
  }
}

void shade(const ShadingPoints& points, const LightConstants& light, const LightPointBatch& places,
           LightArcs& arc, ShadowRayBatch& rays) {
  rays.count = 0;
  rays.rejected = 0;
  with_shape(light.shape, [&](auto shape) HWY_ATTR {
    find_places<shape>(points, *light.light, places, arc);
    shade_shape<shape>(points, light, arc, places, rays);
  });
}

void shade_exactly(const ShadingPoints& points, const LightConstants& light,
                   const LightPointBatch& places, LightArcs& arc, ShadowRayBatch& rays) {
  with_shape(light.shape, [&](auto shape) HWY_ATTR {
    if constexpr (by_solid_angle<shape>)
      shade_closed_form<shape>(points, light, places, rays);
    else
      shade(points, light, places, arc, rays);
  });
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(shade);
HWY_EXPORT(shade_exactly);
HWY_EXPORT(shade_lobe);
HWY_EXPORT(choose_lobes);

void shade_batch(const ShadingPoints& points, const LightConstants& light,
                 const LightPointBatch& places, ShadowRayBatch& rays) {
  LightArcs arcs;
  shade_batch(points, light, places, arcs, rays);
}

void shade_batch(const ShadingPoints& points, const LightConstants& light,
                 const LightPointBatch& places, LightArcs& arcs, ShadowRayBatch& rays) {
  HWY_DYNAMIC_DISPATCH(shade)(points, light, places, arcs, rays);
}

void shade_unshadowed(const ShadingPoints& points, const LightConstants& light,
                      const LightPointBatch& places, ShadowRayBatch& rays) {
  LightArcs arcs;
  HWY_DYNAMIC_DISPATCH(shade_exactly)(points, light, places, arcs, rays);
}

void choose_lobes(const ShadingPoints& points, const LightPointBatch& places, LobeBatch& lobes) {
  HWY_DYNAMIC_DISPATCH(choose_lobes)(points, places, lobes);
}

void shade_lobe(const ShadingPoints& points, const LightConstants& light, const LobeBatch& lobes,
                LightArcs& arcs, ShadowRayBatch& rays) {
  HWY_DYNAMIC_DISPATCH(shade_lobe)(points, light, lobes, arcs, rays);
}

}  // namespace asos
#endif
