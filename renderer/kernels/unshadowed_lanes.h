// Unshadowed contribution of a light at a point, and the shadow rays that test its visibility, with
// one point per lane. Included once for each instruction set.
#if defined(ASOS_KERNELS_CARRIED_LIGHT_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_CARRIED_LIGHT_H
#undef ASOS_KERNELS_CARRIED_LIGHT_H
#else
#define ASOS_KERNELS_CARRIED_LIGHT_H
#endif

#include "renderer/kernels/light_kernel.h"
#include "renderer/kernels/light_samples.h"
#include "renderer/kernels/lobes.h"
#include "renderer/shading/viewed_point.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

/// The value of the lobe in the direction of the highlight, and Schlick's (1 - v.h)^5.
struct SpecularLanes {
  Lane lobe;
  Lane fresnel;
};

/// Where a highlight lies: at the sample itself, or, by the published rule, at the light's
/// representative point.
struct ShineLanes {
  Vectors direction;
  Lane nearness;  ///< 1 / distance
  Lane ratio;     ///< factor of the lobe: MIS weight, or by widening (published rule)
};
HWY_INLINE SpecularLanes specular(const ShadingPoints& points, const LightConstants& light,
                                  const Vectors& normal, const ShineLanes& shown, std::size_t i) {
  const Vectors to_viewer = loaded(points.to_viewer, i);
  const auto n_dot_l = dot(normal, shown.direction);
  auto mirrors = n_dot_l > 0.0f;
  // A reflection that contains the light replaces its highlight.
  mirrors = mirrors && loaded(points.shows_lights, i) < light.shown_from;

  LobeGeometryLanes at;
  at.normal = normal;
  at.to_viewer = to_viewer;
  at.to_light = shown.direction;
  const Vectors sum = at.to_light + to_viewer;
  const auto length = sqrt(max(dot(sum, sum), 1e-12f));
  const Lane fresnel = schlick_weight<Lane>(0.5f * length);
  if (none(mirrors)) return {0.0f, fresnel};
  at.per_sum = 1.0f / length;
  at.half = at.per_sum * sum;
  at.n_dot_l = max(n_dot_l, grazing_cosine);
  at.n_dot_v = loaded(points.n_dot_v, i);
  at.n_dot_h = max(0.0f, dot(normal, at.half));
  at.alpha = loaded(points.alpha, i);
  at.light_nearness = shown.nearness;
  const auto value = lobe(points, at, i) * shown.ratio;
  return {where(mirrors, value), fresnel};
}

/// Origin and end of a shadow ray, as shadow_ray computes them.
struct RayLanes {
  Vectors origin;
  Lane t_far;
};
HWY_INLINE RayLanes ray_to(const ShadingPoints& points, const ReceiverLanes& receiver,
                           const SampleLanes& sample, std::size_t i) {
  const auto clear = loaded(points.clear_height, i);
  const auto along = dot(receiver.geometric, sample.direction);
  const auto cosine = abs(along);
  const auto infinite = sample.distance == infinity;
  const auto to_edge = loaded(points.to_edge, i);
  const auto steep = clear / max(cosine, 0.25f);
  const auto way = where(infinite, selected(steep > to_edge, to_edge, steep));
  const auto rest = clear - way * cosine;
  const auto up = selected(along < 0.0f, -rest, rest);
  const Vectors origin = receiver.position + (way * sample.direction + up * receiver.geometric);
  const auto distance = selected(infinite, 1.0f, sample.distance);
  const Vectors& d = sample.direction;
  const auto size = abs(origin.x) + distance * abs(d.x) + (abs(origin.y) + distance * abs(d.y)) +
                    (abs(origin.z) + distance * abs(d.z));
  constexpr float eight_ulps = 8.0f * std::numeric_limits<float>::epsilon();
  const auto error = clamp(eight_ulps * (size / distance), 1e-5f, 0.5f);
  const auto end = distance * (1.0f - error);
  return {origin, selected(infinite, sample.distance, end)};
}

