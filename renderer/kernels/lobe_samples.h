// Directions sampled from the GGX lobe, with one point per lane, and where they hit lights. They
// are the other half of the samples of lights with an area (Veach and Guibas 1995, "Optimally
// Combining Sampling Techniques for Monte Carlo Rendering"). Included once for each instruction
// set.
#if defined(ASOS_KERNELS_LOBE_SAMPLES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_LOBE_SAMPLES_H
#undef ASOS_KERNELS_LOBE_SAMPLES_H
#else
#define ASOS_KERNELS_LOBE_SAMPLES_H
#endif

#include "renderer/kernels/lanes.h"
#include "renderer/kernels/light_samples.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/viewed_point.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

/// Selects the points whose lobe is narrow enough to be sampled and reflects a highlight of the
/// light.
HWY_INLINE LaneMask samples_lobe(const ShadingPoints& points, const LightConstants& light,
                                 const Vectors& normal, std::size_t i) {
  constexpr float broad = least_broad_roughness * least_broad_roughness;
  auto samples =
      loaded(points.alpha, i) < broad && dot(normal, loaded(points.to_viewer, i)) > grazing_cosine;
  samples = samples && loaded(points.shows_lights, i) < light.shown_from;
  return samples;
}

/// Returns the density, by solid angle, of reflections at visible normals (Heitz 2018) in a unit
/// direction.
HWY_INLINE Lane lobe_density(const ShadingPoints& points, const Vectors& normal,
                             const Vectors& direction, std::size_t i) {
  const Vectors to_viewer = loaded(points.to_viewer, i);
  const Lane alpha = loaded(points.alpha, i), a2 = alpha * alpha, nv = dot(normal, to_viewer);
  const Vectors sum = direction + to_viewer;
  const Vectors across = cross(normal, sum);
  const Lane half2 = max(dot(sum, sum), 1e-12f);
  const Lane stretched = ggx_stretched<Lane>(a2, dot(across, across), dot(normal, sum), half2);
  return ggx_over(a2, stretched, nv + smith_root(nv, a2));
}

/// Reflects the view direction at a sampled visible normal, with the point's own roughness.
HWY_INLINE Vectors lobe_direction(const ShadingPoints& points, const LightPointBatch& places,
                                  std::size_t i) {
  const Vectors z = loaded(points.normal, i);
  const Vectors x = any_perpendicular(z), y = cross(z, x);
  const Vectors view = loaded(points.to_viewer, i);
  const Lane alpha = loaded(points.alpha, i);
  const DiskPlaces p = concentric(centred(&places.u[i]), centred(&places.v[i]));
  const LobeVector<Lane> n =
      visible_normal<Lane>({dot(view, x), dot(view, y), dot(view, z)}, alpha, alpha, p.x, p.y);
  const Vectors normal = n.x * x + n.y * y + n.z * z;
  const Vectors h = 1.0f / sqrt(dot(normal, normal)) * normal;
  const auto along = dot(h, view);
  return (along + along) * h - view;
}

/// Where a direction hits a light, and the density of the light's samples there, by solid angle.
struct LightHitLanes {
  Lane distance;
  Lane density;
  LaneMask met;
};

/// A direction from a receiver to a light, with numbers as in SampleQuery.
struct LobeQuery {
  using Hit = LightHitLanes;

  const LightConstants& light;
  const ReceiverLanes& receiver;
  const Vectors& middle;
  const LightArcs& arc;
  const Vectors& direction;
  std::size_t i;

  [[nodiscard]] HWY_INLINE Numbers<Lane> numbers() const { return {loaded(arc.first, i)}; }
};

/// Tests directions one after another, in double precision.
HWY_INLINE LightHitLanes scalar_hits(const LobeQuery& q, const LaneMask& wanted) {
  ShadingPoints::Vectors from, normal, to;
  ShadingPoints::Floats distance{}, density{}, some;
  store(q.receiver.position, from, 0);
  store(q.receiver.normal, normal, 0);
  store(q.direction, to, 0);
  store(where(wanted, 1.0f), some, 0);
  for (std::size_t k = 0; k < Lane::count(); ++k) {
    if (some[k] == 0.0f) continue;
    const Receiver at{from.at(k), normal.at(k), normal.at(k)};
    const auto hit = sampled_hit(*q.light.light, at, glm::dvec3(to.at(k)));
    if (!hit) continue;
    distance[k] = static_cast<float>(hit->distance);
    density[k] = static_cast<float>(hit->density);
  }
  return {loaded(distance, 0), loaded(density, 0), loaded(distance, 0) > 0.0f};
}

template <LightShape shape>
HWY_INLINE LightHitLanes met_light(const LobeQuery& q) {
  const LightHitLanes hit = SharedGeometry<shape>::meet(q);
  if constexpr (!traits_of(shape).scalar_hits()) return hit;
  return none(hit.met) ? hit : scalar_hits(q, hit.met);
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
