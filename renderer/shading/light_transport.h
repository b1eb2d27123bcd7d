#pragma once

#include "renderer/film/statistics.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// A light that shines on a point, and what the point makes of it.
struct Illumination {
  const PreparedLight& light;
  std::uint32_t index = 0;  ///< of the light in World::lights
  const SurfacePoint& point;
  glm::vec3 unshadowed{0.0f};  ///< irradiance with nothing in the way
  glm::vec3 reflected{0.0f};   ///< radiance towards the viewer per irradiance
  int layer = 0;               ///< surfaces that are seen through before the point
};

[[nodiscard]] inline Receiver receiver_at(const SurfacePoint& point) {
  return {glm::dvec3(point.position), glm::dvec3(point.shading_normal),
          glm::dvec3(point.geometric_normal)};
}

/// Finds out how much of a light reaches a point: what the methods differ in, while all else about
/// shading is the same for all.
class LightTransport {
 public:
  virtual ~LightTransport() = default;

  /// Adds to `radiance` what the viewer sees of the light by way of the point, now or later.
  virtual void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) = 0;
};

}  // namespace asos
