#pragma once

#include "renderer/shadows/shadow_context.h"

#include <span>

namespace asos {

/// A light, and a leaf that it shines on. Keeps references.
struct LitLeaf {
  const Illumination& lit;
  const LeafContext& leaf;
};

/// The visibilities of lights from the patches that leaves show, 0 to 1: how ASOS finds shadows, by
/// pyrays between the light and the patch (CGF'98 section 4). Where nothing lies between a group of
/// coplanar points and a light, one ray tells for all of them.
///
/// A batch is answered one by one, in its order.
void light_visibilities(const ShadowContext& block, std::span<const LitLeaf> batch,
                        std::span<Visibility> visibilities, RenderStatistics& counts);
/// The same of one leaf.
[[nodiscard]] Visibility light_visibility(const ShadowContext& block, const Illumination& lit,
                                          const LeafContext& leaf, RenderStatistics& counts);

/// The visibility as one ray to a random point of the light tells it: 0 or 1, or the transmittance
/// of what lies between.
[[nodiscard]] Visibility ray_visibility(const ShadowContext& block, const ShadowQuery& query,
                                        RenderStatistics& counts);

}  // namespace asos
