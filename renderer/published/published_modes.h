#pragma once

#include "renderer/published/published_shadows.h"
#include "renderer/published/published_subdivision.h"
#include "renderer/settings/settings.h"
#include "renderer/shadows/engine_variant.h"

namespace asos {

/// Published methods (CGF'98) that replace parts of the engine if the settings select them. The
/// engine uses them only through interfaces.
class PublishedModes {
 public:
  explicit PublishedModes(const RenderSettings& settings)
      : pixels_(settings.asos.detect, settings.asos.rule, settings.asos.leaf),
        shadow_pyrays_(Detection::square, StoppingRule::unresolved, settings.asos.leaf),
        refined_(settings.shadow.quality == ShadowQuality::refined),
        area_shadows_(settings.shadow.quality, settings.shadow.divisions) {}

  /// Returns pointers into this object.
  [[nodiscard]] EngineVariant variant() const {
    return {pixels_.differs() ? &pixels_ : nullptr,
            shadow_pyrays_.differs() ? &shadow_pyrays_ : nullptr,
            refined_ ? nullptr : &area_shadows_};
  }

 private:
  PublishedSubdivision pixels_, shadow_pyrays_;
  bool refined_;
  PublishedShadows area_shadows_;
};

}  // namespace asos
