#pragma once

#include "renderer/rays/ray_scene.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shading/shadow_ray.h"

namespace asos::test {

/// Adds each light immediately, with one shadow ray to its centre.
class RayTransport final : public LightTransport {
 public:
  explicit RayTransport(const RayScene& rays) : rays_(rays) {}

  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override {
    const LightSample at = sample_light(lit.light, receiver_at(lit.point), 0.5, 0.5);
    ++counts.shadow_rays;
    radiance += lit.reflected * at.irradiance *
                rays_.transmittance(shadow_ray(lit.point, at), lit.light.own_part);
  }

 private:
  const RayScene& rays_;
};

}  // namespace asos::test
