#include "renderer/asos/eye_caster.h"

#include "renderer/geometry/largest.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace asos {
namespace {

// Returns whether a part of a perspective frame may show a surface brighter than white.
bool may_glare(const EyeContext& eye, const Square& square) {
  if (eye.frame->parallel()) return false;
  const auto towards = [&](double u, double v) {
    return glm::normalize(eye.frame->base_corner() + u * eye.frame->base_u() +
                          v * eye.frame->base_v());
  };
  const glm::dvec3 middle = towards(square.centre_u(), square.centre_v());
  const glm::dvec3 corner = towards(square.u, square.v);
  const double half_angle = 1.5 * std::acos(std::min(1.0, glm::dot(middle, corner)));
  const auto lights = eye.viewer.shader.lights();
  return std::any_of(lights.begin(), lights.end(), [&](const PreparedLight& light) {
    return light.own_part >= 0 && largest(light.power) > 1.0f &&
           may_show(light, eye.frame->apex(), middle, half_angle);
  });
}

bool some_cast_shadows(const EyeContext& eye) {
  const auto lights = eye.viewer.shader.lights();
  return eye.settings->shadow.cast &&
         std::any_of(lights.begin(), lights.end(), [](const auto& l) { return l.casts_shadows; });
}

ShadowContext shadows_of(const EyeContext& eye, const ShadowScene& scene, PatchView& view,
                         ShadowGroups& groups) {
  ShadowContext shadows;
  shadows.scene = &scene;
  shadows.rules = {
      eye.variant.area_shadows, eye.error_budget, eye.variant.shadow_pyrays,
      eye.scene->render_features.varying_opacity && eye.scene->features().opacity_unbounded()};
  shadows.lights = eye.viewer.shader.lights().size();
  shadows.frame = eye.frame;
  shadows.view = &view;
  shadows.groups = &groups;
  shadows.work = &eye.work->shadows;
  return shadows;
}

std::optional<LeafLayers> layers_of(const EyeContext& eye, const EyeSamples& samples,
                                    std::size_t roots) {
  if (eye.mirrored() || !eye.settings->layers.of_surfaces()) return std::nullopt;
  return std::optional<LeafLayers>(std::in_place, eye, samples, roots);
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
      selected_lights_(eye_, samples_),
      chooser_(eye_, samples_, selected_lights_, shadows_),
      sums_(roots),
      layers_(layers_of(eye_, samples_, roots)),
      leaf_shader_(eye_, samples_, chooser_, selected_lights_, shadows_, sums_, blurred_,
                   layers_ ? &*layers_ : nullptr) {
  if (eye_.defocus) lens_.emplace(eye_, samples_, chooser_, leaf_shader_, roots);
}

void EyeCaster::middles_known(int side) {
  groups_.reset(eye_.viewer.shader.lights().size());
  if (casts_shadows_) {
    bool unlit = false, lit = false;
    for (SampleId i = 0; i < static_cast<SampleId>(side * side); ++i) {
      if (!samples_.hit(i).valid()) continue;
      (eye_.scene->world().material_of(samples_.hit(i).triangle).unlit ? unlit : lit) = true;
      const SurfacePoint point = samples_.point(i);
      groups_.add(samples_.hit(i), point.position, point.geometric_normal, samples_.patch(i, 1.0),
                  point.lift);
    }
    shades_parts_ = lit || !unlit;
  }
  chooser_.learn_normals(side);
  selected_lights_.find(side);
}

SampleId EyeCaster::sample_saturated(std::uint32_t root, const Square& square, double weight) {
  if (!eye_.error_budget.refines()) return no_sample;
  const SampleId sample = samples_.add_unseen({square.centre_u(), square.centre_v()});
  const std::uint64_t before = eye_.counts->rays();
  // A glaring surface, behind dark ones, has the largest contrast: that of white.
  std::uint32_t fewest = 1;
  if (may_glare(eye_, square))
    fewest = std::bit_ceil(static_cast<std::uint32_t>(eye_.error_budget.samples(weight, 1.0)));
  const PyrayLeaf leaf{root, sample, weight, {square, {}}, {Estimator::samples}};
  const bool sampled = leaf_shader_.add_samples(leaf, fewest);
  sums_[root].rays += eye_.counts->rays() - before;
  return sampled ? sample : no_sample;
}

glm::vec3 EyeCaster::colour(std::uint32_t root) const {
  if (eye_.mask && eye_.mask->blur) return blurred_.mean(*eye_.mask->blur);
  return sums_[root].mean();
}

}  // namespace asos
