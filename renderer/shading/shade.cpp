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

/// A point as it is seen.
struct ViewedPoint {
  const SurfacePoint& point;
  glm::vec3 to_viewer;
  float n_dot_v;
};

/// Radiance towards the viewer per irradiance from a light. The lobe's part is that of the light's
/// representative point, made as broad as the light by the ratio of what its width was to what it
/// would be (Karis 2013): of the whole light, whatever is visible of it.
glm::vec3 reflected_share(const PreparedLight& light, const ViewedMaterial& seen,
                          const PatchLobe& lobe, const ViewedPoint& view,
                          const Highlight& highlight) {
  const glm::vec3 n = view.point.shading_normal;
  const glm::vec3 l = highlight.direction;
  // What would be mirrored from below the horizon is not.
  if (!(glm::dot(n, l) > 0.0f)) return brdf(seen, {}, 0.0f);
  const glm::vec3 half = glm::normalize(l + view.to_viewer);
  const BrdfAngles angles{std::max(glm::dot(n, l), grazing_cosine), view.n_dot_v,
                          std::max(0.0f, glm::dot(n, half)),
                          std::max(0.0f, glm::dot(view.to_viewer, half))};
  float value =
      lobe.wider() ? lobe.value(half, l, view.to_viewer, angles) : ggx_lobe(seen.roughness, angles);
  if (highlight.half_angle_tangent > 0.0f) {
    const float roughness = std::max(seen.roughness, roughness_floor);
    const float width = roughness * roughness;
    const float ratio = width / (width + 0.5f * highlight.half_angle_tangent);
    value *= light.shape == PreparedLight::Shape::segment ? ratio : ratio * ratio;
  }
  return brdf(seen, angles, value);
}

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
  for (const Light& light : world.lights)
    lights_.push_back(prepare_light(light, settings.light_rule));
  if (!settings.light_cuts) return;
  const std::size_t count = std::min(lights_.size(), settings.light_cuts->size());
  for (std::size_t i = 0; i < count; ++i) lights_[i].cuts = (*settings.light_cuts)[i];
}

void Shader::add_reflected(const SurfacePoint& point, const SurfaceMaterial& material,
                           glm::vec3 to_viewer, const Layer& layer, LightTransport& transport,
                           glm::vec3& radiance, RenderStatistics& counts) const {
  const glm::vec3 n = point.shading_normal;
  const float n_dot_v = std::max(glm::dot(n, to_viewer), grazing_cosine);

  // The constant sky, in closed form and unoccluded.
  const ViewedMaterial seen = viewed(material, n_dot_v);
  radiance += layer.share * (ambient_radiance * (seen.diffuse + seen.specular));

  const PatchLobe lobe(point.spread, seen.roughness, n);
  const Receiver receiver = receiver_at(point);
  const glm::dvec3 mirrored = glm::reflect(glm::dvec3(-to_viewer), receiver.normal);
  for (std::uint32_t i = 0; i < lights_.size(); ++i) {
    const PreparedLight& light = lights_[i];
    const glm::vec3 irradiance = unshadowed_irradiance(light, receiver);
    if (irradiance == glm::vec3(0.0f)) continue;
    const glm::vec3 share_out = reflected_share(light, seen, lobe, {point, to_viewer, n_dot_v},
                                                highlight_of(light, receiver.position, mirrored));
    const Illumination lit{light, i, point, irradiance, layer.share * share_out, layer.number};
    if (light.casts_shadows && settings_.shadows) {
      transport.add(lit, radiance, counts);
    } else {
      radiance += lit.reflected * lit.unshadowed;
    }
  }
}

glm::vec3 Shader::radiance(const Ray& first_ray, const Hit& first_hit, float side,
                           LightTransport& transport, RenderStatistics& counts) const {
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
    const bool blended = needs_.alpha_blend &&
                         surface_kind(world_.material_of(hit.triangle)) == SurfaceKind::blended;

    if (hit.triangle != last) {
      // Add the layer by its opacity.
      const SurfaceMaterial material = surface_material(world_, needs_, hit, point.footprint, mips);
      if (material.opacity > 0.0f) {
        const Layer here{share * material.opacity, layer};
        if (material.unlit) {
          sum += here.share * material.base_color * (1.0f - material.transmission);
        } else {
          sum += here.share * material.emission;
          add_reflected(point, material, to_viewer, here, transport, sum, counts);
        }
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
    hit = rays_.closest(ray, settings_.faces);
    ++counts.eye_rays;
  }
  return sum;
}

}  // namespace asos
