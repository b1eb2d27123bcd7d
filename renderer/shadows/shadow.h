#pragma once

#include "renderer/shadows/shadow_context.h"

#include <span>

namespace asos {

/// The visibility of a light from the patch that a leaf shows, 0 to 1: how ASOS finds shadows, by
/// pyrays between the light and the patch (CGF'98 section 4). Where nothing lies between a group of
/// coplanar points and a light, one ray tells for all of them.
[[nodiscard]] double light_visibility(const ShadowContext& block, const Illumination& lit,
                                      const LeafContext& leaf, RenderStatistics& counts);

/// The visibility as one ray to a random point of the light tells it: 0 or 1, or the transmittance
/// of what lies between.
[[nodiscard]] double ray_visibility(const ShadowContext& block, const ShadowQuery& query,
                                    RenderStatistics& counts);

}  // namespace asos