/// The unshadowed contributions of a light to points from i on, and which of them are not zero.
struct UnshadowedLanes {
  Vectors carried;
  LaneMask kept;
};
HWY_INLINE void store_compressed(const Lane& value, const LaneMask& kept,
                                 ShadowRayBatch::Floats& to, std::size_t at) {
  value.store_if(kept, &to[at]);
}

HWY_INLINE void append(const RayLanes& ray, const Vectors& direction, const LaneMask& kept,
                       ShadowRayBatch& rays) {
  const std::size_t at = rays.count;
  store_compressed(ray.origin.x, kept, rays.origin[0], at);
  store_compressed(ray.origin.y, kept, rays.origin[1], at);
  store_compressed(ray.origin.z, kept, rays.origin[2], at);
  store_compressed(direction.x, kept, rays.direction[0], at);
  store_compressed(direction.y, kept, rays.direction[1], at);
  store_compressed(direction.z, kept, rays.direction[2], at);
  store_compressed(ray.t_far, kept, rays.t_far, at);
}

HWY_INLINE void append(const UnshadowedLanes& found, std::size_t first, ShadowRayBatch& rays) {
  const std::size_t at = rays.count;
  const auto& [carried, kept] = found;
  store_compressed(carried.x, kept, rays.carried[0], at);
  store_compressed(carried.y, kept, rays.carried[1], at);
  store_compressed(carried.z, kept, rays.carried[2], at);
  const hn::RebindToUnsigned<FloatTag> du;
  rays.count += hn::CompressStore(hn::Iota(du, static_cast<std::uint32_t>(first)),
                                  hn::RebindMask(du, kept.raw), du, &rays.point[at]);
}

/// Returns the irradiance from a light's form factor, limited to the largest float.
HWY_INLINE Lane irradiance_by(Lane form, float power) {
  const auto most = std::numeric_limits<float>::max();
  return min(power * min(form, most), most);
}

/// Form factors of the light for a point's diffuse part and its highlight, and the diffuse part's
/// loss.
struct FormLanes {
  Lane diffuse;
  Lane specular;
  Lane lost;
};

/// One channel of the reflectance coefficients in ShadingPoints.
struct ReflectanceLanes {
  Lane diffuse, falloff, f0, f90_less_f0;
};

/// Returns the light's contribution in one channel.
HWY_INLINE Lane carried_by(const FormLanes& form, float power, const ReflectanceLanes& by,
                           const SpecularLanes& shine) {
  const auto fresnel = by.f0 + by.f90_less_f0 * shine.fresnel;
  const auto falloff = by.falloff * shine.fresnel;
  const auto scattered =
      irradiance_by(form.diffuse, power) - falloff * irradiance_by(form.lost, power);
  return scattered * by.diffuse + irradiance_by(form.specular, power) * (fresnel * shine.lobe);
}

HWY_INLINE UnshadowedLanes carried_from(const ShadingPoints& points, const LightConstants& light,
                                        const ShineLanes& shown, const FormLanes& form,
                                        const LaneMask& reached, std::size_t i,
                                        ShadowRayBatch& rays) {
  const SpecularLanes shine = specular(points, light, loaded(points.normal, i), shown, i);
  const Vectors diffuse = loaded(points.diffuse, i), f0 = loaded(points.f0, i);
  const Vectors rest = loaded(points.f90_less_f0, i);
  const auto falloff = loaded(points.falloff, i);
  const Vectors carried{carried_by(form, light.power.x, {diffuse.x, falloff, f0.x, rest.x}, shine),
                        carried_by(form, light.power.y, {diffuse.y, falloff, f0.y, rest.y}, shine),
                        carried_by(form, light.power.z, {diffuse.z, falloff, f0.z, rest.z}, shine)};
  const auto some = carried.x != 0.0f || carried.y != 0.0f || carried.z != 0.0f;
  const auto sum = carried.x + carried.y + carried.z;
  const auto finite = abs(sum) < infinity;
  const auto counted = reached && some;
  rays.rejected += count(counted && !finite);
  return {carried, counted && finite};
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
