#include "renderer/asos/leaf_gloss.h"

#include "renderer/asos/highlight_rays.h"
#include "renderer/geometry/largest.h"
#include "renderer/shading/anisotropy.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/unevenness.h"

#include <algorithm>

namespace asos {

// What glossy surfaces mirror, and the highlights of lights that have a size, but for those that a
// reflection shows.
ShadingError LeafGloss::error(SampleId sample, double share, const Patch& patch) const {
  const RenderScene& scene = *eye_->scene;
  const Hit& hit = samples_->hit(sample);
  // Textures make roughness less only.
  const Material& material = scene.world().material_of(hit.triangle);
  const bool by_dfr = eye_->viewer.shader.settings().dfr || scene.dfr_of(hit.triangle);
  if (material.unlit || !(by_dfr || may_be_glossy(material))) return {};
  const SurfacePoint point = samples_->point(sample);
  GlossyPatch glossy{point, normal_turn(scene.world(), hit, patch, point.shading_normal), patch,
                     -samples_->ray(sample).direction, eye_->viewer.spacing.distance(hit.t)};
  const bool highlights =
      extended_lights_ && !by_dfr && eye_->settings->shadow.light_rule == LightRule::physical;
  if (!highlights && !turns(glossy)) return {};
  const SurfaceMaterial seen = surface_material(scene.world(), scene.needs, hit);
  if (seen.anisotropy.strength > 0.0f) {
    glossy.stretch = lobe_stretch(scene.world(), hit, seen.anisotropy, seen.roughness,
                                  point.shading_normal, glossy.to_viewer);
    glossy.stretch_turn = tangent_turn(scene.world(), hit, patch, point.shading_normal);
  }
  glossy.white = static_cast<float>(1.0 / share);
  ShadingError all;
  const auto add = [&](const Gloss& gloss) {
    glossy.f0 = gloss.f0, glossy.roughness = gloss.roughness;
    all.error += reflectance_error(glossy);
    if (!highlights || !has_highlights(gloss.roughness)) return;
    const HighlightError found = highlights_error(glossy);
    all.highlights.error += found.error;
    all.highlights.contrast += found.contrast;
  };
  add({largest(seen.f0), seen.roughness});
  glossy.stretch = {};
  if (seen.coat.factor > 0.0f) add({coat_f0 * seen.coat.factor, seen.coat.roughness});
  return all;
}

// Of one of the surface's lobes.
HighlightError LeafGloss::highlights_error(const GlossyPatch& glossy) const {
  const auto lights = eye_->viewer.shader.lights();
  const float tolerance = eye_->budget.tolerance;
  const float negligible = 0.5f * tolerance / static_cast<float>(lights.size());
  HighlightError all;
  for (std::size_t i = 0; i < lights.size() && !(all.error > tolerance); ++i) {
    if (weak_lights_->holds(i)) continue;
    const HighlightError one = highlight_error(lights[i], glossy);
    if (one.error > negligible &&
        !shows_highlight(*eye_, static_cast<std::uint32_t>(i), glossy.point, glossy.to_viewer))
      continue;
    all.error += one.error;
    all.contrast += one.contrast;
  }
  return all;
}

}  // namespace asos
