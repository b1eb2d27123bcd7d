#include "renderer/shading/brdf.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/ggx.h"
#include "renderer/shading/sheen.h"
#include "renderer/shading/thin_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

template <typename Reflectance>
Reflectance environment_specular(const Reflectance& f0, const Reflectance& f90,
                                 const LobeNorms& norms) {
  return glm::clamp(f0 * norms.lobe + (f90 - f0) * norms.fresnel, 0.0f, 1.0f);
}

}  // namespace

float ggx_lobe(float roughness, const BrdfAngles& angles) {
  const float a2 = alpha_of(roughness) * alpha_of(roughness);
  const float nl = angles.n_dot_l, nv = angles.n_dot_v;
  return ggx_over(a2, ggx_stretched(a2, angles.n_dot_h),
                  smith_shadowing(nl, smith_root(nl, a2), nv, smith_root(nv, a2)));
}

LobeNorms lobe_norms(const Lobe& lobe, float n_dot_v) {
  if (lobe.stretch.none()) return lobe_norms(n_dot_v, lobe.roughness);
  return stretched_lobe_norms(n_dot_v, std::sqrt(lobe.alpha()), lobe.alpha_along(),
                              lobe.stretch.seen_along2);
}

glm::vec3 environment_specular(const Lobe& lobe, float n_dot_v) {
  return environment_specular(lobe.f0, lobe.f90, lobe_norms(lobe, n_dot_v));
}

ViewedMaterial viewed(const SurfaceMaterial& material, float n_dot_v) {
  ViewedMaterial seen{{material.f0, glm::vec3(material.f90), material.roughness, material.stretch}};
  Lobe& lobe = seen.lobe;
  float dielectric_f0 = material.dielectric_f0, dielectric_f90 = material.dielectric_f90;
  // KHR_materials_iridescence: mix(base, the base below a film, factor).
  if (const SurfaceThinFilm& film = material.film; film.factor > 0.0f) {
    const glm::vec3 fresnel = thin_film_fresnel(film, material.f0, n_dot_v);
    lobe.f0 = glm::mix(lobe.f0, fresnel, film.factor);
    lobe.f90 = glm::mix(lobe.f90, fresnel, film.factor);
    const float most = largest(thin_film_fresnel(film, glm::vec3(dielectric_f0), n_dot_v));
    dielectric_f0 = glm::mix(dielectric_f0, most, film.factor);
    dielectric_f90 = glm::mix(dielectric_f90, most, film.factor);
  }
  const LobeNorms norms = lobe_norms(lobe, n_dot_v);
  seen.specular = environment_specular(lobe.f0, lobe.f90, norms);
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
  material.lobe = {glm::vec3(0.0f), glm::vec3(0.0f), 1.0f};
  material.specular = glm::vec3(0.0f);
  return material;
}

ViewedMaterial viewed(const SurfaceCoat& coat, float n_dot_v) {
  const float fresnel = schlick(coat_f0, 1.0f, schlick_weight(n_dot_v));
  const glm::vec3 reflectance(coat.factor * fresnel);
  ViewedMaterial seen{{reflectance, reflectance, coat.roughness}};
  seen.specular = environment_specular(seen.lobe, n_dot_v);
  return seen;
}

ViewedMaterial viewed(const SurfaceSheen& sheen, float n_dot_v) {
  const float albedo = sheen_albedo(n_dot_v, sheen.roughness);
  const glm::vec3 color = sheen.color / std::max(albedo, 1.0f);
  ViewedMaterial seen{{color, color, 1.0f, {}, std::max(sheen.roughness, sheen_roughness_floor)}};
  seen.ambient = sheen.color * std::min(albedo, 1.0f);
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
         specular_brdf(material.lobe, angles, round_lobe(material.lobe, angles));
}

float round_lobe(const Lobe& lobe, const BrdfAngles& angles) {
  return lobe.is_sheen() ? sheen_lobe(lobe.sheen, angles) : ggx_lobe(lobe.roughness, angles);
}

glm::vec3 specular_brdf(const Lobe& lobe, const BrdfAngles& angles, float value) {
  return schlick(lobe.f0, lobe.f90, schlick_weight(angles.v_dot_h)) * value;
}

}  // namespace asos
