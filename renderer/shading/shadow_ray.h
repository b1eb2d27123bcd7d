#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {

/// The ray from a point to a point of a light, of unit direction: from clear of the surface to
/// shortly before the light, whose own glass does not shade it. Coordinates err by some units in
/// their last place, and so does where the light is met.
[[nodiscard]] inline Ray shadow_ray(const SurfacePoint& point, const LightSample& at) {
  Ray ray;
  ray.direction = glm::vec3(at.direction);
  if (!std::isfinite(at.distance)) {
    // Surfaces under suns are often large, and so is the height that clears them: beside its way
    // the ray would meet shadows that lie beside.
    ray.origin = point.lit_position() +
                 clear_way(clear_height(point), point.to_edge, point.horizon(), ray.direction);
    return ray;
  }
  ray.origin = spawn_origin(point, ray.direction);
  const auto distance = static_cast<float>(at.distance);
  const glm::vec3 size = glm::abs(ray.origin) + distance * glm::abs(ray.direction);
  const float relative = (size.x + size.y + size.z) / distance;
  constexpr float least = 1e-5f;
  ray.t_far = distance * (1.0f - std::clamp(8.0f * std::numeric_limits<float>::epsilon() * relative,
                                            least, 0.5f));
  return ray;
}

}  // namespace asos
