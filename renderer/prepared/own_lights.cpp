#include "renderer/prepared/own_lights.h"

#include "renderer/geometry/view.h"
#include "renderer/lights/emitters.h"
#include "renderer/lights/studio_lighting.h"
#include "renderer/load_progress.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/texture.h"
#include "renderer/world/ground.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace asos {
namespace {

// Emissive meshes with less than this fraction of the sky's irradiance are decoration (a bicycle's
// reflectors), not the scene's lighting.
constexpr double least_share_of_sky = 0.05;
// Walls block a studio's lights if these reach less than this fraction of the visible points.
constexpr double least_reached_share = 0.25;

/// Returns a surface's emission at a point, times its opacity, as the shader adds it.
glm::vec3 emission_at(const World& world, std::uint32_t triangle, float b1, float b2) {
  const Material& m = world.material_of(triangle);
  glm::vec3 emission = m.emissive * m.emissive_strength;
  if (m.emissive_texture.used()) {
    emission *=
        glm::vec3(sample_texture(world, m.emissive_texture, triangle, b1, b2, Encoding::srgb));
  }
  // Transmission is ignored, since emissive glass emits nevertheless.
  return opacity_at(world, triangle, b1, b2) * emission;
}

/// Returns whether a hit is on the ground, which does not count for the default lights.
bool on_ground(const World& world, const Hit& hit) {
  return ground_of(world) != Ground::off &&
         world.triangle_part[hit.triangle] + 1 == world.solid_parts();
}

/// Returns the surface points at the hits of a grid of eye rays.
std::vector<SeenPoint> look_around(const World& world, const RayScene& rays, const Camera& camera) {
  constexpr int width = 32;
  constexpr int height = 18;
  const View view(camera, width, height);
  std::vector<SeenPoint> seen;
  for (int y = 0; y < height; ++y) {
    stop_point();
    for (int x = 0; x < width; ++x) {
      const Ray ray = view.ray(x + 0.5, y + 0.5);
      const Hit hit = rays.closest(ray, Culling::as_material_says);
      if (!hit.valid() || on_ground(world, hit)) continue;
      const SurfacePoint point = surface_point(world, {}, hit, -ray.direction);
      seen.push_back({ray.origin, point.position, point.geometric_normal});
    }
  }
  return seen;
}

double free_distance(const World& world, const RayScene& rays, glm::dvec3 from,
                     glm::dvec3 direction) {
  stop_point();
  Ray ray;
  ray.origin = from;
  ray.direction = direction;
  Blocker blocker;
  rays.blockers({&ray, 1}, {&blocker, 1});
  if (!blocker.hit.valid() || on_ground(world, blocker.hit))
    return std::numeric_limits<double>::infinity();
  return blocker.hit.t;
}

}  // namespace

std::vector<Light> lights_of_meshes(const World& world) {
  return emissive_lights(world, emission_at);
}

bool needs_default_lighting(const World& world, std::span<const Light> lights_of_file,
                            std::span<const Light> emissive) {
  const bool shines =
      std::any_of(lights_of_file.begin(), lights_of_file.end(), [](const Light& light) {
        const float brightest = std::max({light.color.x, light.color.y, light.color.z});
        // The colour of a light that the user switched off contains its intensity (LIGHTS.md).
        const bool switched_off = light.intensity == 0.0f && brightest > 1.0f;
        return switched_off || light.intensity * brightest > 0.0f;
      });
  if (shines) return false;
  if (world.bounds.empty()) return true;
  const double radius =
      0.5 * glm::length(glm::dvec3(world.bounds.hi) - glm::dvec3(world.bounds.lo));
  const double sky = std::numbers::pi * static_cast<double>(ambient_radiance);
  return !(mean_irradiance(emissive, radius) >= least_share_of_sky * sky);
}

Camera first_camera(const World& world) {
  return world.cameras.empty() ? default_camera(world, 16.0 / 9.0) : world.cameras.front();
}

DefaultLighting default_lighting(const World& world, const Box& bounds, const RayScene& rays) {
  const Camera camera = first_camera(world);
  std::vector<Light> studio = studio_lighting(camera, bounds);
  const std::vector<SeenPoint> seen = look_around(world, rays, camera);
  const FreeDistance way = [&](glm::dvec3 from, glm::dvec3 direction) {
    return free_distance(world, rays, from, direction);
  };
  if (seen.empty() || reached_share(studio, seen, way) >= least_reached_share)
    return {std::move(studio), false};
  return {interior_lighting(camera, bounds, seen, way), true};
}

}  // namespace asos
