#include "renderer/study/regions.h"

#include "renderer/asos/texture_samples.h"
#include "renderer/film/split_map.h"
#include "renderer/geometry/largest.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/shading/anisotropy.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/shadow_ray.h"
#include "renderer/shading/surface.h"

#include <algorithm>

namespace asos {
namespace {

/// Points along a side of a light that are tested for partial occlusion.
constexpr int light_grid = 4;

/// Classifies the content of single pixels.
class Looker {
 public:
  explicit Looker(const Snapshot& snapshot)
      : scene_(*snapshot.scene),
        settings_(snapshot.settings),
        view_(snapshot.camera, settings_.width, settings_.height,
              radius_around_origin(scene_.world().bounds)),
        shader_(shader_of(scene_, settings_, view_)) {}

  [[nodiscard]] Region look(double x, double y) const {
    const Ray ray = view_.ray(x, y);
    const Hit hit = scene_.rays().closest(ray, culling_of(settings_));
    if (!hit.valid()) return Region::rest;
    const SurfacePoint point =
        surface_point(scene_.world(), scene_.render_features, hit, -ray.direction);
    if (point.geometric_normal == glm::vec3(0.0f)) return Region::rest;
    const SurfaceMaterial material = surface_material(scene_.world(), scene_.render_features, hit);
    // A metal shows reflections instead of shadows.
    const bool mirrors = in_mirror(ray, hit, point, material);
    if (mirrors && material.metallic > 0.5f) return Region::reflections;
    if (settings_.shadow.cast && !material.unlit && in_penumbra(point)) return Region::penumbrae;
    if (mirrors) return Region::reflections;
    return is_textured(scene_.world().material_of(hit.triangle), scene_.render_features)
               ? Region::textures
               : Region::rest;
  }

 private:
  [[nodiscard]] bool in_mirror(const Ray& ray, const Hit& hit, const SurfacePoint& point,
                               const SurfaceMaterial& material) const {
    if (material.unlit) return false;
    const float facing = std::max(0.0f, glm::dot(point.shading_normal, -ray.direction));
    return shader_
        .mirror_width(shader_.eye_ray(ray, hit, 1.0f), point, widest_roughness(material),
                      material.opacity * viewed(material, facing).specular)
        .has_value();
  }

  [[nodiscard]] bool in_penumbra(const SurfacePoint& point) const {
    const Receiver receiver = receiver_at(point);
    return std::any_of(
        shader_.lights().begin(), shader_.lights().end(), [&](const PreparedLight& light) {
          return light.casts_shadows && light.extended() && seen_in_part(light, receiver, point);
        });
  }

  [[nodiscard]] bool seen_in_part(const PreparedLight& light, const Receiver& receiver,
                                  const SurfacePoint& point) const {
    int lit = 0;
    int hidden = 0;
    for (int i = 0; i < light_grid * light_grid && (lit == 0 || hidden == 0); ++i) {
      const LightSample sample = sample_light(light, receiver, (i % light_grid + 0.5) / light_grid,
                                              (i / light_grid + 0.5) / light_grid);
      if (sample.irradiance == glm::vec3(0.0f)) continue;
      const float share =
          largest(scene_.rays().transmittance(shadow_ray(point, sample), light.own_part));
      ++(share > 0.5f ? lit : hidden);
    }
    return lit > 0 && hidden > 0;
  }

  const RenderScene& scene_;
  RenderSettings settings_;
  View view_;
  Shader shader_;
};

bool at_boundary(SplitCause cause) {
  switch (cause) {
    case SplitCause::outline:
    case SplitCause::crease:
    case SplitCause::intersection:
    case SplitCause::cut_out:
    case SplitCause::saturation:
    case SplitCause::depth_limit:
      return true;
    case SplitCause::none:
    case SplitCause::shadow:
    case SplitCause::reflection:
    case SplitCause::shading:
    case SplitCause::lens:
    case SplitCause::motion:
      break;
  }
  return false;
}

}  // namespace

RenderSettings region_settings(RenderSettings settings) {
  RenderSettings fixed;
  fixed.width = settings.width;
  fixed.height = settings.height;
  fixed.threads = settings.threads;
  fixed.shadow.cast = settings.shadow.cast;
  fixed.sky = settings.sky;
  fixed.mirror.bounces = settings.mirror.bounces;
  fixed.mirror.roughest = settings.mirror.roughest;
  fixed.mirror.dfr = settings.mirror.dfr;
  fixed.asos.max_level = 4;
  return fixed;
}

RegionMap find_regions(const Snapshot& snapshot, const Film& film) {
  const Looker looker(snapshot);
  RegionMap map{film.width, film.height, {}, {}, film.cause};
  map.region.reserve(film.radiance.size());
  for (std::size_t i = 0; i < film.radiance.size(); ++i)
    map.split_value.push_back(SplitMapKey{}.value(film, i));
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const SplitCause cause = film.cause[film.index(x, y)];
      if (at_boundary(cause))
        map.region.push_back(Region::outlines);
      else if (cause == SplitCause::shadow)
        map.region.push_back(Region::penumbrae);
      else if (cause == SplitCause::reflection)
        map.region.push_back(Region::reflections);
      else
        map.region.push_back(looker.look(x + 0.5, y + 0.5));
    }
  }
  return map;
}

}  // namespace asos
