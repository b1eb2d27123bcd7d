#pragma once

#include "renderer/kernels/light_table.h"
#include "renderer/kernels/shading_points.h"

#include <cstddef>
#include <span>

namespace asos {

/// Estimates the unshadowed contribution of each light at point i, in the brightest channel:
/// irradiance times BRDF, from the light's centre. It is never 0 where any part of the light
/// contributes. A light larger than a quarter of its distance uses its nearest part if that
/// contributes more. The lobe is widened by the light's spread of half vectors. For lights that are
/// small compared with their distance the error is 3 %. Nowhere is the estimate less than a tenth
/// of the samples' contribution (root mean square). `weights` has room for padded_size(). Returns
/// the sum of the estimates. The bits do not depend on the instruction set.
float weigh_lights(const LightTable& lights, const ShadingPoints& points, std::size_t i,
                   std::span<float> weights);

}  // namespace asos
