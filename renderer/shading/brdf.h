#pragma once

#include "renderer/shading/lobe.h"
#include "renderer/shading/lobe_norms.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

/// The metallic-roughness BRDF of glTF 2.0 (appendix B): Lambert and a GGX lobe with Schlick's
/// Fresnel term and height-correlated Smith shadowing. Angles are cosines to the shading normal.
struct BrdfAngles {
  float n_dot_l = 0.0f;
  float n_dot_v = 0.0f;
  float n_dot_h = 0.0f;
  float v_dot_h = 0.0f;
};

/// Reflectance at normal incidence of KHR_materials_clearcoat's coat, whose index is 1.5.
inline constexpr float coat_f0 = 0.04f;

/// Values of a material that depend on the viewer but not on the light; computed once per point.
struct ViewedMaterial {
  Lobe lobe;
  glm::vec3 diffuse{0.0f};   ///< albedo of the Lambert part, for light from the viewer's direction
  float falloff = 0.0f;      ///< loss of `diffuse` per unit of Schlick's (1 - v.h)^5, as a fraction
  glm::vec3 specular{0.0f};  ///< fraction of a constant environment that the lobe reflects
  /// Fraction of a constant environment that the Lambert part reflects, times the material's
  /// occlusion.
  glm::vec3 ambient{0.0f};
  /// Fraction of a constant environment that the dielectric's lobe transmits to the layers below.
  float below = 1.0f;
};

/// Computes the values for a viewer. The diffuse part is weighted by 1 - F(v.h) of the dielectric's
/// largest colour (glTF appendix B, KHR_materials_specular). `ambient` is weighted by the rest of
/// the specular lobe *for this viewer* instead: with glTF's weight, a white surface at a grazing
/// angle would reflect up to 1.5 times the light. Both weights use the dielectric's lobe, since
/// appendix B mixes two materials and the metal has no layer below. The transmitted fraction has no
/// diffuse reflection.
[[nodiscard]] ViewedMaterial viewed(const SurfaceMaterial& material, float n_dot_v);

/// Computes the values for diffuse transmission (KHR_materials_diffuse_transmission), as the
/// diffuse part of the other side. It is weighted like the front's, for a viewer reflected by the
/// surface.
[[nodiscard]] ViewedMaterial viewed_from_behind(SurfaceMaterial material, float n_dot_v);

/// Returns the same material without its specular lobe; the diffuse part is still reduced by that
/// lobe.
[[nodiscard]] ViewedMaterial diffuse_part(ViewedMaterial material);

/// Computes the values of KHR_materials_clearcoat's layer: a lobe without a diffuse part. Its
/// Fresnel term is that of an index of 1.5 for the viewer's angle, independent of the light's.
[[nodiscard]] ViewedMaterial viewed(const SurfaceCoat& coat, float n_dot_v);

/// Computes the values of KHR_materials_sheen's layer: Charlie's lobe in the sheen's colour. Its
/// `ambient` is the colour times the lobe's albedo for the viewer. At grazing angles a smooth lobe
/// would reflect more light than arrives, so it is scaled to reflect all of it.
[[nodiscard]] ViewedMaterial viewed(const SurfaceSheen& sheen, float n_dot_v);

/// Schlick's (1 - v.h)^5 between two unit directions.
[[nodiscard]] float schlick_weight(glm::vec3 to_viewer, glm::vec3 to_light);

/// Returns the diffuse part's radiance per irradiance. `schlick` is the mean of Schlick's weight
/// over the irradiance.
[[nodiscard]] glm::vec3 diffuse_brdf(const ViewedMaterial& material, float schlick);

/// Returns radiance per irradiance (1 / sr) for light from one direction. The caller multiplies by
/// the cosine.
[[nodiscard]] glm::vec3 brdf(const ViewedMaterial& material, const BrdfAngles& angles);
/// Returns the part of a lobe alone; `value` is its D * V.
[[nodiscard]] glm::vec3 specular_brdf(const Lobe& lobe, const BrdfAngles& angles, float value);

/// Returns D * V of a lobe, in 1 / sr, without Fresnel: isotropic GGX, or Charlie's for sheen.
[[nodiscard]] float round_lobe(const Lobe& lobe, const BrdfAngles& angles);

/// Returns D * V of the GGX lobe, without Fresnel, in 1 / sr.
[[nodiscard]] float ggx_lobe(float roughness, const BrdfAngles& angles);

/// Returns the integrals of a GGX lobe over all directions, times the cosine.
[[nodiscard]] LobeNorms lobe_norms(const Lobe& lobe, float n_dot_v);

/// Returns the fraction of a constant environment that a GGX lobe reflects (lobe_norms), at most 1.
/// For a mirror, of roughness 0, that is Schlick's Fresnel term.
[[nodiscard]] glm::vec3 environment_specular(const Lobe& lobe, float n_dot_v);

}  // namespace asos
