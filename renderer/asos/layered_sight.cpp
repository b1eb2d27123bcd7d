#include "renderer/asos/layered_sight.h"

#include "renderer/asos/part_shape.h"
#include "renderer/asos/soft_shadows.h"
#include "renderer/asos/textured_sight.h"
#include "renderer/world/hit_plane.h"
#include "renderer/world/surface_kind.h"

#include <cmath>
#include <vector>

namespace asos {
namespace {

bool uneven(const EyeContext& eye, const ViewedRay& seen, const Hit& hit, double share) {
  const RenderScene& scene = *eye.scene;
  const World& world = scene.world();
  const Material& material = world.material_of(hit.triangle);
  if (world.is_face(hit.triangle)) return false;
  const glm::dvec3 normal = glm::normalize(hit_plane(world, hit).normal());
  const Patch square = patch_on_plane(eye.viewer.spacing, seen.ray.direction, hit.t,
                                      glm::vec3(normal), eye.side_of(share));
  if (textured_by_several(eye, hit, square) || uneven_products(eye, hit, square, seen.shape, share))
    return true;
  if (material.unlit || !soft_shadows(eye)) return false;
  return (scene.needs.normal_maps && has_normal_map(material)) ||
         scene.features().deviation(hit.triangle) > 0.0f;
}

}  // namespace

LayeredSight layered_sight(const EyeContext& eye, const EyeSamples& samples, SampleId sample,
                           double share, const LeafRegion& region) {
  const Hit& hit = samples.hit(sample);
  if (!eye.scene->needs.alpha_blend || !hit.valid() ||
      surface_kind(eye.scene->world().material_of(hit.triangle)) != SurfaceKind::blended)
    return {};
  const ViewedRay seen = eye.viewer.viewed(samples.ray(sample), hit, eye.side_of(share),
                                           part_shape(region, samples.at(sample)));
  const auto tolerance = static_cast<double>(eye.budget.for_samples().tolerance);
  LayeredSight found;
  const std::vector<SeenLayer> layers = eye.viewer.shader.layers(seen, *eye.counts);
  const auto together = static_cast<double>(unevenness_of(layers));
  found.uneven_together = Budget::usual_contrast * std::sqrt(share) * together > tolerance;
  double through = 1.0;
  for (std::size_t i = 0; i < layers.size() && !found.uneven_behind; ++i) {
    if (!(through > tolerance)) break;
    found.uneven_behind = i > 0 && uneven(eye, seen, layers[i].hit, share);
    through *= 1.0 - static_cast<double>(layers[i].opacity);
  }
  return found;
}

}  // namespace asos
