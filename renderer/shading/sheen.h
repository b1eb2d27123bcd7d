#pragma once

#include "renderer/shading/brdf.h"

namespace asos {

// KHR_materials_sheen's lobe, after Estevez and Kulla 2017, "Production Friendly Microfacet Sheen
// BRDF": fibres along the normal, distributed as a power of the half vector's sine (Charlie).

/// Smoother sheen, a ring of light at the horizon that point samples would meet by chance, is shown
/// with this roughness.
inline constexpr float sheen_roughness_floor = 0.1f;

/// D * V in 1 / sr, roughness from sheen_roughness_floor to 1.
[[nodiscard]] float sheen_lobe(float roughness, const BrdfAngles& angles);

/// E, what the lobe returns of light from all around: its integral times the cosine, by quadrature
/// once, in a table between whose values it is linear, within 1e-2. Above 1 at grazing angles of
/// roughness below 0.25. What lies outside counts as the nearest; what is no number stays none.
[[nodiscard]] float sheen_albedo(float n_dot_v, float roughness);

}  // namespace asos
