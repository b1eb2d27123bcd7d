#pragma once

#include "renderer/settings/settings.h"
#include "renderer/shadows/area_shadow.h"

namespace asos {

/// The ways in which the papers find the shadow of a light of some size on a patch (CGF'98 sections
/// 4.2 to 4.3.4): from the patch's centre, from n x n points or parts of it, or by extended pyrays.
class PublishedShadows final : public AreaShadows {
 public:
  /// `quality`: not ShadowQuality::refined. `divisions`: n of the qualities that divide a patch.
  explicit PublishedShadows(ShadowQuality quality, int divisions = 2)
      : quality_(quality), divisions_(divisions) {}

  [[nodiscard]] Visibility of_patch(const ShadowContext& block, const ShadowQuery& query,
                                    RenderStatistics& counts) const override;

 private:
  [[nodiscard]] Visibility divided(const ShadowContext& block, const ShadowQuery& query,
                                   RenderStatistics& counts) const;

  ShadowQuality quality_;
  int divisions_;
};

}  // namespace asos
