#pragma once

#include "renderer/film/statistics.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/samples/sample_block.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/shading/shade.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace asos {

/// Computes the light from all surroundings of a surface with one bounce: along each ray the sky's
/// radiance, or an occluder's diffuse reflection of direct light from lights and the sky.
class BouncedLight {
 public:
  /// All arguments have to outlive this.
  BouncedLight(const RenderScene& scene, const Shader& shader, PixelSampler& places)
      : scene_(&scene), shader_(&shader), places_(&places) {}

  /// Adds the radiance along the rays to the rays' sums. Lights and sky at the hits are deferred in
  /// `lights`. Changes the current sample of `places`.
  void follow(std::span<const SkyRay> rays, SampledLights& lights, RadianceSums sums,
              RenderStatistics& counts);

 private:
  const RenderScene* scene_;
  const Shader* shader_;
  PixelSampler* places_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
};

}  // namespace asos
