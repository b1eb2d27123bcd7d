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

HWY_INLINE LightHitLanes none_met() {
  return {0.0f, 0.0f, LaneMask::first(0)};
}

HWY_INLINE LightHitLanes meet_cone(const Vectors& axis, Lane one_less_cosine,
                                   const Vectors& direction) {
  // Compare chords, since cosines near the axis have no digits left.
  const Vectors chord = direction - axis;
  const auto met = 0.5f * dot(chord, chord) <= one_less_cosine;
  const auto density = 0.5f * std::numbers::inv_pi_v<float> / one_less_cosine;
  return {infinity, density, met};
}

HWY_INLINE LightHitLanes meet_ball(const LightConstants& light, const ReceiverLanes& receiver,
                                   const Vectors& middle, const Vectors& direction) {
  const auto radius = light.radius;
  const auto distance = length(middle);
  const auto inside = distance <= radius;
  const auto sine = radius / max(distance, radius);
  const LightHitLanes cone =
      meet_cone(middle / selected(inside, 1.0f, distance), one_less_cosine(sine), direction);
  const auto along = dot(direction, middle);
  const Vectors beside = middle - along * direction;
  const auto depth2 = radius * radius - dot(beside, beside);
  const auto half_chord = sqrt(max(0.0f, depth2));
  const auto even = max(0.0f, dot(direction, receiver.normal)) * std::numbers::inv_pi_v<float>;
  return {selected(inside, along + half_chord, along - half_chord),
          selected(inside, even, cone.density), inside || cone.met};
}

/// `solid_angle`: of a light that is sampled by solid angle; else 0.
template <LightShape shape>
HWY_INLINE LightHitLanes meet_flat(const LightConstants& light, const Vectors& middle,
                                   const Vectors& direction, Lane solid_angle) {
  const Vectors towards = light.towards;
  const auto cosine = -dot(direction, towards);
  const auto height = -dot(middle, towards);
  const auto along = light.two_sided ? cosine * height : cosine;
  const auto beside = light.two_sided ? abs(height) : height;
  auto met = along > 0.0f && beside > light.thickness;
  if (none(met)) return none_met();
  const auto distance = height / selected(met, cosine, 1.0f);
  const Vectors hit = distance * direction - middle;
  if constexpr (shape == LightShape::disk) {
    met = met && dot(hit, hit) <= light.radius * light.radius;
  } else {
    const auto u = dot(hit, light.u_axis), v = dot(hit, light.v_axis);
    met = met && abs(u) <= light.u_length && abs(v) <= light.v_length;
  }
  const auto area = light.area * abs(cosine);
  const auto by_area = distance * distance / selected(met, area, 1.0f);
  const auto by_angle = solid_angle > 0.0f;
  return {distance, selected(by_angle, 1.0f / selected(by_angle, solid_angle, 1.0f), by_area), met};
}

/// Selects, among the directions that hit a polygon's bounding rectangle, those that hit the
/// polygon.
HWY_INLINE LaneMask meet_polygon(const LightConstants& light, const ReceiverLanes& receiver,
                                 const Vectors& direction, const LaneMask& met) {
  if (none(met)) return met;
  ShadingPoints::Vectors from, to;
  ShadingPoints::Floats wanted{};
  store(receiver.position, from, 0);
  store(direction, to, 0);
  store(where(met, 1.0f), wanted, 0);
  for (std::size_t k = 0; k < Lane::count(); ++k) {
    if (wanted[k] == 0.0f) continue;
    Ray ray;
    ray.origin = from.at(k);
    ray.direction = to.at(k);
    if (!meet_light(*light.light, ray)) wanted[k] = 0.0f;
  }
  return loaded(wanted, 0) > 0.0f;
}

/// Tests each direction in double precision.
HWY_INLINE LightHitLanes meet_capsule(const PreparedLight& light, const ReceiverLanes& receiver,
                                      const Vectors& direction) {
  ShadingPoints::Vectors from, normal, to;
  ShadingPoints::Floats distance{}, density{};
  store(receiver.position, from, 0);
  store(receiver.normal, normal, 0);
  store(direction, to, 0);
  for (std::size_t k = 0; k < Lane::count(); ++k) {
    const glm::dvec3 way(to.at(k));
    const Receiver at{from.at(k), normal.at(k), normal.at(k)};
    const auto hit = sampled_hit(light, at, way);
    if (!hit) continue;
    distance[k] = static_cast<float>(hit->distance);
    density[k] = static_cast<float>(hit->density);
  }
  return {loaded(distance, 0), loaded(density, 0), loaded(distance, 0) > 0.0f};
}

/// Where a direction from a receiver hits a light.
struct LobeQuery {
  const LightConstants& light;
  const ReceiverLanes& receiver;
  const Vectors& middle;
  const LightArcs& arc;
  const Vectors& direction;
  std::size_t i;
};

HWY_INLINE LightHitLanes met_light(ShapeTag<LightShape::sun>, const LobeQuery& q) {
  return meet_cone(q.light.towards, q.light.one_less_cosine, q.direction);
}
HWY_INLINE LightHitLanes met_light(ShapeTag<LightShape::ball>, const LobeQuery& q) {
  return meet_ball(q.light, q.receiver, q.middle, q.direction);
}
HWY_INLINE LightHitLanes met_light(ShapeTag<LightShape::capsule>, const LobeQuery& q) {
  return meet_capsule(*q.light.light, q.receiver, q.direction);
}
HWY_INLINE LightHitLanes met_light(ShapeTag<LightShape::rectangle> shape, const LobeQuery& q) {
  return meet_flat<shape>(q.light, q.middle, q.direction, loaded(q.arc.first, q.i));
}
HWY_INLINE LightHitLanes met_light(ShapeTag<LightShape::disk> shape, const LobeQuery& q) {
  return meet_flat<shape>(q.light, q.middle, q.direction, 0.0f);
}
HWY_INLINE LightHitLanes met_light(ShapeTag<LightShape::polygon> shape, const LobeQuery& q) {
  LightHitLanes found = meet_flat<shape>(q.light, q.middle, q.direction, 0.0f);
  found.met = meet_polygon(q.light, q.receiver, q.direction, found.met);
  return found;
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
