#pragma once

#include "renderer/kernels/weigh_lights.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/samples/thread_local_cache.h"
#include "renderer/shading/light_transport.h"

#include <span>
#include <vector>

namespace asos {

/// Finds the largest unshadowed contribution of each of many lights at the points that a shader
/// illuminates, and evaluates no light. Its accuracy is that of weigh_lights.
class UnshadowedContributions final : public LightTransport {
 public:
  /// The lights have to outlive this.
  explicit UnshadowedContributions(std::span<const PreparedLight> lights);

  HandledLights gather(const LightingQuery& point) override;
  void add(const Illumination& /*lit*/, glm::vec3& /*radiance*/,
           RenderStatistics& /*counts*/) override {}
  bool reflect(const Reflection& /*reflection*/, glm::vec3& /*radiance*/,
               RenderStatistics& /*counts*/) override {
    return true;
  }

  /// Returns the largest contribution of each light to a pixel, in display intensity. Lights of one
  /// part of a mesh are together no brighter than its two sides.
  [[nodiscard]] std::vector<double> most() const;

 private:
  std::span<const PreparedLight> lights_;
  std::vector<LightBounds> bounds_;
  CachedPtr<ShadingPoints> point_;
  std::vector<float> weights_;  // contributions at the current point
  std::vector<float> most_;     // the largest at any point
};

}  // namespace asos
