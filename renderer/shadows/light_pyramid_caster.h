#pragma once

#include "renderer/shadows/light_pyramid.h"
#include "renderer/shadows/shadow_caster.h"

namespace asos {

/// Casts from a point of a surface to an extended light (CGF'98 section 4.2). A leaf is weighted by
/// irradiance: by its projected solid angle. By the published rule, its weight is its area times
/// the cosine at the light over the squared distance, both at the centre of its square.
class LightPyramidCaster final : public ShadowCaster {
 public:
  /// All arguments have to outlive the pyray. `gives_up`: gives up once a sample hits a surface
  /// with varying transmittance.
  void start(const ShadowScene& scene, bool see_through, const PreparedLight& light,
             const LightPyramid& pyramid, bool gives_up);

  [[nodiscard]] bool gives_up() const override { return may_give_up_ && met_see_through(); }

 protected:
  [[nodiscard]] std::optional<Ray> ray_at(glm::vec2 p) const override;
  [[nodiscard]] double measure(double weight, const LeafRegion& region) const override;

 private:
  const LightPyramid* pyramid_ = nullptr;
  const PreparedLight* light_ = nullptr;
  bool may_give_up_ = false;
};

}  // namespace asos
