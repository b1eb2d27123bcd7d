#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

/// The visibility of a linear light from a point (GI'93, "Linear Light Sources"): where the papers
/// split pyrays in two, all boundaries that cross the line are found at once, and one ray goes to
/// each part between them.
[[nodiscard]] Visibility linear_shadow(const ShadowContext& block, const ShadowQuery& query,
                                       RenderStatistics& counts);

/// A thin strip around a linear light, which is the middle line of its square along u. Nothing for
/// a receiver on the light's own line.
[[nodiscard]] std::optional<Frame> strip_around(const PreparedLight& light,
                                                const Receiver& receiver);

}  // namespace asos
