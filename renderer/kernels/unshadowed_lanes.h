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
  Lanes lobe;
  Lanes fresnel;
};

/// Where a highlight lies: at the sample itself, or, by the published rule, at the light's
/// representative point.
struct ShineLanes {
  Vectors direction;
  Lanes nearness;  ///< 1 / distance
  Lanes ratio;     ///< factor of the lobe: MIS weight, or by widening (published rule)
};
HWY_INLINE SpecularLanes specular(const ShadingPoints& points, const LightConstants& light,
                                  const Vectors& normal, const ShineLanes& shown, std::size_t i) {
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const Vectors to_viewer = loaded(points.to_viewer, i);
  const auto n_dot_l = dot(normal, shown.direction);
  auto mirrors = hn::Gt(n_dot_l, zero);
  // A reflection that contains the light replaces its highlight.
  mirrors = hn::And(mirrors, hn::Lt(loaded(points.shows_lights, i), all_lanes(light.shown_from)));

  LobeGeometryLanes at;
  at.normal = normal;
  at.to_viewer = to_viewer;
  at.to_light = shown.direction;
  const Vectors sum = at.to_light + to_viewer;
  const auto length = hn::Sqrt(hn::Max(dot(sum, sum), all_lanes(1e-12f)));
  const Lanes fresnel = schlick_weight<Lane>(hn::Mul(all_lanes(0.5f), length));
  if (hn::AllFalse(FloatTag(), mirrors)) return {zero, fresnel};
  at.per_sum = hn::Div(one, length);
  at.half = scaled(at.per_sum, sum);
  at.n_dot_l = hn::Max(n_dot_l, all_lanes(grazing_cosine));
  at.n_dot_v = loaded(points.n_dot_v, i);
  at.n_dot_h = hn::Max(zero, dot(normal, at.half));
  at.alpha = loaded(points.alpha, i);
  at.light_nearness = shown.nearness;
  const auto value = hn::Mul(lobe(points, at, i), shown.ratio);
  return {hn::IfThenElseZero(mirrors, value), fresnel};
}

/// Origin and end of a shadow ray, as shadow_ray computes them.
struct RayLanes {
  Vectors origin;
  Lanes t_far;
};
HWY_INLINE RayLanes ray_to(const ShadingPoints& points, const ReceiverLanes& receiver,
                           const SampleLanes& sample, std::size_t i) {
  const auto zero = hn::Zero(FloatTag());
  const auto clear = loaded(points.clear_height, i);
  const auto along = dot(receiver.geometric, sample.direction);
  const auto cosine = hn::Abs(along);
  const auto infinite = hn::Eq(sample.distance, hn::Inf(FloatTag()));
  const auto to_edge = loaded(points.to_edge, i);
  const auto steep = hn::Div(clear, hn::Max(cosine, all_lanes(0.25f)));
  const auto way =
      hn::IfThenElseZero(infinite, hn::IfThenElse(hn::Gt(steep, to_edge), to_edge, steep));
  const auto rest = hn::Sub(clear, hn::Mul(way, cosine));
  const auto up = hn::IfThenElse(hn::Lt(along, zero), hn::Neg(rest), rest);
  const Vectors origin =
      receiver.position + (scaled(way, sample.direction) + scaled(up, receiver.geometric));
  const auto distance = hn::IfThenElse(infinite, all_lanes(1.0f), sample.distance);
  const Vectors& d = sample.direction;
  const auto size = hn::Add(hn::Add(hn::Add(hn::Abs(origin.x), hn::Mul(distance, hn::Abs(d.x))),
                                    hn::Add(hn::Abs(origin.y), hn::Mul(distance, hn::Abs(d.y)))),
                            hn::Add(hn::Abs(origin.z), hn::Mul(distance, hn::Abs(d.z))));
  constexpr float eight_ulps = 8.0f * std::numeric_limits<float>::epsilon();
  const auto error = clamped(hn::Mul(all_lanes(eight_ulps), hn::Div(size, distance)),
                             all_lanes(1e-5f), all_lanes(0.5f));
  const auto end = hn::Mul(distance, hn::Sub(all_lanes(1.0f), error));
  return {origin, hn::IfThenElse(infinite, sample.distance, end)};
}

/// The unshadowed contributions of a light to points from i on, and which of them are not zero.
struct UnshadowedLanes {
  Vectors carried;
  LaneMask kept;
};
HWY_INLINE void store_compressed(const Lanes& value, const LaneMask& kept,
                                 ShadowRayBatch::Floats& to, std::size_t at) {
  hn::CompressStore(value, kept, FloatTag(), &to[at]);
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
                                  hn::RebindMask(du, kept), du, &rays.point[at]);
}

/// Returns the irradiance from a light's form factor, limited to the largest float.
HWY_INLINE Lanes irradiance_by(Lanes form, float power) {
  const auto most = all_lanes(std::numeric_limits<float>::max());
  return hn::Min(hn::Mul(all_lanes(power), hn::Min(form, most)), most);
}

/// Form factors of the light for a point's diffuse part and its highlight, and the diffuse part's
/// loss.
struct FormLanes {
  Lanes diffuse;
  Lanes specular;
  Lanes lost;
};

/// One channel of the reflectance coefficients in ShadingPoints.
struct ReflectanceLanes {
  Lanes diffuse, falloff, f0, f90_less_f0;
};

/// Returns the light's contribution in one channel.
HWY_INLINE Lanes carried_by(const FormLanes& form, float power, const ReflectanceLanes& by,
                            const SpecularLanes& shine) {
  const auto fresnel = hn::Add(by.f0, hn::Mul(by.f90_less_f0, shine.fresnel));
  const auto falloff = hn::Mul(by.falloff, shine.fresnel);
  const auto scattered = hn::Sub(irradiance_by(form.diffuse, power),
                                 hn::Mul(falloff, irradiance_by(form.lost, power)));
  return hn::Add(hn::Mul(scattered, by.diffuse),
                 hn::Mul(irradiance_by(form.specular, power), hn::Mul(fresnel, shine.lobe)));
}

HWY_INLINE UnshadowedLanes carried_from(const ShadingPoints& points, const LightConstants& light,
                                        const ShineLanes& shown, const FormLanes& form,
                                        const LaneMask& reached, std::size_t i,
                                        ShadowRayBatch& rays) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const SpecularLanes shine = specular(points, light, loaded(points.normal, i), shown, i);
  const Vectors diffuse = loaded(points.diffuse, i), f0 = loaded(points.f0, i);
  const Vectors rest = loaded(points.f90_less_f0, i);
  const auto falloff = loaded(points.falloff, i);
  const Vectors carried{carried_by(form, light.power.x, {diffuse.x, falloff, f0.x, rest.x}, shine),
                        carried_by(form, light.power.y, {diffuse.y, falloff, f0.y, rest.y}, shine),
                        carried_by(form, light.power.z, {diffuse.z, falloff, f0.z, rest.z}, shine)};
  const auto some =
      hn::Or(hn::Ne(carried.x, zero), hn::Or(hn::Ne(carried.y, zero), hn::Ne(carried.z, zero)));
  const auto sum = hn::Add(hn::Add(carried.x, carried.y), carried.z);
  const auto finite = hn::Lt(hn::Abs(sum), hn::Inf(d));
  const auto counted = hn::And(reached, some);
  rays.rejected += hn::CountTrue(d, hn::AndNot(finite, counted));
  return {carried, hn::And(counted, finite)};
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
