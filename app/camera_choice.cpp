#include "app/camera_choice.h"

#include "app/turntable.h"
#include "renderer/geometry/camera_fault.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace asos {
namespace {

Camera camera_looking(const LookAt& look, glm::dvec3 origin) {
  const glm::dvec3 back = glm::normalize(look.eye - look.target);
  // +Y is up, but for a camera that looks straight up or down: then the picture's top is -Z.
  const bool along_y = std::hypot(back.x, back.z) < 1e-9;
  const glm::dvec3 up = along_y ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(up, back));
  Camera camera;
  camera.name = "look-at";
  camera.world_from_camera =
      glm::dmat4(glm::dvec4(right, 0), glm::dvec4(glm::cross(back, right), 0), glm::dvec4(back, 0),
                 glm::dvec4(look.eye - origin, 1));
  return camera;
}

}  // namespace

Result<Camera> choose_camera(const World& world, const CameraChoice& choice, double aspect_ratio) {
  Camera camera;
  const int count = static_cast<int>(world.cameras.size());
  if (choice.look_at) {
    camera = camera_looking(*choice.look_at, world.origin);
  } else if (choice.index) {
    if (*choice.index >= count)
      return tl::unexpected(
          Error{fmt::format("--camera {}", *choice.index),
                count == 0 ? std::string("the scene has no cameras")
                           : fmt::format("the scene's cameras are numbered 0 to {}", count - 1)});
    camera = world.cameras[static_cast<std::size_t>(*choice.index)];
  } else if (choice.given) {
    camera = *choice.given;
    // It has been moved from the origin that its picture names.
    if (const std::string fault = camera_fault(camera); !fault.empty())
      return tl::unexpected(Error{fmt::format("camera '{}'", camera.name), fault});
  } else {
    camera = count > 0 ? world.cameras.front() : default_camera(world, aspect_ratio);
  }
  if (choice.fov_y_deg) {
    if (camera.type != Camera::Type::perspective)
      return tl::unexpected(
          Error{"--fov", "the chosen camera is orthographic and has no field of view"});
    camera.fov_y_rad = *choice.fov_y_deg * glm::pi<double>() / 180.0;
  }
  if (choice.turn) {
    glm::dvec3 middle = 0.5 * (glm::dvec3(world.bounds.lo) + glm::dvec3(world.bounds.hi));
    if (world.bounds.empty()) middle = glm::dvec3(0.0);
    if (choice.look_at) middle = choice.look_at->target - world.origin;
    camera = turned_camera(camera, middle, choice.turn->frame, choice.turn->count);
  }
  return camera;
}

}  // namespace asos
