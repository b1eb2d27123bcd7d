#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

/// Returns the visibility of a linear light from a point (GI'93, "Linear Light Sources"). The
/// papers split pyrays in two. Here all boundaries that cross the line are found together, and one
/// ray goes to each part between them.
[[nodiscard]] Estimate linear_shadow(const ShadowContext& block, const ShadowQuery& query,
                                     RenderStatistics& counts);

/// Returns a thin strip around a linear light, which is the centre line of its square along u.
/// Returns nothing for a receiver on the light's own line.
[[nodiscard]] std::optional<Frame> strip_around(const PreparedLight& light,
                                                const Receiver& receiver);

}  // namespace asos
