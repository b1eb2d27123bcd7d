#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {

/// Returns the ray of unit direction from a point to a point of a light. It starts clear of the
/// surface and ends shortly before the light, so that the light's own glass does not shade it. The
/// end has a tolerance of some units in the last place of the coordinates.
[[nodiscard]] inline Ray shadow_ray(const SurfacePoint& point, const LightSample& at) {
  Ray ray;
  ray.direction = glm::vec3(at.direction);
  if (!std::isfinite(at.distance)) {
    // Surfaces under suns are often large, and so is the height that clears them. Starting straight
    // above the point would move the ray sideways into other shadows, so it starts along its own
    // direction.
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
