#pragma once

#include "renderer/shadows/shadow_context.h"

// Shadows by rays, where so much lies between a patch and a light that its boundaries cost more
// than rays do (design section 5, "Saturation"): well distributed rays, each from another part of
// the patch to another part of the light, so that what is narrower than the patch is averaged over
// it.

namespace asos {

/// The mean visibility of a light of some size over the leaf's patch. `window`: the light as
/// `receiver` in the patch's middle sees it.
[[nodiscard]] Visibility sampled_area_shadow(const ShadowContext& block, const ShadowQuery& query,
                                             const LightWindow& window, const Receiver& receiver,
                                             RenderStatistics& counts);

/// The same of a ball that the patch lies in: light comes from everywhere.
[[nodiscard]] Visibility sampled_shadow_around(const ShadowContext& block, const ShadowQuery& query,
                                               RenderStatistics& counts);

/// The same of a light without a size, over a patch whose plane is not its surface.
[[nodiscard]] Visibility sampled_hard_shadow(const ShadowContext& block, const ShadowQuery& query,
                                             RenderStatistics& counts);

}  // namespace asos
