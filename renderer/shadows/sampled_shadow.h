#pragma once

#include "renderer/shadows/shadow_context.h"

// Shadows by rays, used where there are so many boundaries between a patch and a light that they
// cost more than rays (design section 5, "Saturation"). Each ray goes from another part of the
// patch to another part of the light, so that shadows narrower than the patch are averaged. The
// rays come from the samplers' kernels and are weighted by their unshadowed contributions.

namespace asos {

/// Returns the mean visibility of a light over the leaf's patch. The light has an extent, or it is
/// a point light and the patch is curved.
[[nodiscard]] Estimate sampled_shadow(const ShadowContext& block, const ShadowQuery& query,
                                      RenderStatistics& counts);

}  // namespace asos
