#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"

namespace asos {

/// Whether a leaf shows textured layers that blend, one through the other, of which only samples
/// tell how much is seen: the mean of what all let through is not the product of their means, and
/// no outlines bound what alpha blends.
[[nodiscard]] bool sees_uneven_layers(const EyeContext& eye, const EyeSamples& samples,
                                      SampleId sample, double share, const LeafRegion& region);

}  // namespace asos
