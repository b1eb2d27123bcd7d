#include "renderer/asos/eye_caster.h"

#include <algorithm>

namespace asos {
namespace {

bool some_cast_shadows(const EyeContext& eye) {
  const auto lights = eye.viewer.shader.lights();
  return eye.settings->shadow.cast &&
         std::any_of(lights.begin(), lights.end(), [](const auto& l) { return l.casts_shadows; });
}

ShadowContext shadows_of(const EyeContext& eye, const ShadowScene& scene, PatchView& view,
                         ShadowGroups& groups) {
  const RenderSettings& settings = *eye.settings;
  ShadowContext shadows;
  shadows.scene = &scene;
  shadows.rules = {settings.shadow.quality, settings.shadow.divisions, eye.budget,
                   settings.asos.leaf == Leaf::exact,
                   eye.scene->needs.varying_opacity && eye.scene->features().opacity_unbounded()};
  shadows.lights = eye.viewer.shader.lights().size();
  shadows.frame = eye.frame;
  shadows.view = &view;
  shadows.groups = &groups;
  shadows.work = &eye.work->shadows;
  return shadows;
}

}  // namespace

EyeCaster::EyeCaster(const EyeContext& eye, std::size_t roots)
    : eye_(eye),
      casts_shadows_(some_cast_shadows(eye)),
      shades_parts_(casts_shadows_),
      samples_(eye_),
      shadow_scene_{eye.scene->world(), eye.scene->features(), eye.scene->rays()},
      groups_(shadow_scene_),
      shadows_(shadows_of(eye_, shadow_scene_, samples_, groups_)),
      weak_lights_(eye_, samples_),
      refinement_(eye_, samples_, weak_lights_, shadows_),
      sums_(roots),
      leaf_shader_(eye_, samples_, refinement_, weak_lights_, shadows_, sums_, blurred_) {}

void EyeCaster::middles_known(int side) {
  groups_.reset(eye_.viewer.shader.lights().size());
  if (casts_shadows_) {
    bool unlit = false, lit = false;
    for (SampleId i = 0; i < static_cast<SampleId>(side * side); ++i) {
      if (!samples_.hit(i).valid()) continue;
      (eye_.scene->world().material_of(samples_.hit(i).triangle).unlit ? unlit : lit) = true;
      const SurfacePoint point = samples_.point(i);
      groups_.add(samples_.hit(i), point.position, point.geometric_normal, samples_.patch(i, 1.0));
    }
    shades_parts_ = lit || !unlit;
  }
  refinement_.learn_normals(side);
  weak_lights_.find(side);
}

SampleId EyeCaster::sample_saturated(std::uint32_t root, const Square& square, double weight) {
  if (!eye_.budget.refines()) return no_sample;
  const SampleId sample = samples_.add_unseen({square.centre_u(), square.centre_v()});
  const std::uint64_t before = eye_.counts->rays();
  const bool sampled =
      leaf_shader_.add_samples(root, sample, {square, {}}, weight, LeafShader::enough_samples);
  sums_[root].rays += eye_.counts->rays() - before;
  return sampled ? sample : no_sample;
}

glm::vec3 EyeCaster::colour(std::uint32_t root) const {
  if (eye_.mask && eye_.mask->blur) return blurred_.mean(*eye_.mask->blur);
  return sums_[root].mean();
}

}  // namespace asos
