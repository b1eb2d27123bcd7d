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

/// What surfaces get from all others around them, one bounce: the sky, and where something hides
/// that, what this reflects diffusely of the light that lamps and the sky send straight to it.
class BouncedLight {
 public:
  /// All have to outlive this.
  BouncedLight(const RenderScene& scene, const Shader& shader, SamplePlaces& places)
      : scene_(&scene), shader_(&shader), places_(&places) {}

  /// Adds what the rays bring to their sums; the lights, and the sky, of what they meet wait in
  /// `lights`. The places are at other samples then.
  void follow(std::span<const SkyRay> rays, SampledLights& lights, std::vector<glm::dvec3>& sums,
              RenderStatistics& counts);

 private:
  const RenderScene* scene_;
  const Shader* shader_;
  SamplePlaces* places_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
};

}  // namespace asos
