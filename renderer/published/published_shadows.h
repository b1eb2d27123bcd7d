#pragma once

#include "renderer/settings/settings.h"
#include "renderer/shadows/area_shadow.h"

namespace asos {

/// The papers' methods for the shadow of an extended light on a patch (CGF'98 sections 4.2 to
/// 4.3.4): from the patch's centre, from n x n points or parts of it, or by extended pyrays.
class PublishedShadows final : public AreaShadows {
 public:
  /// `quality` must not be ShadowQuality::refined. `divisions` is n for the qualities that divide a
  /// patch.
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
