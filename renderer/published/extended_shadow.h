#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

/// Returns the mean visibility of an extended light over a part of the leaf's square. It uses one
/// pyray from behind the surface, through the part of the patch that the light's projection covers
/// (CGF'98 section 4.3.2).
[[nodiscard]] Visibility extended_shadow(const ShadowContext& block, const ShadowQuery& query,
                                         const Square& part, RenderStatistics& counts);

/// Returns the same for the whole leaf. The leaf is divided until each part is inside the light's
/// projection. Then a pyray around each part is traced, and only its rays through the part count
/// (4.3.4).
[[nodiscard]] Visibility adaptive_extended_shadow(const ShadowContext& block,
                                                  const ShadowQuery& query,
                                                  RenderStatistics& counts);

}  // namespace asos
