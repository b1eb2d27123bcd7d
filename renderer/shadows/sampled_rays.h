#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/rays/ray_scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The rays that tell how much of a light is seen.
struct SampledRays {
  ShadowRayBatch rays;                    ///< those of the last batch
  std::vector<double> weights;            ///< of all: what each carries if nothing is in its way
  std::vector<glm::vec3> transmittances;  ///< of all: what share of that arrives

  [[nodiscard]] std::size_t count() const { return weights.size(); }
  void clear();
  /// Traces the batch. `own_part`: see RayScene.
  void trace(const RayScene& scene, std::int32_t own_part);
};

}  // namespace asos
