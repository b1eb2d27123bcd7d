#include "renderer/scene/turned_camera.h"

#include <glm/gtc/matrix_transform.hpp>

#include <numbers>

namespace asos {

Camera turned_camera(const Camera& camera, glm::dvec3 middle, int frame, int count) {
  if (frame % count == 0) return camera;
  const double angle = 2.0 * std::numbers::pi * frame / count;
  Camera turned = camera;
  turned.world_from_camera = glm::translate(glm::dmat4(1.0), middle) *
                             glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(0, 1, 0)) *
                             glm::translate(glm::dmat4(1.0), -middle) * camera.world_from_camera;
  return turned;
}

}  // namespace asos
