#include "renderer/kernels/light_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/kernels/light_kernel.cpp"
#include <hwy/foreach_target.h>  // this file again, once for each instruction set
// After it, for what it defines.
#include "renderer/kernels/contour_forms.h"
#include "renderer/kernels/lobe_samples.h"
#include "renderer/kernels/lobes.h"
#include "renderer/shading/viewed_point.h"

#include <hwy/highway.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {
namespace {

/// The lobe that the light's highlight is, and Schlick's (1 - v.h)^5.
struct SpecularLanes {
  Lanes lobe;
  Lanes fresnel;
};

/// Where a highlight lies: at the sample itself, or at what stands for the whole light by the
/// published rule.
struct ShineLanes {
  Vectors direction;
  Lanes nearness;  ///< 1 / distance
  Lanes ratio;     ///< of what the lobe's peak is to what it would be
};
template <LightConstants::Shape shape>
HWY_INLINE ShineLanes shine_of(const LitBatch& points, const LightConstants& light,
                               const Vectors& normal, const Vectors& middle,
                               const SampleLanes& sample, std::size_t i) {
  using Shape = LightConstants::Shape;
  const auto one = all_lanes(1.0f);
  if (!light.representative) {
    ShineLanes shown{sample.direction, hn::Div(one, sample.distance), one};
    if constexpr (has_area(shape)) {
      // The balance heuristic: the lobe's own samples give the rest.
      const auto cosine = hn::Max(dot(normal, sample.direction), hn::Zero(FloatTag()));
      const auto some = hn::Gt(sample.form, hn::Zero(FloatTag()));
      const auto density = hn::Div(cosine, hn::IfThenElse(some, sample.form, one));
      const auto both = hn::Add(density, lobe_density(points, normal, sample.direction, i));
      const auto shared = hn::And(some, hn::And(hn::Gt(density, hn::Zero(FloatTag())),
                                                samples_lobe(points, light, normal, i)));
      shown.ratio = hn::IfThenElse(shared, hn::Div(density, both), one);
    }
    return shown;
  }
  const Vectors to_viewer = loaded(points.to_viewer, i);
  const auto along = dot(normal, to_viewer);
  const Vectors mirrored = scaled(hn::Add(along, along), normal) - to_viewer;
  const HighlightLanes shown = highlight<shape>(light, middle, mirrored);
  const auto alpha = loaded(points.alpha, i);
  const auto broader = hn::Add(alpha, hn::Mul(all_lanes(0.5f), shown.half_angle_tangent));
  auto ratio = hn::Div(alpha, broader);
  if constexpr (shape != Shape::segment) ratio = hn::Mul(ratio, ratio);
  constexpr bool far = shape == Shape::distant || shape == Shape::sun;
  const auto nearness = far ? hn::Zero(FloatTag()) : hn::Div(one, hn::Sqrt(dot(middle, middle)));
  return {shown.direction, nearness, ratio};
}

HWY_INLINE SpecularLanes specular(const LitBatch& points, const LightConstants& light,
                                  const Vectors& normal, const ShineLanes& shown, std::size_t i) {
  const auto zero = hn::Zero(FloatTag()), one = all_lanes(1.0f);
  const Vectors to_viewer = loaded(points.to_viewer, i);
  const auto n_dot_l = dot(normal, shown.direction);
  auto mirrors = hn::Gt(n_dot_l, zero);
  // Reflections show the lights that have an area: those are their highlights.
  mirrors = hn::And(mirrors, hn::Lt(loaded(points.shows_lights, i), all_lanes(light.shown_from)));

  SightLanes at;
  at.normal = normal;
  at.to_viewer = to_viewer;
  at.to_light = shown.direction;
  const Vectors sum = at.to_light + to_viewer;
  const auto length = hn::Sqrt(hn::Max(dot(sum, sum), all_lanes(1e-12f)));
  const auto m = clamped(hn::Sub(one, hn::Mul(all_lanes(0.5f), length)), zero, one);
  const auto m2 = hn::Mul(m, m);
  const auto fresnel = hn::Mul(hn::Mul(m2, m2), m);
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

/// shadow_ray's origin and end.
struct RayLanes {
  Vectors origin;
  Lanes t_far;
};
HWY_INLINE RayLanes ray_to(const LitBatch& points, const ReceiverLanes& receiver,
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

/// What reaches points i and on of a light and goes on to the viewer, and of which of them.
struct CarriedLanes {
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

HWY_INLINE void append(const CarriedLanes& found, std::size_t first, ShadowRayBatch& rays) {
  const std::size_t at = rays.count;
  const auto& [carried, kept] = found;
  store_compressed(carried.x, kept, rays.carried[0], at);
  store_compressed(carried.y, kept, rays.carried[1], at);
  store_compressed(carried.z, kept, rays.carried[2], at);
  const hn::RebindToUnsigned<FloatTag> du;
  rays.count += hn::CompressStore(hn::Iota(du, static_cast<std::uint32_t>(first)),
                                  hn::RebindMask(du, kept), du, &rays.point[at]);
}

/// The irradiance by the light's form, at most what a float holds.
HWY_INLINE Lanes irradiance_by(Lanes form, float power) {
  const auto most = all_lanes(std::numeric_limits<float>::max());
  return hn::Min(hn::Mul(all_lanes(power), hn::Min(form, most)), most);
}

/// The forms of the light that the diffuse part of a point sees, its highlight, and what the
/// diffuse part loses.
struct FormLanes {
  Lanes diffuse;
  Lanes specular;
  Lanes lost;
};

/// A channel of what a point makes of irradiance: LitBatch's.
struct ReflectanceLanes {
  Lanes diffuse, falloff, f0, f90_less_f0;
};

/// What a channel of the light carries.
HWY_INLINE Lanes carried_by(const FormLanes& form, float power, const ReflectanceLanes& by,
                            const SpecularLanes& shine) {
  const auto fresnel = hn::Add(by.f0, hn::Mul(by.f90_less_f0, shine.fresnel));
  const auto falloff = hn::Mul(by.falloff, shine.fresnel);
  const auto scattered = hn::Sub(irradiance_by(form.diffuse, power),
                                 hn::Mul(falloff, irradiance_by(form.lost, power)));
  return hn::Add(hn::Mul(scattered, by.diffuse),
                 hn::Mul(irradiance_by(form.specular, power), hn::Mul(fresnel, shine.lobe)));
}

HWY_INLINE CarriedLanes carried_from(const LitBatch& points, const LightConstants& light,
                                     const ShineLanes& shown, const FormLanes& form,
                                     const LaneMask& reached, std::size_t i, ShadowRayBatch& rays) {
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

template <LightConstants::Shape shape>
void shade_shape(const LitBatch& points, const LightConstants& light, const ArcPlaces& arc,
                 const LightPlaceBatch& places, ShadowRayBatch& rays) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const ReceiverLanes receiver{loaded(points.position, i), loaded(points.geometric, i),
                                 loaded(points.normal, i)};
    const Vectors middle =
        (all_lanes(light.position) - receiver.position) + all_lanes(light.position_rest);
    const SampleLanes sample = light_sample<shape>(light, receiver, middle, arc, places, i);
    const auto reached =
        hn::And(hn::FirstN(d, points.count - i), hn::Not(hn::Le(sample.form, zero)));
    if (hn::AllFalse(d, reached)) continue;

    const ShineLanes shown = shine_of<shape>(points, light, receiver.normal, middle, sample, i);
    const auto [carried, kept] = carried_from(
        points, light, shown, {sample.form, sample.form, sample.form}, reached, i, rays);
    if (hn::AllFalse(d, kept)) continue;
    append(ray_to(points, receiver, sample, i), sample.direction, kept, rays);
    append({carried, kept}, i, rays);
  }
}

/// What samples of the lobe carry of what they meet.
template <LightConstants::Shape shape>
void shade_lobe_of(const LitBatch& points, const LightConstants& light, const LobeBatch& lobes,
                   const ArcPlaces& arc, ShadowRayBatch& rays) {
  const FloatTag d;
  const auto zero = hn::Zero(d), one = all_lanes(1.0f);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const ReceiverLanes receiver{loaded(points.position, i), loaded(points.geometric, i),
                                 loaded(points.normal, i)};
    const auto samples =
        hn::And(hn::FirstN(d, points.count - i), samples_lobe(points, light, receiver.normal, i));
    if (hn::AllFalse(d, samples)) continue;
    const Vectors middle =
        (all_lanes(light.position) - receiver.position) + all_lanes(light.position_rest);
    const Vectors direction = loaded(lobes.direction, i);
    const MetLight met = met_light<shape>(light, receiver, middle, arc, direction, i);
    auto form = cosine_above(direction, receiver);
    const auto reached = hn::And(samples, hn::And(met.met, hn::Gt(form, zero)));
    if (hn::AllFalse(d, reached)) continue;
    auto density = met.density;
    if constexpr (shape == LightConstants::Shape::ball) {
      if (light.attenuates) {
        const Offset at = towards_point(middle);
        const auto left = attenuation(light, middle, at.sample.distance, at.nearness);
        form = hn::Mul(form, left);
        density = hn::Div(density, hn::Max(left, all_lanes(1e-30f)));
      }
    }
    const auto both = hn::Add(density, lobe_density(points, receiver.normal, direction, i));
    form = hn::IfThenElseZero(reached, hn::Div(form, both));
    const ShineLanes shown{direction, hn::Div(one, met.distance), one};
    const CarriedLanes found =
        carried_from(points, light, shown, {zero, form, zero}, reached, i, rays);
    if (hn::AllFalse(d, found.kept)) continue;
    append(ray_to(points, receiver, {direction, met.distance, form}, i), direction, found.kept,
           rays);
    append(found, i, rays);
  }
}

/// Whether any direction meets a rectangle: what its solid angle is, which takes longer, matters
/// only then.
bool any_meets_rectangle(const LitBatch& points, const LightConstants& light,
                         const LobeBatch& lobes) {
  const FloatTag d;
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const Vectors normal = loaded(points.normal, i);
    const Vectors middle =
        (all_lanes(light.position) - loaded(points.position, i)) + all_lanes(light.position_rest);
    const MetLight met = meet_flat<LightConstants::Shape::rectangle>(
        light, middle, loaded(lobes.direction, i), hn::Zero(d));
    const auto samples =
        hn::And(hn::FirstN(d, points.count - i), samples_lobe(points, light, normal, i));
    if (!hn::AllFalse(d, hn::And(samples, met.met))) return true;
  }
  return false;
}

void shade_lobe(const LitBatch& points, const LightConstants& light, const LobeBatch& lobes,
                ShadowRayBatch& rays) {
  using Shape = LightConstants::Shape;
  rays.count = 0;
  rays.rejected = 0;
  if (light.representative) return;
  ArcPlaces arc;
  switch (light.shape) {
    case Shape::ball:
      return shade_lobe_of<Shape::ball>(points, light, lobes, arc, rays);
    case Shape::sun:
      return shade_lobe_of<Shape::sun>(points, light, lobes, arc, rays);
    case Shape::disk:
      return shade_lobe_of<Shape::disk>(points, light, lobes, arc, rays);
    case Shape::rectangle:
      if (!any_meets_rectangle(points, light, lobes)) return;
      rectangle_places(points, *light.light, {}, arc);
      return shade_lobe_of<Shape::rectangle>(points, light, lobes, arc, rays);
    case Shape::polygon:
      return shade_lobe_of<Shape::polygon>(points, light, lobes, arc, rays);
    case Shape::point:
    case Shape::distant:
    case Shape::segment:
      return;
  }
}

void choose_lobes(const LitBatch& points, const LightPlaceBatch& places, LobeBatch& lobes) {
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(FloatTag()))
    store(lobe_direction(points, places, i), lobes.direction, i);
}

