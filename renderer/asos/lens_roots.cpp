#include "renderer/asos/lens_roots.h"

#include "renderer/asos/texture_samples.h"
#include "renderer/geometry/largest.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/pyray/tuning.h"
#include "renderer/shading/gloss.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

// Returns the solid angle of a light that a surface shows; for small lights.
double solid_angle(const PreparedLight& light, glm::dvec3 to_light) {
  const double distance2 = glm::dot(to_light, to_light);
  if (!light.traits().flat) {
    const double round = std::numbers::pi * light.radius * light.radius;
    return std::max(light.area, round) / distance2;
  }
  const double cosine = std::abs(glm::dot(light.towards, to_light)) / std::sqrt(distance2);
  return light.area * cosine / distance2;
}

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
  leaf.defocused = true;
  leaf.decision = chooser_->decide(leaf, false);
  if (leaf.decision.estimator != Estimator::centre ||
      leaf.decision.error > eye_->error_budget.tolerance)
    return false;
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
  shader_->sample_defocused(root, root, samples_for_lights(root));
}

// Returns the number of samples for enough of them to meet each visible light that lies in the
// pixel's cone, widened by the blur at the light's depth, and that changes the pixel by more than
// its tolerance. It follows from the fraction of the cone that the light fills.
std::uint32_t LensRoots::samples_for_lights(std::uint32_t root) const {
  const View& view = eye_->viewer.view;
  const PixelSpacing& spacing = eye_->viewer.spacing;
  const glm::dvec3 eye = eye_->frame->apex(), axis(samples_->ray(root).direction);
  const double pixel = static_cast<double>(eye_->viewer.pixel * glm::length(spacing.right));
  constexpr double most = 1u << 20;
  double samples = 1.0;
  for (const PreparedLight& light : eye_->viewer.shader.lights()) {
    if (light.own_part < 0) continue;
    const glm::dvec3 to_light = light.position - eye;
    const double depth = glm::dot(to_light, glm::dvec3(spacing.forward));
    if (!(depth > 0.0)) continue;
    const double reach =
        (0.5 * static_cast<double>(eye_->viewer.pixel) + view.confusion(depth)) * pixel;
    if (!may_show(light, eye, axis, 1.5 * reach)) continue;
    const double cone = std::numbers::pi * reach * reach;
    const double share = std::min(1.0, solid_angle(light, to_light) / cone);
    if (share * static_cast<double>(largest(light.power)) >
        static_cast<double>(eye_->error_budget.tolerance))
      samples = std::max(samples, EnoughSamples::on_light / share);
  }
  return std::bit_ceil(static_cast<std::uint32_t>(std::min(samples, most)));
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
