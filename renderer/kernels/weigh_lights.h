#pragma once

#include "renderer/kernels/light_table.h"
#include "renderer/kernels/shading_points.h"

#include <cstddef>
#include <span>

namespace asos {

/// Estimates the unshadowed contribution of each light to point i's sum, in the brightest channel.
/// It is never 0 where any part of the light contributes. It is irradiance times BRDF, from the
/// light's centre. A light larger than a quarter of its distance uses its nearest part if that
/// contributes more. The lobe is widened by the light's spread of half vectors. For lights that are
/// small compared with their distance the error is 3 %. Nowhere is the estimate less than a tenth
/// of the samples' contribution (root mean square). `weights` has room for padded_size(). Returns
/// the sum. The bits do not depend on the instruction set.
float weigh_lights(const LightTable& lights, const ShadingPoints& points, std::size_t i,
                   std::span<float> weights);

}  // namespace asos
