#include "renderer/asos/leaf_shader.h"

#include "renderer/asos/leaf_transport.h"
#include "renderer/asos/part_shape.h"
#include "renderer/asos/texture_samples.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// So few samples are right where there are many such parts, or the part is only one of what a
// mirror shows.
constexpr std::uint32_t few_samples = 4;

bool finite(glm::vec3 v) {
  return std::isfinite(v.x + v.y + v.z);
}

}  // namespace

LeafShader::LeafShader(const EyeContext& eye, EyeSamples& samples, Refinement& refinement,
                       const ShadowContext& shadows, std::span<RootSum> sums, BlurredSum& blurred)
    : eye_(&eye),
      samples_(&samples),
      refinement_(&refinement),
      shadows_(&shadows),
      sums_(sums),
      blurred_(&blurred) {}

void LeafShader::shade(std::span<const PyrayLeaf> leaves) {
  for (const PyrayLeaf& leaf : leaves) {
    if (eye_->stop.stop_requested()) return;
    const std::uint64_t before = eye_->counts->rays();
    shade_one(leaf);
    sums_[leaf.root].rays += eye_->counts->rays() - before;
  }
}

void LeafShader::shade_one(const PyrayLeaf& leaf) {
  if (eye_->mask && !eye_->mask->holds(samples_->at(leaf.sample))) return;

  // Leaves that splitting would not make even are sampled.
  std::uint32_t fewest = 0;
  if (refinement_->glints(leaf.sample, leaf.weight)) {
    fewest = few_samples;
  } else if (refinement_->uneven_at_last(leaf.sample, leaf.weight, leaf.region)) {
    fewest = enough_samples;
  }
  if (fewest > 0 && add_samples(leaf.root, leaf.sample, leaf.region, leaf.weight, fewest) > 0)
    return;

  // Textured surfaces are divided into TR x TR samples of a pixel; all else is one leaf.
  if (add_texture_samples(leaf)) return;
  const glm::vec3 radiance = add_leaf(leaf, refinement_->even_around(leaf.sample, leaf.region));
  note_result(leaf, radiance);
}

// Shades a leaf by its one sample and adds it to its root.
glm::vec3 LeafShader::add_leaf(const PyrayLeaf& leaf, EvenPatch* even) {
  const Viewer& viewer = eye_->viewer;
  const Hit& hit = samples_->hit(leaf.sample);
  const Ray& ray = samples_->ray(leaf.sample);
  RootSum& sum = sums_[leaf.root];
  const LeafContext context = context_of(leaf, even);
  LeafTransport transport(*eye_, *shadows_, context);
  const glm::vec3 radiance = viewer.shader.radiance(
      viewer.viewed(ray, hit, eye_->side_of(leaf.weight), part_shape(leaf.region, context.at)),
      transport, *eye_->counts);
  sum.shadow_cut |= transport.met_shadow_edge();
  sum.mirror_cut |= transport.met_mirror_edge();
  if (!finite(radiance)) {
    ++eye_->counts->rejected_samples;
    return radiance;
  }
  if (eye_->mask && eye_->mask->blur) {
    const auto light = viewer.shader.nearest_light_without_geometry(ray);
    blurred_->add(leaf.region, 1.0, glm::dvec3(radiance),
                  light ? std::min(light->t, hit.t) : hit.t);
    return radiance;
  }
  sum.add(glm::dvec3(radiance), leaf.weight);
  return radiance;
}

LeafContext LeafShader::context_of(const PyrayLeaf& leaf, EvenPatch* even) const {
  LeafContext context;
  context.region = leaf.region;
  context.root_side = eye_->root_side();
  context.weight = leaf.weight;
  context.at = samples_->at(leaf.sample);
  context.seed = samples_->seed(leaf.sample);
  context.even = even;
  context.saturated = refinement_->saturated(leaf.note);
  if (eye_->observed.observer && leaf.root == eye_->observed_root) {
    const Square& root = eye_->observed_square;
    context.observed = eye_->observed;
    context.observed.at = (context.at - glm::vec2(root.u, root.v)) / root.side;
    context.observed.weight = leaf.weight;
  }
  return context;
}

