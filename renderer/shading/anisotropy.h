#pragma once

#include "renderer/shading/brdf.h"
#include "renderer/shading/lobe_norms.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

// KHR_materials_anisotropy: the squared roughness of the lobe is the material's own across a
// direction, and mix(that, 1, strength^2) along it ("Anisotropy"; its V is not clamped to 1 here).

/// The values at a point whose texel is `texel`: by its red and green the direction, which is then
/// turned, by its blue the strength. A texel without a direction has that of the tangent.
[[nodiscard]] SurfaceAnisotropy anisotropy_of(const Anisotropy& material,
                                              glm::vec3 texel = {1.0f, 0.5f, 1.0f});

/// What a material of this roughness makes of it at a hit, for a viewer in the direction
/// `to_viewer`; `normal` is the shading normal, both unit. None where no tangents are known.
[[nodiscard]] LobeStretch lobe_stretch(const World& world, const Hit& hit,
                                       const SurfaceAnisotropy& anisotropy, float roughness,
                                       glm::vec3 normal, glm::vec3 to_viewer);

/// By which angles, in radians, the mesh's tangents, and the stretch with them, turn about the
/// normal along the edges of a patch around a hit. 0 where it has none of its own.
[[nodiscard]] glm::vec2 tangent_turn(const World& world, const Hit& hit, const Patch& patch,
                                     glm::vec3 normal);

/// Squared roughness along the stretch, of a lobe of this roughness, at least roughness_floor,
/// across it.
[[nodiscard]] float alpha_along(const LobeStretch& stretch, float roughness);

/// The roughness of a stretched lobe in its rougher direction, by which it is told whether a
/// surface mirrors; and of the round lobe of the same peak, by which its mirror is blurred.
[[nodiscard]] float widest_roughness(const ViewedMaterial& material);
[[nodiscard]] float widest_roughness(const SurfaceMaterial& material);
[[nodiscard]] float round_roughness(const ViewedMaterial& material);

/// How far a half vector is from the normal, where what lies along the stretch counts by as much
/// less as the lobe is wider there; both unit.
[[nodiscard]] float away_from_peak(glm::vec3 normal, glm::vec3 half, const LobeStretch& stretch,
                                   float roughness);

/// lobe_norms of a stretched lobe.
[[nodiscard]] LobeNorms stretched_norms(const LobeStretch& stretch, float roughness, float n_dot_v);

}  // namespace asos
