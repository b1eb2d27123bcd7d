#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

/// A replacement for the computation of an extended light's mean visibility over a leaf's patch.
class AreaShadows {
 public:
  virtual ~AreaShadows() = default;
  [[nodiscard]] virtual Visibility of_patch(const ShadowContext& block, const ShadowQuery& query,
                                            RenderStatistics& counts) const = 0;
};

/// Returns the mean visibility of an extended light over the leaf's patch, by the method in the
/// rules.
[[nodiscard]] Estimate area_shadow(const ShadowContext& block, const ShadowQuery& query,
                                   RenderStatistics& counts);

/// Returns the visibility of an extended light from one point, by a pyray from the point through a
/// rectangle around the light (CGF'98 section 4.2).
[[nodiscard]] Visibility point_area_shadow(const ShadowContext& block, const ShadowQuery& query,
                                           const Receiver& receiver, RenderStatistics& counts);

}  // namespace asos
