#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

/// The mean visibility of a light of some size over a part of the leaf's square, by one pyray from
/// behind the surface, through as much of the patch as the light's projection covers (CGF'98
/// section 4.3.2).
[[nodiscard]] Visibility extended_shadow(const ShadowContext& block, const ShadowQuery& query,
                                         const Square& part, RenderStatistics& counts);

/// The same over the whole leaf, which is divided until each part lies inside the light's
/// projection; then by a pyray that holds the part, of which only what passes through it counts
/// (4.3.4).
[[nodiscard]] Visibility adaptive_extended_shadow(const ShadowContext& block,
                                                  const ShadowQuery& query,
                                                  RenderStatistics& counts);

}  // namespace asos
