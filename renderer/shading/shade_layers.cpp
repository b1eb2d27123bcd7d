#include "renderer/shading/layers.h"
#include "renderer/shading/shade.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <cmath>

// Surfaces that are seen one through the other, and what is lost where they are seen by the means
// of what each lets through.

namespace asos {

float unevenness_of(std::span<const SeenLayer> layers) {
  // The mean of what all layers so far let through, and of its square, as if each were by itself.
  float mean = 1.0f, mean_square = 1.0f, unevenness = 0.0f;
  for (const SeenLayer& layer : layers) {
    // What is there in part may be all of it here, and nothing there.
    const float variance = layer.varies ? layer.opacity * (1.0f - layer.opacity) : 0.0f;
    const float variance_before = std::max(0.0f, mean_square - mean * mean);
    unevenness += std::sqrt(variance_before * variance);
    const float through = 1.0f - layer.opacity;
    mean_square *= through * through + variance;
    mean *= through;
  }
  return unevenness;
}

std::vector<SeenLayer> Shader::layers(const ViewedRay& seen, RenderStatistics& counts) const {
  std::vector<SeenLayer> found;
  const SampleExtent extent{seen.spacing ? seen.spacing : &settings_.spacing, settings_.mips,
                            seen.side, seen.shape};
  const glm::vec3 to_viewer = -seen.ray.direction;
  Ray ray = seen.ray;
  Hit hit = seen.hit;
  float through = 1.0f;
  for (LayerCount count; hit.valid() && !count.full();) {
    const Material& material = world_.material_of(hit.triangle);
    SeenLayer layer{hit};
    const bool bends = bounds_volume(material) || is_frosted(material);
    if (surface_kind(material) != SurfaceKind::blended || bends) {
      found.push_back(layer);
      break;
    }
    const SurfacePoint point = surface_point(world_, needs_, hit, to_viewer, extent);
    const SurfaceMaterial own =
        surface_material(world_, needs_, hit, point.footprint, settings_.mips);
    layer.opacity = own.opacity * (1.0f - own.transmission);
    layer.varies = material.alpha_mode == AlphaMode::blend && material.base_color_texture.used();
    through *= 1.0f - layer.opacity;
    if (own.opacity > 0.0f) {
      found.push_back(layer);
      count.add_layer();
    } else {
      count.pass_clear();
    }
    if (invisible(through, count.layers())) break;
    ray.t_near = behind(ray, point, hit.t);
    hit = rays_.closest(ray, settings_.faces);
    ++(seen.bounces > 0 ? counts.reflection_rays : counts.eye_rays);
  }
  return found;
}

}  // namespace asos
