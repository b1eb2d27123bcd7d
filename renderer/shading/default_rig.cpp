#include "renderer/shading/default_rig.h"

#include <cmath>

namespace asos {
namespace {

/// `towards` the light, as (right, up, back to the viewer).
Light studio_light(const char* name, const glm::dmat3& world_from_rig, glm::dvec3 towards,
                   float irradiance_over_pi, bool casts_shadows) {
  constexpr float pi = 3.14159265f;
  Light light;
  light.name = name;
  light.type = Light::Type::directional;
  light.intensity = irradiance_over_pi * pi;
  light.direction = -glm::normalize(world_from_rig * towards);
  light.casts_shadows = casts_shadows;
  return light;
}

}  // namespace

std::vector<Light> default_rig(const Camera& camera) {
  const glm::dmat4& m = camera.world_from_camera;
  // A camera that looks straight down or up has no "behind" on the ground: its up vector stands in.
  glm::dvec3 back(m[2].x, 0.0, m[2].z);
  if (!(glm::length(back) > 1e-3)) back = {-m[1].x, 0.0, -m[1].z};
  if (!(glm::length(back) > 1e-3)) back = {0.0, 0.0, 1.0};
  back = glm::normalize(back);
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const glm::dmat3 world_from_rig(glm::cross(up, back), up, back);

  // Radiances of a white diffuse surface that faces the light. The key and the fill, 75 degrees
  // apart, and the sky's 0.21 come to 0.9 at most, with the rim light on top elsewhere.
  return {
      studio_light("key", world_from_rig, {-0.6, 1.0, 0.7}, 0.60f, true),
      studio_light("fill", world_from_rig, {1.0, 0.35, 0.8}, 0.16f, false),
      studio_light("rim", world_from_rig, {0.3, 0.6, -1.0}, 0.12f, false),
  };
}

}  // namespace asos
