#include "renderer/shading/layers.h"
#include "renderer/shading/shade.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <cmath>

// Transparent surfaces along a ray, and the error of multiplying their mean transmittances.

namespace asos {

float unevenness_of(std::span<const SurfaceLayer> layers) {
  // Mean transmittance of the layers so far, and the mean of its square, as if they were
  // independent.
  float mean = 1.0f, mean_square = 1.0f, unevenness = 0.0f;
  for (const SurfaceLayer& layer : layers) {
    // An opacity in between may be the mean of 0 and 1 at different points.
    const float variance = layer.varies ? layer.opacity * (1.0f - layer.opacity) : 0.0f;
    const float variance_before = std::max(0.0f, mean_square - mean * mean);
    unevenness += std::sqrt(variance_before * variance);
    const float through = 1.0f - layer.opacity;
    mean_square *= through * through + variance;
    mean *= through;
  }
  return unevenness;
}

void SurfaceWalk::go_on(const SurfacePoint& point) {
  if (place_.empty() && rays_->is_coplanar(hit_)) {
    rays_->in_place(ray_, hit_, faces_, place_);
    const auto own = [this](const Hit& hit) { return hit.triangle == hit_.triangle; };
    next_ =
        static_cast<std::size_t>(std::find_if(place_.begin(), place_.end(), own) - place_.begin()) +
        1;
  }
  if (next_ < place_.size()) {
    hit_ = place_[next_++];
    return;
  }
  ray_.t_near = behind(ray_, point, hit_.t);
  for (const Hit& passed : place_)
    ray_.t_near =
        std::max(ray_.t_near, std::nextafter(passed.t, std::numeric_limits<float>::infinity()));
  place_.clear();
  next_ = 0;
  hit_ = rays_->closest(ray_, faces_);
}

Hit closest_visible(const World& world, const RenderFeatures& render_features, const RayScene& rays,
                    const Ray& ray, Culling faces) {
  SurfaceWalk walk(rays, ray, rays.closest(ray, faces), faces);
  for (LayerCount count; walk.hit().valid() && !count.full(); count.pass_clear()) {
    const Hit& hit = walk.hit();
    if (world.material_of(hit.triangle).alpha_mode != AlphaMode::blend ||
        opacity_at(world, hit.triangle, hit.b1, hit.b2) > 0.0f)
      return hit;
    walk.go_on(surface_point(world, render_features, hit, -ray.direction));
  }
  return walk.hit();
}

std::vector<SurfaceLayer> Shader::layers(const ViewedRay& seen, RenderStatistics& counts) const {
  std::vector<SurfaceLayer> found;
  const SampleExtent extent{seen.spacing ? seen.spacing : &settings_.spacing, settings_.mips,
                            seen.side, seen.shape};
  const glm::vec3 to_viewer = -seen.ray.direction;
  SurfaceWalk walk(rays_, seen.ray, seen.hit, settings_.faces);
  float through = 1.0f;
  for (LayerCount count; walk.hit().valid() && !count.full();) {
    const Hit hit = walk.hit();
    const Material& material = world_.material_of(hit.triangle);
    SurfaceLayer layer{hit};
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
    walk.go_on(point);
    ++(seen.bounces > 0 ? counts.reflection_rays : counts.eye_rays);
  }
  return found;
}

}  // namespace asos
