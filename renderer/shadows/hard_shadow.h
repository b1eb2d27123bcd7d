#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

/// Returns the visibility of a point light over a patch, by a pyray from the light through the
/// patch's corners (CGF'98 section 4.1).
[[nodiscard]] Estimate hard_shadow(const ShadowContext& block, const ShadowQuery& query,
                                   ShadowPatch patch, RenderStatistics& counts);

}  // namespace asos
