#pragma once

#include "renderer/shadows/shadow_context.h"

namespace asos {

/// Another way to find the mean visibility of a light of some size over the patch that a leaf
/// shows.
class AreaShadows {
 public:
  virtual ~AreaShadows() = default;
  [[nodiscard]] virtual Visibility of_patch(const ShadowContext& block, const ShadowQuery& query,
                                            RenderStatistics& counts) const = 0;
};

/// The mean visibility of a light of some size over the patch that the leaf shows, in the way that
/// the rules name.
[[nodiscard]] Visibility area_shadow(const ShadowContext& block, const ShadowQuery& query,
                                     RenderStatistics& counts);

/// The visibility of a light of some size from one point: a pyray from there through the rectangle
/// around the light (CGF'98 section 4.2).
[[nodiscard]] Visibility point_area_shadow(const ShadowContext& block, const ShadowQuery& query,
                                           const Receiver& receiver, RenderStatistics& counts);

}  // namespace asos
