#include "renderer/kernels/aim_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/aim_kernel.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// Include after foreach_target.h, whose definitions these use.
#include "renderer/kernels/unshadowed_lanes.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

template <LightShape shape>
HWY_INLINE SampleLanes place_on(const LightConstants& light, const ReceiverLanes& receiver,
                                const LightArcs& arc, const LightPointBatch& places,
                                std::size_t i) {
  const Vectors middle = to_middle(light, receiver);
  const SampleQuery q{light, receiver, middle, arc, places, i};
  if constexpr (by_solid_angle<shape>) return SharedGeometry<shape>::place(q);
  return SharedGeometry<shape>::sample(q);
}

template <LightShape shape>
void aim_at(const ShadingPoints& points, const LightConstants& light, const LightArcs& arc,
            const LightPointBatch& places, RayWeighting by, ShadowRayBatch& rays) {
  for (std::size_t i = 0; i < points.count; i += Lane::count()) {
    const ReceiverLanes receiver = receivers(points, i);
    const SampleLanes sample = place_on<shape>(light, receiver, arc, places, i);
    const auto reached = LaneMask::first(points.count - i) && sample.form > 0.0f;
    if (none(reached)) continue;
    auto weight = sample.form;
    auto kept = reached && weight < infinity;
    if (by == RayWeighting::radiance) {
      const ShineLanes shown{sample.direction, 1.0f / sample.distance, 1.0f};
      const UnshadowedLanes found = carried_from(
          points, light, shown, {sample.form, sample.form, sample.form}, reached, i, rays);
      weight = (found.carried.x + found.carried.y + found.carried.z) * (1.0f / 3.0f);
      kept = found.kept && weight > 0.0f;
    }
    if (none(kept)) continue;
    append(ray_to(points, receiver, sample, i), sample.direction, kept, rays);
    weight.store_if(kept, &rays.carried[0][rays.count]);
    rays.count += count(kept);
  }
}

void aim(const ShadingPoints& points, const LightConstants& light, const LightPointBatch& places,
         RayWeighting by, ShadowRayBatch& rays) {
  rays.count = 0;
  rays.rejected = 0;
  LightArcs arc;
  with_shape(light.shape, [&](auto shape) HWY_ATTR {
    // Here all places on flat lights are chosen by area.
    if constexpr (!by_solid_angle<shape>) find_places<shape>(points, *light.light, places, arc);
    aim_at<shape>(points, light, arc, places, by, rays);
  });
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(aim);

void aim_batch(const ShadingPoints& points, const LightConstants& light,
               const LightPointBatch& places, RayWeighting by, ShadowRayBatch& rays) {
  HWY_DYNAMIC_DISPATCH(aim)(points, light, places, by, rays);
}

}  // namespace asos
#endif
