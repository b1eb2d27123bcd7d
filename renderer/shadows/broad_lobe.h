#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

// Partially occluded lights in broad lobes, such as those of rough metal. The highlight of a broad
// lobe extends over the whole light, so it depends on which part of the light is visible and not
// only on the visible fraction.

/// Returns whether that matters visibly for this visible fraction.
[[nodiscard]] bool lobe_tells_apart(const ShadowContext& block, const Illumination& lit,
                                    const Visibility& seen);

}  // namespace asos
