#pragma once

#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

/// glTF 2.0's metallic-roughness reflection (appendix B): Lambert and a GGX lobe with Schlick's
/// Fresnel term and height-correlated Smith shadowing. Angles are cosines to the shading normal.
struct BrdfAngles {
  float n_dot_l = 0.0f;
  float n_dot_v = 0.0f;
  float n_dot_h = 0.0f;
  float v_dot_h = 0.0f;
};

/// Below this a highlight from a punctual light is a few pixels wide at most and hundreds of times
/// brighter than white: point samples would meet it or miss it by chance, and no method could
/// antialias it. A perfect mirror is shown with this roughness instead.
inline constexpr float roughness_floor = 0.1f;
/// From here on a highlight is some 40 degrees wide and varies hardly more than diffuse light does:
/// one sample of a pixel settles it.
inline constexpr float least_broad_roughness = 0.6f;

/// Reflectance at normal incidence of KHR_materials_clearcoat's coat, whose index is 1.5.
inline constexpr float coat_f0 = 0.04f;

/// The values of a material that do not depend on the light: made once a point.
struct ViewedMaterial {
  glm::vec3 diffuse;   ///< albedo of the Lambert part, for light that comes from the viewer
  glm::vec3 specular;  ///< share of a constant environment that the GGX lobe returns
  glm::vec3 f0;
  float roughness;
  glm::vec3 f90{1.0f};
  float falloff = 0.0f;  ///< of `diffuse`: by this share of it, times Schlick's (1 - v.h)^5
  /// Share of a constant environment that the Lambert part returns, less the material's occlusion.
  glm::vec3 ambient{0.0f};
  /// Share of it that the lobe of what is no metal leaves to what lies below.
  float below = 1.0f;
  float sheen = 0.0f;        ///< roughness of Charlie's lobe, which then is the lobe; 0: it is GGX
  LobeStretch stretch = {};  ///< of the GGX lobe, whose `roughness` is that across
};

/// The diffuse part is weighted by 1 - F(v.h) of the dielectric's largest colour, as appendix B and
/// KHR_materials_specular say. Of light from all around it returns what the specular lobe leaves
/// *for this viewer*: by glTF's weight a white surface seen at a grazing angle would return up to
/// 1.5 times the light. The lobe is that of the part that is no metal: appendix B mixes what two
/// materials return, and the metal has nothing below. A transmissive surface reflects nothing
/// diffusely of the share that it lets through.
[[nodiscard]] ViewedMaterial viewed(const SurfaceMaterial& material, float n_dot_v);

/// What shines through it diffusely (KHR_materials_diffuse_transmission), as its other side's
/// diffuse part: weighed as its own is, for a viewer who is mirrored by the surface.
[[nodiscard]] ViewedMaterial viewed_from_behind(SurfaceMaterial material, float n_dot_v);

/// The same without its specular lobe, which keeps what it takes from the diffuse part.
[[nodiscard]] ViewedMaterial diffuse_part(ViewedMaterial material);

/// KHR_materials_clearcoat's layer by itself: a lobe without a diffuse part, whose Fresnel term is
/// that of an index of 1.5 for the viewer's own angle, whatever the light's.
[[nodiscard]] ViewedMaterial viewed(const SurfaceCoat& coat, float n_dot_v);

/// KHR_materials_sheen's layer by itself: Charlie's lobe in the sheen's colour. Of light from all
/// around it returns `ambient`, the colour times the lobe's albedo for the viewer; a smooth lobe
/// that would return more than it gets, as it does at grazing angles, is lessened to return all.
[[nodiscard]] ViewedMaterial viewed(const SurfaceSheen& sheen, float n_dot_v);

/// The share of light, seen at this angle, that goes through a surface that transmits: what its
/// layers and its lobe leave, of what is no metal; without the base colour. Of an unlit one all
/// that it transmits.
[[nodiscard]] float transmitted_share(const SurfaceMaterial& material, float n_dot_v);

/// Schlick's (1 - v.h)^5 between two unit directions.
[[nodiscard]] float schlick_weight(glm::vec3 to_viewer, glm::vec3 to_light);

/// Radiance per irradiance of the diffuse part alone, where `schlick` is the mean of Schlick's
/// weight over the irradiance.
[[nodiscard]] glm::vec3 diffuse_brdf(const ViewedMaterial& material, float schlick);

/// The light from one direction that the surface reflects: radiance per irradiance (1 / sr), so
/// that the cosine is the caller's.
[[nodiscard]] glm::vec3 brdf(const ViewedMaterial& material, const BrdfAngles& angles);
/// The specular part alone of a lobe that need not be the material's own: its D * V.
[[nodiscard]] glm::vec3 specular_brdf(const ViewedMaterial& material, const BrdfAngles& angles,
                                      float lobe);

/// The material's own lobe without Fresnel: GGX's, where it is round, or, of sheen, Charlie's.
[[nodiscard]] float lobe_of(const ViewedMaterial& material, const BrdfAngles& angles);

/// Only the GGX lobe's part without Fresnel: D * V, in 1 / sr.
[[nodiscard]] float ggx_lobe(float roughness, const BrdfAngles& angles);

/// The share of a constant environment that the lobe returns: its integral times the cosine over
/// all directions (lobe_norms); of a mirror, whose roughness is 0, Schlick's Fresnel term.
[[nodiscard]] glm::vec3 environment_specular(glm::vec3 f0, float roughness, float n_dot_v,
                                             glm::vec3 f90 = glm::vec3(1.0f));

}  // namespace asos