void shade_closed_form(const LitBatch& points, const LightConstants& light,
                       const LightPlaceBatch& places, ShadowRayBatch& rays) {
  constexpr auto shape = LightConstants::Shape::rectangle;
  const FloatTag d;
  const auto zero = hn::Zero(d);
  rays.count = 0;
  rays.rejected = 0;
  ArcPlaces forms, arc;
  rectangle_forms(points, *light.light, forms);
  rectangle_places(points, *light.light, places, arc);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const ReceiverLanes receiver{loaded(points.position, i), loaded(points.geometric, i),
                                 loaded(points.normal, i)};
    const Vectors middle =
        (all_lanes(light.position) - receiver.position) + all_lanes(light.position_rest);
    const auto form = loaded(forms.first, i);
    const auto reached = hn::And(hn::FirstN(d, points.count - i), hn::Not(hn::Le(form, zero)));
    if (hn::AllFalse(d, reached)) continue;
    const SampleLanes sample = light_sample<shape>(light, receiver, middle, arc, places, i);
    const ShineLanes shown = shine_of<shape>(points, light, receiver.normal, middle, sample, i);
    append(carried_from(points, light, shown, {form, sample.form, sample.form}, reached, i, rays),
           i, rays);
  }
}

void shade(const LitBatch& points, const LightConstants& light, const LightPlaceBatch& places,
           ShadowRayBatch& rays) {
  using Shape = LightConstants::Shape;
  rays.count = 0;
  rays.rejected = 0;
  ArcPlaces arc;
  switch (light.shape) {
    case Shape::point:
      return shade_shape<Shape::point>(points, light, arc, places, rays);
    case Shape::distant:
      return shade_shape<Shape::distant>(points, light, arc, places, rays);
    case Shape::ball:
      return shade_shape<Shape::ball>(points, light, arc, places, rays);
    case Shape::sun:
      return shade_shape<Shape::sun>(points, light, arc, places, rays);
    case Shape::disk:
      return shade_shape<Shape::disk>(points, light, arc, places, rays);
    case Shape::segment:
      segment_places(points, *light.light, places, arc);
      return shade_shape<Shape::segment>(points, light, arc, places, rays);
    case Shape::rectangle:
      rectangle_places(points, *light.light, places, arc);
      return shade_shape<Shape::rectangle>(points, light, arc, places, rays);
    case Shape::polygon:
      polygon_places(points, *light.light, places, arc);
      return shade_shape<Shape::polygon>(points, light, arc, places, rays);
  }
}

}  // namespace
}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace asos {

HWY_EXPORT(shade);
HWY_EXPORT(shade_closed_form);
HWY_EXPORT(shade_lobe);
HWY_EXPORT(choose_lobes);

void shade_batch(const LitBatch& points, const LightConstants& light, const LightPlaceBatch& places,
                 ShadowRayBatch& rays) {
  HWY_DYNAMIC_DISPATCH(shade)(points, light, places, rays);
}

void shade_unshadowed(const LitBatch& points, const LightConstants& light,
                      const LightPlaceBatch& places, ShadowRayBatch& rays) {
  HWY_DYNAMIC_DISPATCH(shade_closed_form)(points, light, places, rays);
}

void choose_lobes(const LitBatch& points, const LightPlaceBatch& places, LobeBatch& lobes) {
  HWY_DYNAMIC_DISPATCH(choose_lobes)(points, places, lobes);
}

void shade_lobe(const LitBatch& points, const LightConstants& light, const LobeBatch& lobes,
                ShadowRayBatch& rays) {
  HWY_DYNAMIC_DISPATCH(shade_lobe)(points, light, lobes, rays);
}

}  // namespace asos
#endif
