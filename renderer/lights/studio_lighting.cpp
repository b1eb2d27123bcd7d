#include "renderer/lights/studio_lighting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

constexpr double distance_in_radii = 12.0;
constexpr double width_to_distance = 0.4;
// A warm key and a cool fill; their strongest component is 1.
constexpr glm::vec3 key_color{1.0f, 0.95f, 0.88f};
constexpr glm::vec3 fill_color{0.80f, 0.91f, 1.0f};

struct Sphere {
  glm::dvec3 middle{0.0};
  double radius = 1.0;
};

Sphere sphere_around(const Box& bounds) {
  if (bounds.empty()) return {};
  const glm::dvec3 lo(bounds.lo);
  const glm::dvec3 hi(bounds.hi);
  const double radius = 0.5 * glm::length(hi - lo);
  return {0.5 * (lo + hi), radius > 0.0 ? radius : 1.0};
}

/// `towards` is the direction to the light as (right, up, back to the viewer).
Light studio_light(const char* name, const glm::dmat3& world_from_rig, const Sphere& scene,
                   glm::dvec3 towards, double radiance, glm::vec3 color) {
  const glm::dvec3 to_light = glm::normalize(world_from_rig * towards);
  const double distance = distance_in_radii * scene.radius;
  const double half = 0.5 * width_to_distance * distance;
  Light light = lighting_rectangle(name, scene.middle + distance * to_light, -to_light,
                                   world_from_rig[0], half, half);
  const glm::dvec3 near_middle = scene.middle + 0.5 * scene.radius * to_light;
  light.intensity = static_cast<float>(std::numbers::pi * radiance /
                                       irradiance_of_unit(light, near_middle, to_light));
  light.color = color;
  return light;
}

}  // namespace

std::vector<Light> studio_lighting(const Camera& camera, const Box& bounds) {
  const glm::dmat3 world_from_rig = lighting_axes(camera);
  const Sphere scene = sphere_around(bounds);
  // The key and the fill are 80 degrees apart.
  return {
      studio_light("Studio key", world_from_rig, scene, {-0.6, 1.0, 0.7}, key_radiance, key_color),
      studio_light("Studio fill", world_from_rig, scene, {1.0, 0.35, 0.8}, fill_radiance,
                   fill_color),
  };
}

bool reached(const Light& light, const SeenPoint& point, const FreeDistance& free_distance) {
  // Start clear of the surface, beyond the rounding error of the position.
  const glm::dvec3 from =
      point.position + 1e-4 * glm::distance(point.eye, point.position) * point.normal;
  const glm::dvec3 to_light = light.position - from;
  const double distance = glm::length(to_light);
  return glm::dot(to_light, point.normal) > 0.0 && glm::dot(to_light, light.direction) < 0.0 &&
         free_distance(from, to_light / distance) >= distance;
}

double reached_share(std::span<const Light> lights, std::span<const SeenPoint> seen,
                     const FreeDistance& free_distance) {
  if (seen.empty()) return 0.0;
  const auto count = std::count_if(seen.begin(), seen.end(), [&](const SeenPoint& point) {
    return std::any_of(lights.begin(), lights.end(),
                       [&](const Light& light) { return reached(light, point, free_distance); });
  });
  return static_cast<double>(count) / static_cast<double>(seen.size());
}

}  // namespace asos
