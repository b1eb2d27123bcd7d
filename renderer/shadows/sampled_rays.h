#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/rays/ray_scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// A batch of rays between a patch and a light.
struct SampledRays {
  ShadowRayBatch rays;
  std::vector<glm::vec3> transmittances;  ///< fraction of each that arrives

  /// Returns the unshadowed irradiance of a ray.
  [[nodiscard]] float weight(std::size_t ray) const { return rays.carried[0][ray]; }
  /// Traces the batch. `own_part`: see RayScene.
  void trace(const RayScene& scene, std::int32_t own_part);
};

}  // namespace asos
