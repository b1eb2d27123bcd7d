#pragma once

#include "renderer/shadows/shadow_context.h"

#include <span>

namespace asos {

/// A light and a leaf that it illuminates. Stores references.
struct LeafLight {
  const Illumination& lit;
  const LeafContext& leaf;
};

/// Computes the visibilities of lights from the patches of leaves, 0 to 1, by pyrays between light
/// and patch (CGF'98 section 4); this is how ASOS finds shadows. If nothing lies between a group of
/// coplanar points and a light, one ray decides for all of them.
///
/// The entries of a batch are processed one by one, in order.
void light_visibilities(const ShadowContext& block, std::span<const LeafLight> batch,
                        std::span<Visibility> visibilities, RenderStatistics& counts);
/// Returns the visibility for one leaf.
[[nodiscard]] Visibility light_visibility(const ShadowContext& block, const Illumination& lit,
                                          const LeafContext& leaf, RenderStatistics& counts);

/// Returns the visibility by one ray to a random point of the light: 0 or 1, or the transmittance
/// along the ray.
[[nodiscard]] Visibility ray_visibility(const ShadowContext& block, const ShadowQuery& query,
                                        RenderStatistics& counts);

}  // namespace asos
