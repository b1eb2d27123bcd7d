#include "renderer/asos/eye_caster.h"
#include "renderer/reflections/mirror_surface.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/unevenness.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// Whether one sample can stand for what a leaf looks like.

namespace asos {

Unevenness EyeCaster::uneven(SampleId sample, double share, const LeafRegion& region) const {
  const Hit& hit = hits_[sample];
  if (!hit.valid() || !std::isfinite(most_uneven_)) return Unevenness::none;
  const bool shading =
      !glints(sample, share) &&
      (shading_error(sample, share, region) > most_uneven_ || mirrors_too_widely(sample, region));
  if (extended_lights_ && !even_around(sample, region)) {
    if (shadow_uneven(sample, region)) return Unevenness::shadow;
    // What is split for its shading need not have its shadows found again for each part.
    if (shading && region.sides.empty() && opaque(sample) && nearly_flat(sample, share))
      even_.push_back(even_patch(sample, region));
  }
  return shading ? Unevenness::shading : Unevenness::none;
}

// Of what is not bounded, nor in shadow.
float EyeCaster::shading_error(SampleId sample, double share, const LeafRegion& region) const {
  const Hit& hit = hits_[sample];
  const Ray& ray = rays_[sample];
  const Patch patch = patch_of(sample, share);
  return midpoint_error(scene_.world, hit, ray.at(hit.t), -ray.direction, patch) +
         bump_error(sample, region) + light_error(sample, region);
}

// Whether a curved mirror spreads the region's corner rays too far for one reflected pyray (CGF'98
// sections 5.2.1 to 5.2.4).
bool EyeCaster::mirrors_too_widely(SampleId sample, const LeafRegion& region) const {
  if (viewer_.bounces >= shader_.reflections() || settings_.mirror.curved == CurvedMirror::tangent)
    return false;
  const Hit& hit = hits_[sample];
  const Material& material = scene_.world.material_of(hit.triangle);
  const bool mirror =
      material.dfr || static_cast<double>(material.roughness) <= settings_.mirror.roughest;
  if (!mirror || material.unlit) return false;
  const SurfacePoint point =
      surface_point(scene_.world, scene_.needs, hit, -rays_[sample].direction);
  const float side = region.square.side * static_cast<float>(block_.width);
  const IncidentPyray pyray = pyray_around(spacing_, rays_[sample], hit.t, side);
  const MirrorSurface surface = mirror_surface(scene_.world, hit, point, pyray, true);
  if (!surface.bent()) return false;
  return settings_.mirror.curved == CurvedMirror::supersample ||
         reflected_angle(pyray, surface) > glm::radians(settings_.mirror.widest_angle_deg);
}

// Whether a normal map scatters the lights' highlights all over a leaf: splitting would not make it
// even, so it is sampled as it is.
bool EyeCaster::glints(SampleId sample, double share) const {
  const Hit& hit = hits_[sample];
  if (!scene_.needs.normal_maps || !hit.valid() || !std::isfinite(most_uneven_) || share <= 0.0 ||
      settings_.asos.max_level == 0)
    return false;
  const Material& material = scene_.world.material_of(hit.triangle);
  if (!material.normal_texture.used() || material.unlit || scene_.world.lights.empty())
    return false;
  // Textures make roughness less only.
  if (!material.metallic_roughness_texture.used() && material.roughness >= least_broad_roughness)
    return false;
  const SampleExtent extent{&spacing_, &scene_.mips, side_of(share)};
  const glm::vec3 to_viewer = -rays_[sample].direction;
  const SurfacePoint point = surface_point(scene_.world, scene_.needs, hit, to_viewer, extent);
  if (!(point.spread.variance > 0.0f)) return false;
  const SurfaceMaterial seen =
      surface_material(scene_.world, scene_.needs, hit, point.footprint, &scene_.mips);
  return glint_error(scene_.world, material, seen.roughness, point.shading_normal,
                     point.spread.variance, point.position, to_viewer) > most_uneven_;
}

// Whether a leaf would be split further for its shading, were there any levels left.
bool EyeCaster::uneven_at_last(SampleId sample, double share, const LeafRegion& region) const {
  const float finest =
      std::ldexp(viewer_.pixel, -settings_.asos.max_level) / static_cast<float>(block_.width);
  return settings_.asos.max_level > 0 && std::isfinite(most_uneven_) && !region.marginal &&
         hits_[sample].valid() && region.square.side < 1.5f * finest &&
         shading_error(sample, share, region) > most_uneven_;
}

// Whether the surface leaves its plane by little, beside the patch: what lies closer to a bent
// surface than that is not looked at for its shadows' edges (ShadowPyrays::midpoint_error).
bool EyeCaster::nearly_flat(SampleId sample, double share) const {
  const Hit& hit = hits_[sample];
  const Patch patch = patch_of(sample, share);
  const float size = std::min(glm::length(patch.right), glm::length(patch.down));
  return 4.0 * scene_.features.departure(hit.triangle, glm::dvec3(rays_[sample].at(hit.t)), size) <
         static_cast<double>(size);
}

EvenPatch EyeCaster::even_patch(SampleId sample, const LeafRegion& region) const {
  return {surface_point(scene_.world, scene_.needs, hits_[sample], -rays_[sample].direction),
          region.square, std::vector<double>(shader_.lights().size(), -1.0)};
}

// The even patch of the sample's surface that the region is a part of, and not only overlaps as
// pixels with a wide filter do.
EvenPatch* EyeCaster::even_around(SampleId sample, const LeafRegion& region) const {
  const Square& s = region.square;
  const float rounding = 1e-3f * s.side;
  for (EvenPatch& even : even_) {
    const Square& all = even.square;
    const float wider = all.side - s.side + rounding;
    if (s.u >= all.u - rounding && s.u <= all.u + wider && s.v >= all.v - rounding &&
        s.v <= all.v + wider && surface(sample) == scene_.features.sheet(even.middle.triangle))
      return &even;
  }
  return nullptr;
}

// The patch around the sample that holds all of the leaf: what is long and thin, or away from its
// sample, may have a shadow's edge at its far end.
Patch EyeCaster::patch_around(SampleId sample, const LeafRegion& region) const {
  glm::vec2 farthest(0.0f);
  region.for_each_side([&](const Side& side) {
    farthest = glm::max(farthest, glm::abs(side.from - points_[sample]));
  });
  const float per_pixel = 2.0f * static_cast<float>(block_.width);
  Patch patch = patch_of(sample, 1.0);
  patch.right *= farthest.x * per_pixel;
  patch.down *= farthest.y * per_pixel;
  return patch;
}

// How light from what has a size, or a cone, falls off across a leaf.
float EyeCaster::light_error(SampleId sample, const LeafRegion& region) const {
  const Hit& hit = hits_[sample];
  if (!(extended_lights_ || spots_) || scene_.world.material_of(hit.triangle).unlit) return 0.0f;
  const Patch patch = patch_around(sample, region);
  const SurfacePoint point =
      surface_point(scene_.world, scene_.needs, hit, -rays_[sample].direction);
  float error = 0.0f;
  for (const PreparedLight& light : shader_.lights()) {
    if (extended_lights_ && light.extended())
      error += falloff_error(light, receiver_at(point), patch);
    error += cone_error(light, receiver_at(point), patch);
  }
  return error;
}

bool EyeCaster::shadow_uneven(SampleId sample, const LeafRegion& region) const {
  const Hit& hit = hits_[sample];
  const Material& material = scene_.world.material_of(hit.triangle);
  if (material.unlit) return false;
  const Patch patch = patch_around(sample, region);
  const SurfacePoint point =
      surface_point(scene_.world, scene_.needs, hit, -rays_[sample].direction);
  const glm::vec3 c = glm::clamp(glm::vec3(material.base_color), 0.0f, 1.0f);
  const float reflected = std::max({c.x, c.y, c.z}) * std::numbers::inv_pi_v<float>;
  float error = 0.0f;
  const auto lights = shader_.lights();
  for (std::uint32_t i = 0; i < lights.size() && !(error > most_uneven_); ++i) {
    if (!lights[i].casts_shadows || !lights[i].extended()) continue;
    const CountForLight count(counts_, i);
    error += shadows_.midpoint_error(lights[i], i, point, patch, reflected, counts_);
  }
  return error > most_uneven_;
}

}  // namespace asos
