#include "renderer/world/world.h"

#include <algorithm>
#include <cmath>

namespace asos {

Camera default_camera(const World& world, double aspect_ratio) {
  constexpr double fov_y = 40.0 * 3.14159265358979323846 / 180.0;
  constexpr double margin = 1.05;
  const double aspect = std::isfinite(aspect_ratio) && aspect_ratio > 0.0 ? aspect_ratio : 1.0;

  // A scene without extent (empty, or a single point) is framed as if it were a unit cube.
  const bool empty = world.bounds.empty();
  const glm::dvec3 lo = empty ? glm::dvec3(-0.5) : glm::dvec3(world.bounds.lo);
  const glm::dvec3 hi = empty ? glm::dvec3(0.5) : glm::dvec3(world.bounds.hi);
  const glm::dvec3 centre = 0.5 * (lo + hi);
  glm::dvec3 half = 0.5 * (hi - lo);
  if (glm::length(half) == 0.0) half = glm::dvec3(0.5);

  const glm::dvec3 back = glm::normalize(glm::dvec3(0.55, 0.4, 1.0));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
  const glm::dvec3 up = glm::cross(back, right);

  // The nearest eye from which every corner of the bounds lies inside the four side planes.
  const double tan_y = std::tan(0.5 * fov_y);
  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 d =
        half * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const double spread = std::max(std::abs(glm::dot(d, right)) / (tan_y * aspect),
                                   std::abs(glm::dot(d, up)) / tan_y);
    distance = std::max(distance, glm::dot(d, back) + margin * spread);
  }

  Camera camera;
  camera.name = "default";
  camera.fov_y_rad = fov_y;
  camera.world_from_camera =
      glm::dmat4(glm::dvec4(right, 0.0), glm::dvec4(up, 0.0), glm::dvec4(back, 0.0),
                 glm::dvec4(centre + distance * back, 1.0));
  return camera;
}

}  // namespace asos
