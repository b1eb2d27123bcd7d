#pragma once

#include "renderer/shadows/light_window.h"
#include "renderer/shadows/shadow_caster.h"

namespace asos {

/// From a point of a surface to a light of some size (CGF'98 section 4.2). A leaf is worth the
/// irradiance that it gives: its projected solid angle, or by the published rule its area times the
/// cosine at the light over the squared distance, both at its sample.
class WindowCaster final : public ShadowCaster {
 public:
  using ShadowCaster::ShadowCaster;

  /// `light` and `window` have to outlive the pyray.
  void start(const PreparedLight& light, const LightWindow& window);

 protected:
  [[nodiscard]] std::optional<Ray> ray_at(glm::vec2 p) const override;
  [[nodiscard]] double measure(double weight, const LeafRegion& region) const override;

 private:
  const LightWindow* window_ = nullptr;
  const PreparedLight* light_ = nullptr;
};

}  // namespace asos
