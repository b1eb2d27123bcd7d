#include "renderer/shading/layers.h"
#include "renderer/shading/shade.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <cmath>

// What is lost where layers are seen by the means of what each lets through.

namespace asos {

float Shader::unevenness_of_layers(const ViewedRay& seen, RenderStatistics& counts) const {
  if (!needs_.alpha_blend || !needs_.varying_opacity || !settings_.mips || !(seen.side > 0.0f))
    return 0.0f;
  const SampleExtent extent{seen.spacing ? seen.spacing : &settings_.spacing, settings_.mips,
                            seen.side, seen.shape};
  const glm::vec3 to_viewer = -seen.ray.direction;
  Ray ray = seen.ray;
  Hit hit = seen.hit;
  // The mean of what all layers so far let through, and of its square, as if each were by itself.
  float mean = 1.0f, mean_square = 1.0f, unevenness = 0.0f;
  for (int layer = 0; layer < max_layers && hit.valid() && mean > invisible_share; ++layer) {
    const Material& material = world_.material_of(hit.triangle);
    if (surface_kind(material) != SurfaceKind::blended || material.transmission > 0.0f) break;
    const SurfacePoint point = surface_point(world_, needs_, hit, to_viewer, extent);
    const float opacity =
        surface_material(world_, needs_, hit, point.footprint, settings_.mips).opacity;
    // What is there in part may be all of it here, and nothing there.
    const bool varies = material.base_color_texture.used();
    const float variance = varies ? opacity * (1.0f - opacity) : 0.0f;
    const float variance_before = std::max(0.0f, mean_square - mean * mean);
    unevenness += std::sqrt(variance_before * variance);
    const float through = 1.0f - opacity;
    mean_square *= through * through + variance;
    mean *= through;
    ray.t_near = behind(ray, point, hit.t);
    hit = rays_.closest(ray, settings_.faces);
    ++(seen.bounces > 0 ? counts.reflection_rays : counts.eye_rays);
  }
  return unevenness;
}

}  // namespace asos
