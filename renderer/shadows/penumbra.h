#pragma once

#include "renderer/pyray/tuning.h"
#include "renderer/shadows/shadow_context.h"

namespace asos {

/// Input of find_penumbra: a light and a patch whose centre's visibility may differ from the mean.
struct PenumbraQuery {
  const PreparedLight& light;
  std::uint32_t index = 0;  ///< of the light
  const SurfacePoint& point;
  Patch patch;             ///< around the point
  float reflected = 1.0f;  ///< largest radiance of the patch per irradiance
  int level = 0;           ///< how many times the pixel was split to get the patch
  double weight = 1.0;     ///< weight of the patch in its root
};

/// Result of find_penumbra. A view of a light is too detailed if it has so many boundaries that
/// rays from the whole patch cost less. Then the shadow is sampled, and no split is needed.
struct Penumbra {
  float error = 0.0f;  ///< in display intensity
  bool too_detailed = false;
};

/// Returns the allowed variation of visibility in a leaf. The bound assumes an edge along the whole
/// patch at the worst place; half of it is expected.
[[nodiscard]] inline float penumbra_tolerance(const ErrorBudget& error_budget) {
  return error_budget.tolerance / static_cast<float>(LeafTuning::expected_penumbra);
}

/// Searches for soft-shadow edges across a patch that are narrower than the patch or slightly
/// wider. These are the edges that meet an extended shadow pyray around the patch (CGF'98 section
/// 4.3.4; design section 12, "Penumbrae narrower than the patch"). The error is 0 for point lights,
/// and for qualities that do not refine.
[[nodiscard]] Penumbra find_penumbra(const ShadowContext& block, const PenumbraQuery& query,
                                     RenderStatistics& counts);

}  // namespace asos
