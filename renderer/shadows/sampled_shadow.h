#pragma once

#include "renderer/shadows/shadow_context.h"

// Shadows by rays, where so much lies between a patch and a light that its boundaries cost more
// than rays do (design section 5, "Saturation"): well distributed rays, each from another part of
// the patch to another part of the light, so that what is narrower than the patch is averaged over
// it. They are those of the samplers' kernels, weighed by what they would carry.

namespace asos {

/// The mean visibility of a light over the leaf's patch: of one with a size, or of one without over
/// a patch whose plane is not its surface.
[[nodiscard]] Visibility sampled_shadow(const ShadowContext& block, const ShadowQuery& query,
                                        RenderStatistics& counts);

}  // namespace asos
