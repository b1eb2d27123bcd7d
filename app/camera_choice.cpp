#include "app/camera_choice.h"

#include "app/turntable.h"
#include "renderer/comparison/method.h"
#include "renderer/files/printable.h"
#include "renderer/geometry/validate_camera.h"
#include "renderer/geometry/view.h"
#include "renderer/shading/layers.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace asos {
namespace {

Camera camera_looking(const LookAt& look, glm::dvec3 origin) {
  const glm::dvec3 back = glm::normalize(look.eye - look.target);
  // +Y is up, except for a camera that looks straight up or down: then -Z is up.
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

std::string called(const Camera& camera) {
  return camera.name.empty() ? "the camera" : fmt::format("camera '{}'", printable(camera.name));
}

// Fails for orthographic cameras and for values that make no valid lens.
Result<void> set_lens(const LensChoice& choice, Camera& camera) {
  if (!choice.any()) return {};
  if (camera.type != Camera::Type::perspective)
    return tl::unexpected(
        Error{"--aperture, --f-stop", "the chosen camera is orthographic and has no lens"});
  Lens& lens = camera.lens;
  if (choice.radius) lens.radius = *choice.radius;
  if (choice.f_stop) lens.radius = aperture_of_f_stop(*choice.f_stop, camera.fov_y_rad);
  if (choice.focus) lens.focus = *choice.focus;
  if (choice.blades) lens.blades = *choice.blades;
  if (choice.turn_deg) lens.turn_rad = glm::radians(*choice.turn_deg);
  if (const std::string fault = validate_lens(lens); !fault.empty())
    return tl::unexpected(Error{"the lens", fault});
  return {};
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
    // The camera of a saved picture was moved to this scene's origin, so it is checked again.
    if (const std::string fault = validate_camera(camera); !fault.empty())
      return tl::unexpected(Error{fmt::format("camera '{}'", camera.name), fault});
  } else {
    camera = count > 0 ? world.cameras.front() : default_camera(world, aspect_ratio);
  }
  if (!choice.fov_y_deg && !choice.given) camera = fitted_camera(camera, aspect_ratio, choice.fit);
  if (choice.fov_y_deg) {
    if (camera.type != Camera::Type::perspective)
      return tl::unexpected(
          Error{"--fov", "the chosen camera is orthographic and has no field of view"});
    camera.fov_y_rad = *choice.fov_y_deg * glm::pi<double>() / 180.0;
  }
  if (auto lens = set_lens(choice.lens, camera); !lens) return tl::unexpected(lens.error());
  if (!choice.planes) camera = camera.without_planes();
  if (choice.turn) {
    glm::dvec3 middle = 0.5 * (glm::dvec3(world.bounds.lo) + glm::dvec3(world.bounds.hi));
    if (world.bounds.empty()) middle = glm::dvec3(0.0);
    if (choice.look_at) middle = choice.look_at->target - world.origin;
    camera = turned_camera(camera, middle, choice.turn->frame, choice.turn->count);
  }
  return camera;
}

std::string fit_remark(const World& world, const CameraChoice& choice, double aspect_ratio) {
  if (choice.look_at || choice.given || choice.fov_y_deg || choice.fit == CameraFit::crop)
    return {};
  const auto index = static_cast<std::size_t>(choice.index.value_or(0));
  if (index >= world.cameras.size()) return {};
  const Camera& camera = world.cameras[index];
  const Camera fitted = fitted_camera(camera, aspect_ratio, choice.fit);
  const bool perspective = camera.type == Camera::Type::perspective;
  const double before = perspective ? glm::degrees(camera.fov_y_rad) : camera.height;
  const double after = perspective ? glm::degrees(fitted.fov_y_rad) : fitted.height;
  if (before == after) return {};
  return fmt::format(
      "{} has the aspect ratio {:.3g} and the picture {:.3g}: its {} is {:.4g} instead of "
      "{:.4g} (--fit)",
      called(camera), *camera.aspect_ratio, aspect_ratio,
      perspective ? "vertical angle in degrees" : "height", after, before);
}

std::string lens_remark(const Camera& camera, const LensChoice& lens, Method method) {
  if (!camera.lens.blurs())
    return lens.any() && !lens.radius
               ? "--focus, --blades and --blade-turn have no effect without --aperture or --f-stop"
               : "";
  const MethodRow& row = row_of(method);
  if (!row.takes_lens)
    return fmt::format("{} renders without depth of field; {}'s lens is ignored", row.name,
                       called(camera));
  if (!camera.lens.focus || camera.lens.radius <= *camera.lens.focus) return "";
  return fmt::format(
      "the lens of {} has a radius of {:.4g}, but its focus plane is only {:.4g} ahead; all but "
      "that plane is blurred beyond recognition",
      called(camera), camera.lens.radius, *camera.lens.focus);
}

std::string planes_remark(const RenderScene& scene, const Camera& camera,
                          const RenderSettings& settings) {
  if (!camera.near_depth && !camera.far_depth) return {};
  constexpr int columns = 64, rows = 36;
  const View view(camera.without_planes(), settings.width, settings.height,
                  radius_around_origin(scene.world().bounds));
  const glm::dvec3 eye(camera.world_from_camera[3]), forward(-camera.world_from_camera[2]);
  bool nearer = false, farther = false;
  for (int i = 0; i < columns * rows; ++i) {
    const Ray ray = view.ray(settings.width * (i % columns + 0.5) / columns,
                             settings.height * (i / columns + 0.5) / rows);
    const Hit hit = closest_visible(scene.world(), scene.render_features, scene.rays(), ray,
                                    culling_of(settings));
    if (!hit.valid()) continue;
    const double depth = glm::dot(glm::dvec3(ray.at(hit.t)) - eye, forward);
    nearer |= camera.near_depth && depth < *camera.near_depth;
    farther |= camera.far_depth && depth > *camera.far_depth;
  }
  if (!nearer && !farther) return {};
  const std::string near_text =
      nearer ? fmt::format("nearer than {:.4g} (znear)", *camera.near_depth) : "";
  const std::string far_text =
      farther ? fmt::format("farther than {:.4g} (zfar)", *camera.far_depth) : "";
  return fmt::format("{} cuts off surfaces {}{}{} (--clip off shows them)", called(camera),
                     near_text, nearer && farther ? " or " : "", far_text);
}

}  // namespace asos
