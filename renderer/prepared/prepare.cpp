#include "renderer/geometry/view.h"
#include "renderer/lights/emitters.h"
#include "renderer/lights/light_cuts.h"
#include "renderer/lights/studio_rig.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/rays/surface_kind.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/sky.h"
#include "renderer/shading/texture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <future>
#include <iterator>
#include <limits>
#include <new>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace asos {
namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

bool finite(glm::dvec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// What the renderer relies on; a light without size, or with a bad direction, gives nothing.
std::string fault_of(const Light& light, const std::vector<Light>& built) {
  const glm::vec3 power = light.color * light.intensity;
  bool sound = finite(light.position) && finite(light.direction) && finite(light.half_u) &&
               finite(light.half_v) && finite(glm::dvec3(power)) && std::isfinite(light.radius) &&
               std::isfinite(light.angular_diameter_rad) && light.range > 0.0;
  for (const std::vector<glm::dvec3>& outline : light.outlines)
    sound = sound && std::all_of(outline.begin(), outline.end(), finite);
  if (!sound) return "is not finite";
  const bool known = light.own_part < 0 || std::any_of(built.begin(), built.end(), [&](auto& b) {
                       return b.own_part == light.own_part;
                     });
  return known ? "" : "has an own part that is no light's";
}

std::size_t bytes_of(const World& world) {
  std::size_t bytes =
      bytes_of(world.positions) + bytes_of(world.normals) + bytes_of(world.tangents) +
      bytes_of(world.texcoords[0]) + bytes_of(world.texcoords[1]) + bytes_of(world.colors) +
      bytes_of(world.triangles) + bytes_of(world.triangle_part) + bytes_of(world.parts);
  for (const Image& image : world.images) bytes += bytes_of(image.rgba);
  return bytes;
}

// Emissive meshes that give a scene less than this share of the sky's irradiance are decoration (a
// bicycle's reflectors) and do not light it.
constexpr double least_share_of_sky = 0.05;
// A studio's lights that reach a smaller share of what is seen are shut out by walls.
constexpr double least_reached_share = 0.25;

/// What a surface emits at a point: times its opacity, as the shader adds it.
glm::vec3 emission_at(const World& world, std::uint32_t triangle, float b1, float b2) {
  const Material& m = world.material_of(triangle);
  glm::vec3 emission = m.emissive * m.emissive_strength;
  if (m.emissive_texture.used()) {
    emission *=
        glm::vec3(sample_texture(world, m.emissive_texture, triangle, b1, b2, Encoding::srgb));
  }
  // Without what transmission lets through: glass shines all the same.
  return opacity_at(world, triangle, b1, b2) * emission;
}

/// Whether no light of the file shines at all and emissive meshes give next to nothing.
bool needs_rig(const World& world, std::size_t lights_of_file, const std::vector<Light>& emissive) {
  const auto end = world.lights.begin() + static_cast<std::ptrdiff_t>(lights_of_file);
  const bool shines = std::any_of(world.lights.begin(), end, [](const Light& light) {
    return light.intensity * std::max({light.color.x, light.color.y, light.color.z}) > 0.0f;
  });
  if (shines) return false;
  if (world.bounds.empty()) return true;
  const double radius =
      0.5 * glm::length(glm::dvec3(world.bounds.hi) - glm::dvec3(world.bounds.lo));
  const double sky = std::numbers::pi * static_cast<double>(ambient_radiance);
  return !(mean_irradiance(emissive, radius) >= least_share_of_sky * sky);
}

/// What a grid of eye rays meets.
std::vector<SeenPoint> look_around(const World& world, const RayScene& rays, const Camera& camera) {
  constexpr int width = 32;
  constexpr int height = 18;
  const View view(camera, width, height);
  std::vector<SeenPoint> seen;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Ray ray = view.ray(x + 0.5, y + 0.5);
      const Hit hit = rays.closest(ray, Faces::as_material_says);
      if (!hit.valid()) continue;
      const SurfacePoint point = surface_point(world, {}, hit, -ray.direction);
      seen.push_back({ray.origin, point.position, point.geometric_normal});
    }
  }
  return seen;
}

double free_distance(const RayScene& rays, glm::dvec3 from, glm::dvec3 direction) {
  Ray ray;
  ray.origin = from;
  ray.direction = direction;
  Blocker blocker;
  rays.blockers({&ray, 1}, {&blocker, 1});
  return blocker.hit.valid() ? blocker.hit.t : std::numeric_limits<double>::infinity();
}

/// A studio around the scene; or lights inside, where its walls shut a studio out.
std::vector<Light> rig_for(const World& world, const RayScene& rays) {
  const Camera camera =
      world.cameras.empty() ? default_camera(world, 16.0 / 9.0) : world.cameras.front();
  std::vector<Light> studio = studio_rig(camera, world.bounds);
  const std::vector<SeenPoint> seen = look_around(world, rays, camera);
  const FreeDistance way = [&](glm::dvec3 from, glm::dvec3 direction) {
    return free_distance(rays, from, direction);
  };
  if (seen.empty() || reached_share(studio, seen, way) >= least_reached_share) return studio;
  return interior_rig(camera, world.bounds, seen, way);
}

