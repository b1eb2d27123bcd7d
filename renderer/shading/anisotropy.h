#pragma once

#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

namespace asos {

// KHR_materials_anisotropy: the lobe's alpha (roughness^2) is the material's across a direction,
// and mix(alpha, 1, strength^2) along it. Unlike in the extension, the visibility term V is not
// clamped to 1.

/// Returns the anisotropy at a point with this texel of its texture. Red and green are the
/// direction, which is then rotated; blue is the strength. A texel without a direction uses the
/// tangent.
[[nodiscard]] SurfaceAnisotropy anisotropy_of(const Anisotropy& material,
                                              glm::vec3 texel = {1.0f, 0.5f, 1.0f});

/// Returns the stretch of the lobe at a hit, for a material of this roughness and a viewer in the
/// direction `to_viewer`. `normal` is the shading normal; both are unit. Returns none where the
/// tangents are unknown.
[[nodiscard]] LobeStretch lobe_stretch(const World& world, const Hit& hit,
                                       const SurfaceAnisotropy& anisotropy, float roughness,
                                       glm::vec3 normal, glm::vec3 to_viewer);

/// Returns the angles, in radians, by which the mesh's tangents turn about the normal along the
/// edges of a patch around a hit. The stretch turns with them. Returns 0 for a mesh without
/// tangents.
[[nodiscard]] glm::vec2 tangent_turn(const World& world, const Hit& hit, const Patch& patch,
                                     glm::vec3 normal);

/// Returns Lobe::widest_roughness of a material's own lobe, where its stretch is unknown.
[[nodiscard]] float widest_roughness(const SurfaceMaterial& material);

}  // namespace asos
