#pragma once

#include "renderer/kernels/light_kernel.h"

namespace asos {

/// What rays that tell how much of a light is seen are weighed by: where it falls, and what its
/// surface makes of it.
enum class AimedBy { irradiance, radiance };

/// Shadow rays from points to places of a light with a size, by a measure of the area of flat ones,
/// which costs less than that of solid angles by which samples of light are as good as can be; of a
/// light without one, to it. `carried`: the first channel is each ray's weight, the mean of the
/// colours, and the others are not set. Rays without weight are left out. The same bits whatever
/// instructions the processor has.
void aim_batch(const LitBatch& points, const LightConstants& light, const LightPlaceBatch& places,
               AimedBy by, ShadowRayBatch& rays);

}  // namespace asos
