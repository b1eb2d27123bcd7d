#include "renderer/asos/lens_roots.h"

#include "renderer/asos/texture_samples.h"
#include "renderer/geometry/largest.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/shading/gloss.h"

#include <algorithm>
#include <limits>

namespace asos {
namespace {

// Number of samples of a root over which a light much brighter than white may be blurred. With
// fewer, all samples may miss it, or its weight is overestimated.
constexpr std::uint32_t samples_of_blurred_glare = 256;
constexpr float glare = 4.0f;

}  // namespace

LensRoots::LensRoots(const EyeContext& eye, EyeSamples& samples, LeafChooser& chooser,
                     LeafShader& shader, std::size_t roots)
    : eye_(&eye),
      samples_(&samples),
      chooser_(&chooser),
      shader_(&shader),
      blurred_(roots, false) {}

LensEstimator LensRoots::way(std::uint32_t root, bool bounded, bool missed) {
  if (eye_->settings->method == Method::asos_published) return LensEstimator::widened;
  if (missed) return LensEstimator::sampled;
  const Defocus& defocus = *eye_->defocus;
  const Defocus::Pixel& pixel = defocus.pixel(root);
  if (!pixel.searched || shows_other_depths(root) || !defocus.nothing_nearer(root))
    return LensEstimator::sampled;
  if (defocus.is_sharp(pixel.most)) return LensEstimator::sharp;
  if (bounded) return LensEstimator::sampled;
  // The lens kernel is no square, so a texture's mean over a square would be wrong.
  const Hit& hit = samples_->hit(root);
  const RenderScene& scene = *eye_->scene;
  const bool textured =
      hit.valid() && is_textured(scene.world().material_of(hit.triangle), scene.render_features);
  // A surface whose facets meet only at boundaries does not leave its plane.
  const bool bends = hit.valid() && scene.features().deviation(hit.triangle) > 0.0f;
  if (textured || (bends && !defocus.stays_within_reach(root, *eye_->counts)))
    return LensEstimator::sampled;
  return LensEstimator::smooth;
}

Square LensRoots::widened_square(std::uint32_t root) const {
  const auto side = static_cast<float>(eye_->defocus->leaf_side(root) / eye_->block.width);
  const glm::vec2 corner = samples_->at(root) - 0.5f * side;
  return {corner.x, corner.y, side};
}

bool LensRoots::shade_smooth(std::uint32_t root) {
  const SampleId sample = root;
  const double across = eye_->defocus->leaf_side(root) / static_cast<double>(eye_->viewer.pixel);
  PyrayLeaf leaf{root, sample, across * across, {widened_square(root), {}}};
  leaf.decision = chooser_->decide(sample, leaf.weight, leaf.region, false);
  if (leaf.decision.estimator != Estimator::centre ||
      leaf.decision.error > eye_->error_budget.tolerance)
    return false;
  leaf.defocused = true;
  shader_->shade(std::span(&leaf, 1));
  return true;
}

// Returns whether the surface reflects or transmits surfaces at other depths than its own.
bool LensRoots::shows_other_depths(SampleId sample) const {
  const Hit& hit = samples_->hit(sample);
  if (!hit.valid()) return false;
  if (!samples_->opaque(sample) || samples_->cut_out(sample)) return true;
  const Material& material = eye_->scene->world().material_of(hit.triangle);
  if (material.unlit) return false;
  if (material.transmission > 0.0f) return true;
  if (eye_->viewer.shader.reflections() == 0) return false;
  return eye_->settings->mirror.dfr || eye_->scene->dfr_of(hit.triangle) ||
         static_cast<double>(least_mirror_roughness(material)) <= eye_->settings->mirror.roughest;
}

void LensRoots::sample_root(std::uint32_t root) {
  shader_->sample_defocused(root, root, may_show_glare(root) ? samples_of_blurred_glare : 1);
}

// Returns whether a glaring light lies in the pixel's cone, widened by the blur at the light's
// depth.
bool LensRoots::may_show_glare(std::uint32_t root) const {
  const View& view = eye_->viewer.view;
  const PixelSpacing& spacing = eye_->viewer.spacing;
  const glm::dvec3 eye = eye_->frame->apex(), axis(samples_->ray(root).direction);
  const double pixel = static_cast<double>(eye_->viewer.pixel * glm::length(spacing.right));
  const auto lights = eye_->viewer.shader.lights();
  return std::any_of(lights.begin(), lights.end(), [&](const PreparedLight& light) {
    if (light.own_part < 0 || !(largest(light.power) > glare)) return false;
    const double depth = glm::dot(light.position - eye, glm::dvec3(spacing.forward));
    if (!(depth > 0.0)) return true;
    const double reach = 0.5 * static_cast<double>(eye_->viewer.pixel) + view.confusion(depth);
    return may_show(light, eye, axis, 1.5 * reach * pixel);
  });
}

bool LensRoots::sharp_leaf(SampleId sample) const {
  const Hit& hit = samples_->hit(sample);
  const double depth = hit.valid() ? eye_->viewer.view.depth(samples_->ray(sample), hit.t)
                                   : std::numeric_limits<double>::infinity();
  return eye_->defocus->is_sharp_at(depth) && !shows_other_depths(sample);
}

void LensRoots::Trial::take(std::span<const PyrayLeaf> leaves) {
  for (const PyrayLeaf& leaf : leaves)
    if (!roots_->sharp_leaf(leaf.sample)) roots_->blurred_[leaf.root] = true;
}

}  // namespace asos
