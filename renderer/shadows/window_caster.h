#pragma once

#include "renderer/shadows/light_window.h"
#include "renderer/shadows/shadow_caster.h"

namespace asos {

/// From a point of a surface to a light of some size (CGF'98 section 4.2). A leaf is worth the
/// irradiance that it gives: its projected solid angle, or by the published rule its area times the
/// cosine at the light over the squared distance, both at its sample.
class WindowCaster final : public ShadowCaster {
 public:
  /// All have to outlive the pyray. `gives_up`: once a sample meets what lets more or less light
  /// through from place to place.
  void start(const ShadowScene& scene, bool see_through, const PreparedLight& light,
             const LightWindow& window, bool gives_up);

  [[nodiscard]] bool gives_up() const override { return may_give_up_ && met_see_through(); }

 protected:
  [[nodiscard]] std::optional<Ray> ray_at(glm::vec2 p) const override;
  [[nodiscard]] double measure(double weight, const LeafRegion& region) const override;

 private:
  const LightWindow* window_ = nullptr;
  const PreparedLight* light_ = nullptr;
  bool may_give_up_ = false;
};

}  // namespace asos
