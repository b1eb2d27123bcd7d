#pragma once

#include "renderer/kernels/light_kernel.h"

namespace asos {

/// The weight of visibility rays: irradiance at the point, or the radiance that the surface
/// reflects.
enum class RayWeighting { irradiance, radiance };

/// Computes shadow rays from points to places on a light. Places on flat lights are chosen by area,
/// which costs less than choosing by solid angle as light samples do. The first channel of
/// `carried` is each ray's weight, the mean over the colours; the others are not set. Rays without
/// weight are left out. The bits do not depend on the instruction set.
void aim_batch(const ShadingPoints& points, const LightConstants& light,
               const LightPointBatch& places, RayWeighting by, ShadowRayBatch& rays);

}  // namespace asos
