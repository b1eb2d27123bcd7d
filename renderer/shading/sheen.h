#pragma once

#include "renderer/shading/brdf.h"

namespace asos {

// KHR_materials_sheen's lobe, after Estevez and Kulla 2017, "Production Friendly Microfacet Sheen
// BRDF": fibres along the normal, distributed as a power of the half vector's sine (Charlie).

/// Smallest roughness of sheen. Smoother sheen is a ring of light at the horizon that point samples
/// would hit by chance; it is shown with this roughness.
inline constexpr float sheen_roughness_floor = 0.1f;

/// Returns D * V in 1 / sr, for roughness from sheen_roughness_floor to 1.
[[nodiscard]] float sheen_lobe(float roughness, const BrdfAngles& angles);

/// Returns E, the lobe's albedo under light from all around: its integral times the cosine. It is
/// computed by quadrature once and interpolated linearly, within 1e-2. Above 1 at grazing angles
/// for roughness below 0.25. Values out of range count as the nearest; NaN stays NaN.
[[nodiscard]] float sheen_albedo(float n_dot_v, float roughness);

}  // namespace asos
