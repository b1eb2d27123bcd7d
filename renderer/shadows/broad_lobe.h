#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

// What a light that is seen in part makes of a broad lobe, such as that of rough metal, which is
// no highlight of one place of the light but another at each: more than the share of it that is
// seen tells where the brighter part is seen.

/// Whether it may show, were that share of the light seen.
[[nodiscard]] bool lobe_tells_apart(const ShadowContext& block, const Illumination& lit,
                                    const Visibility& seen);

}  // namespace asos
