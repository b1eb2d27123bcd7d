#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

/// The question to a penumbra: how far off the mean over a patch is a light's visibility from its
/// middle?
struct PenumbraQuery {
  const PreparedLight& light;
  std::uint32_t index = 0;  ///< of the light
  const SurfacePoint& point;
  Patch patch;             ///< around the point
  float reflected = 1.0f;  ///< radiance that the patch makes of irradiance at most
  int level = 0;           ///< how many times the pixel was split to get the patch
  double weight = 1.0;     ///< of the patch, of its root
};

/// The answer. A saturated view of a light has more boundaries than rays would cost that look at it
/// from all over the patch, which is then how its shadow is to be found; it needs no split.
struct Penumbra {
  float error = 0.0f;  ///< in display intensity
  bool saturated = false;
};

/// Variation of the visibility that a leaf may have: its bound is for an edge all along a patch and
/// at the worst place, so that twice the tolerance gives pictures as exact.
[[nodiscard]] inline float penumbra_tolerance(const Allowance& allowance) {
  return 2.0f * allowance.tolerance;
}

/// Looks for edges of a shadow of a light of some size that run through a patch, narrower than the
/// patch or not much wider: those that an extended shadow pyray around the patch meets (CGF'98
/// section 4.3.4; design section 12, "Penumbrae narrower than the patch"). No error for lights
/// without size, nor where the quality is none that refines.
[[nodiscard]] Penumbra find_penumbra(const ShadowContext& block, const PenumbraQuery& query,
                                     RenderStatistics& counts);

}  // namespace asos
