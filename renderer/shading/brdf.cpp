#include "renderer/shading/brdf.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/anisotropy.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/lobe_norms.h"
#include "renderer/shading/sheen.h"
#include "renderer/shading/thin_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

float floored(float roughness) {
  return std::clamp(roughness, roughness_floor, 1.0f);
}

template <typename Reflectance>
Reflectance environment_specular(const Reflectance& f0, const Reflectance& f90,
                                 const LobeNorms& norms) {
  return glm::clamp(f0 * norms.lobe + (f90 - f0) * norms.fresnel, 0.0f, 1.0f);
}

}  // namespace

float ggx_lobe(float roughness, const BrdfAngles& angles) {
  const float alpha = floored(roughness) * floored(roughness);
  const float a2 = alpha * alpha;
  const float nl = angles.n_dot_l, nv = angles.n_dot_v;
  return ggx_over(a2, ggx_stretched(a2, angles.n_dot_h),
                  smith_shadowing(nl, smith_root(nl, a2), nv, smith_root(nv, a2)));
}

glm::vec3 environment_specular(glm::vec3 f0, float roughness, float n_dot_v, glm::vec3 f90) {
  return environment_specular(f0, f90, lobe_norms(n_dot_v, roughness));
}

ViewedMaterial viewed(const SurfaceMaterial& material, float n_dot_v) {
  ViewedMaterial seen{};
  seen.f0 = material.f0;
  seen.f90 = glm::vec3(material.f90);
  float dielectric_f0 = material.dielectric_f0, dielectric_f90 = material.dielectric_f90;
  // KHR_materials_iridescence: mix(base, the base below a film, factor).
  if (const SurfaceThinFilm& film = material.film; film.factor > 0.0f) {
    const glm::vec3 fresnel = thin_film_fresnel(film, material.f0, n_dot_v);
    seen.f0 = glm::mix(seen.f0, fresnel, film.factor);
    seen.f90 = glm::mix(seen.f90, fresnel, film.factor);
    const float most = largest(thin_film_fresnel(film, glm::vec3(dielectric_f0), n_dot_v));
    dielectric_f0 = glm::mix(dielectric_f0, most, film.factor);
    dielectric_f90 = glm::mix(dielectric_f90, most, film.factor);
  }
  seen.roughness = material.roughness;
  seen.stretch = material.stretch;
  const LobeNorms norms = material.stretch.none()
                              ? lobe_norms(n_dot_v, material.roughness)
                              : stretched_norms(material.stretch, material.roughness, n_dot_v);
  seen.specular = environment_specular(seen.f0, seen.f90, norms);
  seen.below = 1.0f - environment_specular(dielectric_f0, dielectric_f90, norms);
  const glm::vec3 albedo =
      material.base_color * ((1.0f - material.metallic) * (1.0f - material.transmission) *
                             (1.0f - material.diffuse_transmission));
  const float left = 1.0f - dielectric_f0;
  seen.diffuse = left * albedo;
  seen.falloff = left > 0.0f ? (dielectric_f90 - dielectric_f0) / left : 0.0f;
  seen.ambient = (material.occlusion * seen.below) * albedo;
  return seen;
}

ViewedMaterial viewed_from_behind(SurfaceMaterial material, float n_dot_v) {
  material.base_color = material.diffuse_transmission_color;
  material.diffuse_transmission = 1.0f - material.diffuse_transmission;
  return diffuse_part(viewed(material, n_dot_v));
}

ViewedMaterial diffuse_part(ViewedMaterial material) {
  material.specular = material.f0 = glm::vec3(0.0f);
  material.f90 = glm::vec3(0.0f);
  material.roughness = 1.0f;
  material.stretch = {};
  return material;
}

ViewedMaterial viewed(const SurfaceCoat& coat, float n_dot_v) {
  const float fresnel = schlick(coat_f0, 1.0f, schlick_weight(n_dot_v));
  ViewedMaterial seen{};
  seen.f0 = seen.f90 = glm::vec3(coat.factor * fresnel);
  seen.roughness = coat.roughness;
  seen.specular = environment_specular(seen.f0, coat.roughness, n_dot_v, seen.f90);
  return seen;
}

ViewedMaterial viewed(const SurfaceSheen& sheen, float n_dot_v) {
  const float albedo = sheen_albedo(n_dot_v, sheen.roughness);
  ViewedMaterial seen{};
  seen.f0 = seen.f90 = sheen.color / std::max(albedo, 1.0f);
  seen.ambient = sheen.color * std::min(albedo, 1.0f);
  seen.roughness = 1.0f;  // as broad as diffuse light
  seen.sheen = std::max(sheen.roughness, sheen_roughness_floor);
  return seen;
}

float schlick_weight(glm::vec3 to_viewer, glm::vec3 to_light) {
  const glm::vec3 sum = to_viewer + to_light;
  return schlick_weight(0.5f * std::sqrt(glm::dot(sum, sum)));
}

glm::vec3 diffuse_brdf(const ViewedMaterial& material, float schlick) {
  return ((1.0f - material.falloff * schlick) * std::numbers::inv_pi_v<float>)*material.diffuse;
}

glm::vec3 brdf(const ViewedMaterial& material, const BrdfAngles& angles) {
  return diffuse_brdf(material, schlick_weight(angles.v_dot_h)) +
         specular_brdf(material, angles, lobe_of(material, angles));
}

float lobe_of(const ViewedMaterial& material, const BrdfAngles& angles) {
  return material.sheen > 0.0f ? sheen_lobe(material.sheen, angles)
                               : ggx_lobe(material.roughness, angles);
}

glm::vec3 specular_brdf(const ViewedMaterial& material, const BrdfAngles& angles, float lobe) {
  return schlick(material.f0, material.f90, schlick_weight(angles.v_dot_h)) * lobe;
}

}  // namespace asos