/// What follows from the lights, once they are known.
void settle_lights(RenderScene& scene) {
  scene.light_cuts = find_light_cuts(scene.world);
  scene.bare_lights = find_bare_lights(scene.world);
  SceneNeeds needs = find_needs(scene.world);
  // White colours that were asked for are not colours; and what passes through what is known now.
  needs.vertex_colors = scene.needs.vertex_colors;
  needs.intersections =
      scene.features.counts().intersection > 0 || !scene.features.intersections_complete();
  scene.needs = needs.with(scene.forced);
}

Result<std::shared_ptr<const RenderScene>> prepare_in_memory(const Scene& scene,
                                                             const SceneNeeds& forced) {
  const auto start = std::chrono::steady_clock::now();
  auto world = flatten(scene);
  if (!world) return unexpected(world.error());

  auto prepared = std::make_shared<RenderScene>();
  prepared->world = std::move(*world);
  prepared->name = scene.name;
  prepared->source = scene.source;
  prepared->notes = scene.notes;
  prepared->forced = forced;

  // Emissive meshes light every scene; only those that show a light of the file do not.
  prepared->needs = find_needs(prepared->world).with(forced);
  const std::size_t lights_of_file = prepared->world.lights.size();
  std::vector<Light> emissive;
  if (prepared->needs.emission) emissive = emissive_lights(prepared->world, emission_at);
  prepared->default_rig = needs_rig(prepared->world, lights_of_file, emissive);
  prepared->emissive_lights = emissive.size();
  std::move(emissive.begin(), emissive.end(), std::back_inserter(prepared->world.lights));
  if (!forced.unused_images) release_unused_images(prepared->world);
  // After the emitters: how finely these are sampled depends on whether there are colours.
  fill_forced_attributes(prepared->world, forced);

  // Neither of the three needs another.
  auto features = std::async(std::launch::async, [&] {
    return FeatureSet(prepared->world, [](const World& w, const TextureUse& use,
                                          std::uint32_t triangle, float b1, float b2) {
      return sample_texture(w, use, triangle, b1, b2, Encoding::linear);
    });
  });
  auto mips =
      std::async(std::launch::async, [&] { return MipChains(prepared->world, prepared->needs); });
  prepared->object_spheres = object_spheres(prepared->world);
  auto rays = RayScene::build(prepared->world, alpha_at, forced);
  prepared->index->features = features.get();
  prepared->index->mips = mips.get();
  if (!rays) return unexpected(Error{scene.source, rays.error().message()});
  prepared->index->rays = std::move(*rays);
  if (prepared->default_rig) {
    // It has no part of the world as its own, so that the rays need not know of it.
    for (Light& light : rig_for(prepared->world, prepared->rays))
      prepared->world.lights.push_back(std::move(light));
  }
  settle_lights(*prepared);
  if (!prepared->features.intersections_complete()) {
    prepared->notes.warnings.emplace_back(
        "surfaces pass through each other or overlap too often; the lines where "
        "they do are found by samples only");
  }

  const std::size_t bytes = bytes_of(prepared->world) + prepared->mips.memory_bytes() +
                            prepared->rays.memory_bytes() + prepared->features.memory_bytes() +
                            bytes_of(prepared->object_spheres);
  prepared->memory_mb = static_cast<double>(bytes) / (1024.0 * 1024.0);
  prepared->build_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return prepared;
}

}  // namespace

SceneNeeds needs_of(const RenderScene& scene, const RenderSettings& settings) {
  SceneNeeds needs = scene.needs;
  needs.mirrors |= settings.mirror.roughest > usual_roughest_mirror;
  needs.sky_picture |= settings.sky && settings.sky->is_picture();
  return needs;
}

Result<std::shared_ptr<const RenderScene>> prepare(const Scene& scene, const SceneNeeds& forced) {
  try {
    return prepare_in_memory(scene, forced);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{scene.source, "does not fit into this machine's memory"});
  }
}

Result<std::shared_ptr<const RenderScene>> with_lights(
    const std::shared_ptr<const RenderScene>& scene, std::vector<Light> lights) {
  const auto& built = scene->built_from ? scene->built_from : scene;
  for (const Light& light : lights) {
    if (std::string fault = fault_of(light, built->world.lights); !fault.empty())
      return unexpected(Error{"light '" + light.name + "'", std::move(fault)});
  }
  try {
    auto relit = std::make_shared<RenderScene>(*scene);
    relit->built_from = built;
    relit->world.lights = std::move(lights);
    relit->default_rig = false;
    relit->emissive_lights = static_cast<std::size_t>(
        std::count_if(relit->world.lights.begin(), relit->world.lights.end(),
                      [](const Light& light) { return light.own_part >= 0; }));
    settle_lights(*relit);
    return relit;
  } catch (const std::bad_alloc&) {
    return unexpected(Error{scene->source, "does not fit into this machine's memory"});
  }
}

}  // namespace asos
