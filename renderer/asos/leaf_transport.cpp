#include "renderer/asos/leaf_transport.h"

#include "renderer/asos/highlight_rays.h"
#include "renderer/asos/reflected_pyray.h"
#include "renderer/geometry/largest.h"
#include "renderer/shading/reflected_light.h"
#include "renderer/shadows/shadow.h"

#include <algorithm>
#include <limits>

namespace asos {

HandledLights LeafTransport::gather(const LightingQuery& /*point*/) {
  if (selected_->lights().empty()) return {};
  lit_by_selected_ = true;
  return {selected_->lights()};
}

void LeafTransport::add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) {
  const glm::vec3 without = radiance;
  const glm::vec3 all = lit.reflected * lit.unshadowed;
  if (all == glm::vec3(0.0f)) return;
  const CountForLight count(counts, lit.index);
  const Estimate visibility = light_visibility(*shadows_, lit, *leaf_, counts);
  const glm::vec3 seen(visibility.value);
  if (visibility.value != Visibility(0.0)) radiance += seen * all;
  unsure_highlights_ += unsure_share(lit, seen) * lit.highlight;
  const bool in_part = radiance != without && radiance != without + all;
  shadow_cut_ |= in_part && visibility.cost > 1.0 && !lit.light.extended();
}

// Returns the bound on a highlight's visibility error when it is approximated by the light's
// visibility. That is the smaller of the visible and hidden fractions if the highlight's rays agree
// with the larger one, else the larger fraction.
float LeafTransport::unsure_share(const Illumination& lit, glm::vec3 seen) const {
  const float lesser = largest(glm::min(seen, 1.0f - seen));
  // The visibility of a broad lobe is computed with its shadow (area_shadow).
  if (is_broad(lit)) return 0.0f;
  const float tolerance = eye_->error_budget.tolerance;
  const bool may_matter = lesser > 0.0f && (1.0f - lesser) * lit.highlight > tolerance;
  if (!may_matter || lesser * lit.highlight > tolerance || !lit.lit || eye_->mirrored())
    return lesser;
  const auto [sent, arrived] = rays_to_highlight(
      *eye_, lit.index, lit.point, lit.lit->view.to_viewer, lit.lit->material.lobe.roughness);
  return arrived == (largest(seen) > 0.5f ? sent : 0) ? lesser : 1.0f - lesser;
}

bool LeafTransport::add_sky(const SkyQuery& point, glm::vec3& /*radiance*/,
                            RenderStatistics& /*counts*/) {
  const ViewedMaterial& material = point.material;
  const glm::vec3 specular = point.mirrors ? glm::vec3(0.0f) : material.specular;
  const glm::vec3 diffuse = glm::max(material.diffuse, material.ambient);
  lobes_ = glm::max(lobes_, point.share * (diffuse + specular));
  return true;
}

bool LeafTransport::reflect(const Reflection& reflection, glm::vec3& radiance,
                            RenderStatistics& counts) {
  if (reflection.lobe) {
    lobes_ = glm::max(lobes_, reflection.reflected);
    lobes_show_scene_ = true;
    return true;
  }
  const auto mirrored = trace_reflection(*eye_, reflection, *leaf_, counts);
  if (!mirrored) return false;
  const glm::vec3 reflected(mirrored->value);
  radiance += reflected;
  note(reflection.ratio > 0.0f ? LightPart::transmission : LightPart::reflection, reflected);
  reflection_error_ += mirrored->error;
  mirror_cut_ |= mirrored->cut;
  return true;
}

Estimate LeafTransport::centre(glm::vec3 radiance) const {
  const bool blurs_edge = leaf_->defocused && (shadow_cut_ || mirror_cut_);
  const double error = blurs_edge ? std::numeric_limits<double>::infinity()
                                  : static_cast<double>(unsure_highlights_) + reflection_error_;
  return {glm::dvec3(radiance), error, 1.0};
}

LightSum LeafTransport::light(glm::vec3 radiance) const {
  LightSum all = light_;
  all.weight = 1.0;
  glm::dvec3 direct(radiance);
  for (const glm::dvec3& part : light_.radiance) direct -= part;
  all.add(LightPart::direct, direct);
  return all;
}

}  // namespace asos
