#include "renderer/world/framing.h"

#include <numbers>

namespace asos {

Camera default_camera(const World& world, double aspect_ratio) {
  const glm::dvec3 back = glm::normalize(glm::dvec3(0.55, 0.4, 1.0));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back));
  Camera camera;
  camera.name = "default";
  camera.fov_y_rad = 40.0 * std::numbers::pi / 180.0;
  camera.world_from_camera =
      glm::dmat4(glm::dvec4(right, 0.0), glm::dvec4(glm::cross(back, right), 0.0),
                 glm::dvec4(back, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0));
  return frame_world(world, camera, aspect_ratio).camera;
}

}  // namespace asos