// Divides a leaf of a textured surface that no boundary passes through into TR x TR samples of a
// pixel, each with its own share of the area (CGF'98 section 3.2). False: it is not to be divided.
bool LeafShader::add_texture_samples(const PyrayLeaf& leaf) {
  // Decide whether to divide the leaf.
  const TextureSettings& settings = eye_->settings->texture;
  const LeafRegion& region = leaf.region;
  const double side = static_cast<double>(region.square.side) * eye_->block.width;
  const int n =
      texture_divisions(settings.resolution, side / static_cast<double>(eye_->viewer.pixel));
  const Hit& hit = samples_->hit(leaf.sample);
  // Under a mask only whole squares are divided: it is asked about leaves, not their parts.
  const bool masked_part = eye_->mask && !region.border.empty();
  if (n == 1 || region.marginal || masked_part || !hit.valid() ||
      !is_textured(eye_->scene->world().material_of(hit.triangle), eye_->scene->needs))
    return false;
  // Sample its parts.
  const LeafPlace place{{eye_->block.x, eye_->block.y}, eye_->block.width};
  const std::vector<TexturePart> parts =
      texture_parts(region, n, place, eye_->seed, settings.filter == TextureFilter::point);
  if (parts.empty()) return false;
  std::vector<glm::vec2> places;
  for (const TexturePart& part : parts) places.push_back(part.at);
  const SampleId first = samples_->probe(places);

  // One look at the lights does for all of them.
  EvenPatch whole = refinement_->even_patch(leaf.sample, region, leaf.note);
  const bool even = region.border.empty() && samples_->opaque(leaf.sample);
  const RootSum before = sums_[leaf.root];
  const double share = leaf.weight / static_cast<double>(parts.size());
  for (std::uint32_t i = 0; i < parts.size() && !eye_->stop.stop_requested(); ++i) {
    const PyrayLeaf part{leaf.root, first + i, share, {parts[i].square, {}, parts[i].marginal}};
    (void)add_leaf(part, even ? &whole : refinement_->even_around(part.sample, part.region));
  }
  // Note their mean as the leaf's.
  const double added = sums_[leaf.root].weight - before.weight;
  const glm::dvec3 radiance = sums_[leaf.root].radiance - before.radiance;
  note_result(leaf, added > 0.0 ? glm::vec3(radiance / added) : glm::vec3(0.0f));
  return true;
}

// The standard error that the part's weight deserves; one sample for each finest cell at least, and
// four at most, or sixteen where what is mirrored may be far brighter than white.
std::uint32_t LeafShader::add_samples(std::uint32_t root, SampleId sample, const LeafRegion& region,
                                      double weight, std::uint32_t fewest) {
  if (!sampler_) {
    sampler_.emplace(*eye_->scene, eye_->viewer, *eye_->settings, eye_->block, eye_->seed,
                     eye_->mask);
  }
  // Set the goal.
  const bool reflected = eye_->viewer.bounces > 0;
  if (reflected) fewest = few_samples;
  RegionSampler::Goal goal;
  goal.standard_error = eye_->budget.standard_error(weight);
  goal.least = eye_->budget.samples(weight, 1.0, fewest);
  goal.most = eye_->budget.samples(weight, reflected ? 16.0 : 4.0, fewest);
  // Sample the region; with blur, as its kernel is distributed there.
  const bool blurred = eye_->mask && eye_->mask->blur;
  std::optional<BlurKernel> kernel;
  // The first sample is that of the root's middle.
  if (blurred) kernel = eye_->mask->blur->at(static_cast<double>(samples_->hit(0).t));
  const RegionSampler::Estimate found =
      sampler_->sample(region, goal, *eye_->counts, kernel ? &*kernel : nullptr);
  if (found.samples == 0) return 0;
  // Add the mean to the root.
  const double held = 1.0 - found.masked_share;
  if (blurred) {
    blurred_->add(region, held, found.mean, samples_->hit(0).t);
  } else {
    sums_[root].radiance += held * weight * found.mean;
    sums_[root].weight += held * weight;
  }
  note_result({root, sample, weight, region}, glm::vec3(found.mean));
  return found.samples;
}

void LeafShader::note_result(const PyrayLeaf& leaf, glm::vec3 radiance) {
  if (eye_->observed.observer && leaf.root == eye_->observed_root)
    results_.emplace(leaf.sample, radiance);
}

glm::vec3 LeafShader::result(SampleId sample) const {
  const auto found = results_.find(sample);
  return found != results_.end() ? found->second : glm::vec3(0.0f);
}

}  // namespace asos
