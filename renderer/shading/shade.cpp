#include "renderer/shading/shade.h"

#include "renderer/rays/surface_kind.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/lobe.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// The share of a layer behind others below which no display shows it, even at +8 stops.
constexpr float invisible_share = 1.0f / (256.0f * 256.0f);

// A smooth normal may turn away from the viewer near a mesh's outline, where no real surface could.
// The lobe's denominator needs a positive angle; one this small is within a tenth of a degree.
constexpr float grazing_cosine = 1.0f / 512.0f;

/// Where the ray goes on behind a surface it has met: beyond the error of the hit's distance.
float behind(const Ray& ray, const SurfacePoint& point, float t) {
  const float length = glm::length(ray.direction);
  const glm::vec3 d = ray.direction / length;
  const float across = std::abs(glm::dot(point.geometric_normal, d));
  // The surface's own error along its normal, seen along the ray; at most 64 times that for rays
  // that graze it. A triangle met twice all the same is noticed by its index.
  const glm::vec3 moved = spawn_origin(point, point.geometric_normal) - point.position;
  const float error = glm::length(moved) / (std::max(across, 1.0f / 64.0f) * length);
  return std::max(std::nextafter(t, std::numeric_limits<float>::infinity()), t + error);
}

}  // namespace

Shader::Shader(const World& world, const SceneNeeds& needs, const RayScene& rays,
               ShadingSettings settings)
    : world_(world), needs_(needs), rays_(rays), settings_(settings) {
  lights_.reserve(world.lights.size());
  for (const Light& light : world.lights) lights_.push_back(prepare_light(light));
}

float Shader::visibility(const PreparedLight& light, const SurfacePoint& point, glm::vec3 direction,
                         RenderStatistics& counts) const {
  if (!light.casts_shadows || !settings_.shadows) return 1.0f;
  ++counts.shadow_rays;
  Ray ray;
  ray.origin = spawn_origin(point, direction);
  if (light.type == Light::Type::directional) {
    ray.direction = direction;
    return rays_.transmittance(ray);
  }
  // The light lies at t = 1; the subtraction and the test of a lamp's own glass right at the light
  // err by some units in the last place of the coordinates.
  ray.direction = light.position - ray.origin;
  const glm::vec3 size = glm::abs(light.position) + glm::abs(ray.origin);
  const float relative = (size.x + size.y + size.z) / glm::length(ray.direction);
  ray.t_far = 1.0f - std::min(0.5f, 4.0f * std::numeric_limits<float>::epsilon() * relative);
  return rays_.transmittance(ray);
}

glm::vec3 Shader::reflected(const SurfacePoint& point, const SurfaceMaterial& material,
                            glm::vec3 to_viewer, RenderStatistics& counts) const {
  const glm::vec3 n = point.shading_normal;
  const float n_dot_v = std::max(glm::dot(n, to_viewer), grazing_cosine);

  // The constant sky, in closed form and unoccluded.
  const ViewedMaterial seen = viewed(material, n_dot_v);
  glm::vec3 sum = ambient_radiance * (seen.diffuse + seen.specular);

  const PatchLobe lobe(point.spread, seen.roughness, n);

  // Punctual lights: none reaches a surface from behind, whatever its shading normal says.
  for (const PreparedLight& light : lights_) {
    const Incident incident = incident_light(light, point.position);
    const float n_dot_l = glm::dot(n, incident.direction);
    if (n_dot_l <= 0.0f || glm::dot(point.geometric_normal, incident.direction) <= 0.0f) continue;
    if (incident.irradiance == glm::vec3(0.0f)) continue;
    const glm::vec3 half = glm::normalize(incident.direction + to_viewer);
    const BrdfAngles angles{n_dot_l, n_dot_v, std::max(0.0f, glm::dot(n, half)),
                            std::max(0.0f, glm::dot(to_viewer, half))};
    const glm::vec3 share_out =
        lobe.wider() ? brdf(seen, angles, lobe.value(half, incident.direction, to_viewer, angles))
                     : brdf(seen, angles);
    const glm::vec3 light_out = share_out * incident.irradiance * n_dot_l;
    if (light_out == glm::vec3(0.0f)) continue;
    const float share = visibility(light, point, incident.direction, counts);
    if (share > 0.0f) sum += share * light_out;
  }
  return sum;
}

glm::vec3 Shader::radiance(const Ray& first_ray, const Hit& first_hit, float side,
                           RenderStatistics& counts) const {
  const SampleExtent extent{&settings_.spacing, settings_.mips, side};
  const MipChains* mips = extent.point() ? nullptr : settings_.mips;
  glm::vec3 sum{0.0f};
  glm::vec3 share{1.0f};  // of what lies behind the layers so far
  Ray ray = first_ray;
  Hit hit = first_hit;
  std::uint32_t last = Hit::none;
  const glm::vec3 to_viewer = -glm::normalize(ray.direction);

  for (int layer = 0; layer < max_layers; ++layer) {
    if (!hit.valid()) return sum + share * background_radiance;
    const SurfacePoint point = surface_point(world_, needs_, hit, to_viewer, extent);
    const bool blended = surface_kind(world_.material_of(hit.triangle)) == SurfaceKind::blended;

    if (hit.triangle != last) {
      // Add the layer by its opacity.
      const SurfaceMaterial material = surface_material(world_, needs_, hit, point.footprint, mips);
      if (material.opacity > 0.0f) {
        const glm::vec3 out =
            material.unlit ? material.base_color * (1.0f - material.transmission)
                           : material.emission + reflected(point, material, to_viewer, counts);
        sum += share * (material.opacity * out);
      }
      if (!blended) return sum;
      // Thin glass tints what shines through it by its base colour.
      share *= (1.0f - material.opacity) +
               material.opacity * material.transmission * material.base_color;
      if (std::max({share.x, share.y, share.z}) < invisible_share) return sum;
      last = hit.triangle;
    }

    // Go on behind it.
    ray.t_near = behind(ray, point, hit.t);
    hit = rays_.closest(ray);
    ++counts.eye_rays;
  }
  return sum;
}

}  // namespace asos
