#pragma once

#include "renderer/kernels/light_table.h"
#include "renderer/kernels/lit_batch.h"

#include <cstddef>
#include <span>

namespace asos {

/// About what each of the lights carries by way of point i of the batch into its sum in the
/// brightest channel, if nothing shades it: never 0 where any place of the light carries something.
/// It is irradiance from the light's middle, or where the light is larger than a quarter of its
/// distance from what is near, if that is worth more; times the BRDF there, the lobe as much wider
/// as the light spreads half vectors. Of lights that are small beside their distances exact to 3 %;
/// less than a tenth of what samples carry (root mean square) nowhere. `weights` has room for
/// padded_size(). Returns their sum. The same bits whatever instructions the processor has.
float weigh_lights(const LightTable& lights, const LitBatch& points, std::size_t i,
                   std::span<float> weights);

}  // namespace asos
