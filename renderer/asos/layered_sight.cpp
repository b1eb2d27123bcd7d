#include "renderer/asos/layered_sight.h"

#include "renderer/asos/part_shape.h"
#include "renderer/world/surface_kind.h"

#include <cmath>

namespace asos {

bool sees_uneven_layers(const EyeContext& eye, const EyeSamples& samples, SampleId sample,
                        double share, const LeafRegion& region) {
  const Budget& budget = eye.budget;
  const SceneNeeds& needs = eye.scene->needs;
  const Hit& hit = samples.hit(sample);
  if (!needs.alpha_blend || !needs.varying_opacity || !budget.refines() || budget.max_level == 0 ||
      region.marginal || !hit.valid())
    return false;
  const Material& material = eye.scene->world().material_of(hit.triangle);
  if (surface_kind(material) != SurfaceKind::blended) return false;
  const ViewedRay seen = eye.viewer.viewed(samples.ray(sample), hit, eye.side_of(share),
                                           part_shape(region, samples.at(sample)));
  const auto uneven =
      static_cast<double>(eye.viewer.shader.unevenness_of_layers(seen, *eye.counts));
  return Budget::usual_contrast * std::sqrt(share) * uneven >
         static_cast<double>(budget.for_samples().tolerance);
}

}  // namespace asos
