#include "renderer/samples/layer_probe.h"

#include "renderer/shading/texture.h"
#include "renderer/world/surface_kind.h"

#include <cmath>

namespace asos {
namespace {

Shader coverage_shader(const RenderScene& scene, const View& view, RenderSettings settings) {
  settings.background.content = PixelContent::coverage;
  settings.sky = nullptr;
  settings.shadow = {};
  settings.shadow.cast = false;
  return shader_of(scene, settings, view);
}

}  // namespace

LayerProbe::LayerProbe(const RenderScene& scene, const ViewContext& viewer,
                       const RenderSettings& settings)
    : scene_(&scene),
      viewer_(&viewer),
      layers_(settings.layers),
      points_(layers_.has(Layer::normal) || layers_.has(Layer::geometric_normal)),
      materials_(layers_.has(Layer::albedo)),
      mips_(settings.texture.filter == TextureFilter::footprint ? &scene.mips() : nullptr) {
  if (scene.render_features.alpha_blend)
    coverage_.emplace(coverage_shader(scene, viewer.view, settings));
}

LayerSample LayerProbe::at(const ViewedRay& ray, RenderStatistics& counts) const {
  LayerSample sample;
  ViewedRay seen = ray;
  if (!seen.hit.valid()) return sample;
  const World& world = scene_->world();
  sample.alpha = 1.0f;
  // The first surface that is there stands for a transparent ray.
  if (coverage_ && surface_kind(world.material_of(seen.hit.triangle)) == SurfaceKind::blended) {
    const CoveredRay covered = coverage_->covered(seen, counts);
    if (covered.surfaces.empty()) return {};
    sample.alpha = covered.coverage;
    for (const SurfaceCover& surface : covered.surfaces) {
      const std::uint32_t object = world.triangle_part[surface.hit.triangle];
      sample.covers.push_back({object, world.parts[object].material, surface.share});
    }
    seen.hit = covered.surfaces.front().hit;
  }
  const Hit& hit = seen.hit;
  sample.object = world.triangle_part[hit.triangle];
  sample.material = world.parts[sample.object].material;
  sample.distance = viewer_->spacing.start + hit.t;
  sample.depth = static_cast<float>(viewer_->view.depth(seen.ray, hit.t));
  if (layers_.has(Layer::position))
    sample.position = glm::vec3(world.origin + glm::dvec3(seen.ray.origin) +
                                static_cast<double>(hit.t) * glm::dvec3(seen.ray.direction));
  if (layers_.has(Layer::uv)) {
    const TextureUse& use = world.material_of(hit.triangle).base_color_texture;
    const glm::vec2 uv =
        texcoord_at(world, use.used() ? use.texcoord : 0, hit.triangle, hit.b1, hit.b2);
    if (std::isfinite(uv.x + uv.y)) sample.uv = uv;
  }
  if (points_ || materials_) add_surface(seen, sample);
  return sample;
}

void LayerProbe::add_surface(const ViewedRay& seen, LayerSample& sample) const {
  const World& world = scene_->world();
  const Hit& hit = seen.hit;
  const SampleExtent extent{&viewer_->spacing, mips_, seen.side, seen.shape, seen.colours};
  const SurfacePoint point =
      surface_point(world, scene_->render_features, hit, -seen.ray.direction, extent);
  sample.normal = point.shading_normal;
  sample.geometric_normal = point.geometric_normal;
  if (!materials_) return;
  const SurfaceMaterial material = surface_material(
      world, scene_->render_features, hit, point.footprint, extent.point() ? nullptr : mips_);
  sample.albedo = material.base_color;
}

}  // namespace asos
