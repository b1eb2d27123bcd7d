#include "renderer/api/convert.h"

#include "asos/asos.h"
#include "renderer/files/printable.h"
#include "renderer/geometry/camera_fit.h"
#include "renderer/geometry/finite.h"
#include "renderer/gltf/validate_light.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos::api {
namespace {

asos::Light::Type type_of(LightType type) {
  using Type = asos::Light::Type;
  switch (type) {
    case LightType::point:
      return Type::point;
    case LightType::spot:
      return Type::spot;
    case LightType::directional:
      return Type::directional;
    case LightType::linear:
      return Type::linear;
    case LightType::rectangle:
      return Type::rectangle;
    case LightType::disk:
      return Type::disk;
  }
  return static_cast<Type>(-1);  // invalid: rejected later
}

}  // namespace

std::string Error::message() const {
  return printable(subject) + ": " + printable(reason);
}

const char* version() noexcept {
  return ASOS_VERSION;
}

glm::dmat4 matrix_of(const Matrix4& m) {
  glm::dmat4 matrix;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      matrix[column][row] = m[static_cast<std::size_t>(4 * column + row)];
  return matrix;
}

bool is_affine(const Matrix4& m) {
  return std::all_of(m.begin(), m.end(), [](double value) { return std::isfinite(value); }) &&
         m[3] == 0.0 && m[7] == 0.0 && m[11] == 0.0 && m[15] == 1.0;
}

asos::Camera camera_of(const Camera& camera, glm::dvec3 origin) {
  asos::Camera of;
  of.name = camera.name;
  of.type = camera.perspective ? asos::Camera::Type::perspective : asos::Camera::Type::orthographic;
  of.world_from_camera = matrix_of(camera.world_from_camera);
  of.world_from_camera[3] -= glm::dvec4(origin, 0.0);
  of.fov_y_rad = camera.fov_y_rad;
  of.height = camera.height;
  of.near_depth = camera.near_depth;
  of.far_depth = camera.far_depth;
  of.lens.radius = camera.aperture_radius;
  of.lens.focus = camera.focus;
  of.lens.blades = camera.blades;
  of.lens.turn_rad = camera.blade_turn_rad;
  of.aspect_ratio = camera.aspect_ratio;
  return of;
}

Camera camera_of(const asos::Camera& camera, glm::dvec3 origin) {
  Camera of;
  of.name = camera.name;
  of.perspective = camera.type == asos::Camera::Type::perspective;
  glm::dmat4 matrix = camera.world_from_camera;
  matrix[3] += glm::dvec4(origin, 0.0);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      of.world_from_camera[static_cast<std::size_t>(4 * column + row)] = matrix[column][row];
  of.fov_y_rad = camera.fov_y_rad;
  of.height = camera.height;
  of.near_depth = camera.near_depth;
  of.far_depth = camera.far_depth;
  of.aperture_radius = camera.lens.radius;
  of.focus = camera.lens.focus;
  of.blades = camera.lens.blades;
  of.blade_turn_rad = camera.lens.turn_rad;
  of.aspect_ratio = camera.aspect_ratio;
  return of;
}

Camera fitted(const Camera& camera, double aspect_ratio, CameraFit fit) {
  constexpr std::array fits{asos::CameraFit::crop, asos::CameraFit::fit, asos::CameraFit::fill};
  const asos::Camera shown = fitted_camera(camera_of(camera, glm::dvec3(0.0)), aspect_ratio,
                                           fits.at(static_cast<std::size_t>(fit)));
  Camera of = camera;
  of.fov_y_rad = shown.fov_y_rad;
  of.height = shown.height;
  return of;
}

double aperture_of_f_stop(double f_stop, double fov_y_rad) {
  return asos::aperture_of_f_stop(f_stop, fov_y_rad);
}

Camera look_at(Double3 eye, Double3 target, double fov_y_rad) {
  const glm::dvec3 back = glm::normalize(vector_of(eye) - vector_of(target));
  const bool vertical = std::hypot(back.x, back.z) < 1e-9;
  const glm::dvec3 up = vertical ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(up, back));
  const glm::dvec3 top = glm::cross(back, right);
  Camera camera;
  camera.name = "look-at";
  camera.world_from_camera = {right.x, right.y, right.z, 0, top.x,  top.y,  top.z,  0,
                              back.x,  back.y,  back.z,  0, eye[0], eye[1], eye[2], 1};
  camera.fov_y_rad = fov_y_rad;
  return camera;
}

Result<asos::Light> light_of(const Light& light) {
  asos::Light of;
  of.name = light.name;
  of.type = type_of(light.type);
  of.color = vector_of(light.color);
  of.intensity = light.intensity;
  of.position = vector_of(light.position);
  of.direction = vector_of(light.direction);
  if (const double length = glm::length(of.direction); length > 0.0 && std::isfinite(length))
    of.direction /= length;
  of.range = light.range;
  of.inner_cone_rad = light.inner_cone_rad;
  of.outer_cone_rad = light.outer_cone_rad;
  of.radius = light.radius;
  of.angular_diameter_rad = light.angular_diameter_rad;
  of.half_u = vector_of(light.half_u);
  of.half_v = vector_of(light.half_v);
  of.two_sided = light.two_sided;
  of.casts_shadows = light.casts_shadows;
  if (const std::string fault = gltf::validate_light(of); !fault.empty())
    return failure(ErrorCode::invalid_argument, "light '" + light.name + "'", fault);
  return of;
}

}  // namespace asos::api
