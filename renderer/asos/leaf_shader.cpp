#include "renderer/asos/leaf_shader.h"

#include "renderer/asos/defocus.h"
#include "renderer/asos/footprint_shape.h"
#include "renderer/asos/leaf_transport.h"
#include "renderer/asos/texture_samples.h"
#include "renderer/geometry/finite.h"
#include "renderer/pyray/tuning.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/gloss.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace asos {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

LeafShader::LeafShader(const EyeContext& eye, EyeSamples& samples, LeafChooser& chooser,
                       const SelectedLights& selected_lights, const ShadowContext& shadows,
                       std::span<RootSum> sums, BlurredSum& blurred, LeafLayers* layers)
    : eye_(&eye),
      samples_(&samples),
      chooser_(&chooser),
      selected_lights_(&selected_lights),
      direct_(eye, SummedRadiance::direct, selected_lights),
      lobes_(eye, SummedRadiance::lobes, selected_lights),
      single_(eye, samples),
      shadows_(&shadows),
      sums_(sums),
      blurred_(&blurred),
      layers_(layers),
      adds_light_(layers && eye.settings->layers.of_light()) {}

void LeafShader::shade(std::span<const PyrayLeaf> leaves) {
  for (const PyrayLeaf& leaf : leaves) {
    if (eye_->stop.stop_requested()) return;
    const std::uint64_t before = eye_->counts->rays();
    shade_one(leaf);
    sums_[leaf.root].rays += eye_->counts->rays() - before;
  }
}

void LeafShader::shade_one(const PyrayLeaf& part) {
  if (eye_->mask && !eye_->mask->holds(samples_->at(part.sample))) return;
  RootSum& sum = sums_[part.root];
  sum.note_error(part.decision.error, part.weight);
  adds_planes_ = adds_planes(part);
  const bool one_sample = worth_one_sample(part);
  if (layers_ && (one_sample || !adds_planes_)) layers_->add(part);
  if (one_sample) {
    const double off = ErrorBudget::usual_contrast * part.weight;
    sum.squared_error += off * off;
    return single_.add(part);
  }
  const bool mirrored = eye_->mirrored();
  if (!mirrored && part.decision.sampled() && add_samples(part)) return;
  Leaf& leaf = chooser_->leaf(part);
  if (mirrored && chooser_->may_misplace_light(leaf)) sum.centre_error = unbounded;
  if (mirrored && leaf.decision.sampled() && add_samples(leaf)) return;

  // Divide textured surfaces into TR x TR samples per pixel. Everything else is one leaf.
  if (add_texture_samples(leaf)) return;
  leaf.even = chooser_->even_around(leaf);
  note_result(leaf.root, leaf.sample, add_leaf(leaf));
}

// Reflected leaves are never deferred as single samples.
bool LeafShader::worth_one_sample(const PyrayLeaf& leaf) const {
  const ErrorBudget& error_budget = eye_->error_budget;
  return !eye_->mirrored() && error_budget.refines() &&
         (leaf.region.marginal || error_budget.most_samples(leaf.weight) < 2.0);
}

// Shades a leaf by its one sample and adds it to its root.
glm::vec3 LeafShader::add_leaf(const Leaf& leaf) {
  const ViewContext& viewer = eye_->viewer;
  RootSum& sum = sums_[leaf.root];
  LeafTransport transport(*eye_, *shadows_, leaf, *selected_lights_);
  ViewedRay seen = eye_->viewed(leaf);
  seen.parts = colour_parts(leaf);
  sum.centre_error += leaf.weight * static_cast<double>(std::min(leaf.decision.error, 1.0f));
  glm::vec3 radiance = viewer.shader.radiance(seen, transport, *eye_->counts);
  const Estimate centre = transport.centre(radiance);
  if (eye_->mirrored() && centre.error == unbounded) sum.centre_error = unbounded;
  sum.shadow_cut |= transport.shadow_cut();
  sum.mirror_cut |= transport.mirror_cut();
  if (!finite(radiance)) {
    if (adds_planes_) layers_->add(leaf);
    ++eye_->counts->rejected_samples;
    return radiance;
  }
  const bool by_lobe = transport.lobes() != glm::vec3(0.0f);
  if (by_lobe && eye_->mirrored()) radiance += lobes_.at_once(leaf, transport.lobes());
  if (transport.lit_by_selected() && eye_->mirrored()) radiance += direct_.at_once(leaf);
  if (eye_->mask && eye_->mask->blur) {
    const auto light = viewer.sees_bare_lights()
                           ? viewer.shader.nearest_light_without_geometry(leaf.ray)
                           : std::nullopt;
    blurred_->add(leaf.region, 1.0, glm::dvec3(radiance),
                  light ? std::min(light->t, leaf.hit.t) : leaf.hit.t);
    return radiance;
  }
  if (!suffices(leaf, centre) &&
      add_samples(leaf, enough_for(leaf, transport.unsure_highlights()))) {
    return radiance;
  }
  if (adds_planes_) layers_->add(leaf);
  sum.add(glm::dvec3(radiance), leaf.weight);
  if (adds_light_) layers_->add_light(leaf.root, transport.light(radiance), leaf.weight);
  if (by_lobe && !eye_->mirrored())
    lobes_.add(leaf, transport.lobes(), !transport.lobes_show_scene());
  if (transport.lit_by_selected() && !eye_->mirrored()) direct_.add(leaf);
  return radiance;
}

// The footprint of a cut leaf is approximated by a parallelogram. Where that reaches beyond the
// boundary, the texture may differ, as at seams. The colour is therefore averaged over parts of the
// leaf.
std::span<const WeightedShape> LeafShader::colour_parts(const Leaf& leaf) {
  parts_.clear();
  const LeafRegion& region = leaf.region;
  if (region.border.empty() || !leaf.shows_surface() ||
      eye_->settings->texture.filter == TextureFilter::point)
    return {};
  if (!eye_->scene->render_features.textures ||
      !(leaf.material->base_color_texture.used() || leaf.material->emissive_texture.used()))
    return {};
  add_footprint_shapes(region, leaf.at, LeafTuning::colour_parts, parts_);
  return parts_;
}

// Returns whether the error of a leaf's centre is within the allowance, or samples would not reduce
// it.
bool LeafShader::suffices(const Leaf& leaf, const Estimate& centre) const {
  const bool refines = eye_->error_budget.refines_leaves();
  if (eye_->mirrored() || leaf.region.marginal || leaf.decision.sampled() ||
      !(refines || leaf.defocused))
    return true;
  return centre.within(refines ? static_cast<double>(eye_->error_budget.tolerance) : unbounded);
}

// Returns the fewest samples of a leaf whose centre does not suffice. For an unsure highlight, it
// is half of the number that is expected to be needed. With fewer, all may miss the visible part of
// the light, so that their variance is wrongly zero.
std::uint32_t LeafShader::enough_for(const Leaf& leaf, float highlights) const {
  const ErrorBudget& error_budget = eye_->error_budget;
  if (!(highlights > error_budget.tolerance))
    return std::bit_ceil(
        std::max(1u, static_cast<std::uint32_t>(EnoughSamples::of_rare_light * leaf.weight)));
  const double likely = error_budget.samples(
      leaf.weight, ErrorBudget::usual_contrast + static_cast<double>(highlights));
  return std::bit_floor(
      static_cast<std::uint32_t>(std::clamp(0.5 * likely, 1.0, EnoughSamples::of_rare_light)));
}

// Divides a leaf of a textured surface without boundaries into TR x TR samples per pixel, each with
// its own fraction of the area (CGF'98 section 3.2). Returns false if the leaf is not to be
// divided.
bool LeafShader::add_texture_samples(const Leaf& leaf) {
  // Decide whether to divide the leaf.
  const TextureSettings& settings = eye_->settings->texture;
  const LeafRegion& region = leaf.region;
  const double side = static_cast<double>(region.square.side) * eye_->block.width;
  const int n =
      texture_divisions(settings.resolution, side / static_cast<double>(eye_->viewer.pixel));
  // Exclude leaves that a boundary has cut: the parts of their square would have wrong areas.
  if (n == 1 || region.marginal || !region.border.empty() || !leaf.shows_surface() ||
      !is_textured(*leaf.material, eye_->scene->render_features))
    return false;
  // Sample the leaf's parts.
  const LeafPlace place{{eye_->block.x, eye_->block.y}, eye_->block.width};
  const std::vector<TexturePart> parts =
      texture_parts(region.square, n, place, eye_->seed, settings.filter == TextureFilter::point);
  std::vector<glm::vec2> places;
  for (const TexturePart& part : parts) places.push_back(part.at);
  const SampleId first = samples_->probe(places);

  // Evaluate the lights once for all of the parts.
  UniformShadowPatch whole = chooser_->even_patch(leaf);
  const bool even = samples_->opaque(leaf.sample);
  const RootSum before = sums_[leaf.root];
  const double share = leaf.weight / static_cast<double>(parts.size());
  for (std::uint32_t i = 0; i < parts.size() && !eye_->stop.stop_requested(); ++i) {
    Leaf& part = chooser_->leaf({leaf.root, first + i, share, {parts[i].square, {}}});
    part.even = even ? &whole : chooser_->even_around(part);
    (void)add_leaf(part);
  }
  // Record the mean of the parts as the leaf's radiance.
  const double added = sums_[leaf.root].weight - before.weight;
  const glm::dvec3 radiance = sums_[leaf.root].radiance - before.radiance;
  note_result(leaf.root, leaf.sample, added > 0.0 ? glm::vec3(radiance / added) : glm::vec3(0.0f));
  return true;
}

RegionSampler& LeafShader::sampler() {
  if (!sampler_) {
    sampler_ = std::make_unique<RegionSampler>(*eye_->scene, eye_->viewer, *eye_->settings,
                                               eye_->block, eye_->seed, eye_->mask, eye_->stop);
    if (layers_) sampler_->note_layers();
  }
  return *sampler_;
}

void LeafShader::sample_defocused(std::uint32_t root, SampleId sample, std::uint32_t fewest) {
  const glm::vec2 at = samples_->at(sample);
  const float side = eye_->root_side();
  PyrayLeaf leaf{root, sample, 1.0, {{at.x - 0.5f * side, at.y - 0.5f * side, side}, {}}};
  leaf.decision = {Estimator::samples};
  leaf.defocused = true;
  RegionSampler::Goal goal =
      sample_goal(eye_->defocus->error_budget(), 1.0, std::max(fewest, EnoughSamples::of_blur));
  const double parts_of_lens =
      std::min(LeafTuning::most_parts_of_lens, eye_->defocus->error_budget().finest_cells(1.0));
  if (goal.most > 1) goal.most *= static_cast<std::uint32_t>(parts_of_lens);
  sums_[root].defocused = true;
  defer(leaf, goal);
}

// Defers a leaf until `finish`.
void LeafShader::defer(const PyrayLeaf& leaf, const RegionSampler::Goal& goal) {
  const double samples =
      adds_planes(leaf) ? std::max(1.0, EnoughSamples::of_rare_light * std::min(1.0, leaf.weight))
                        : 0.0;
  sampler().add(leaf.region, goal, static_cast<std::uint32_t>(samples));
  PyrayLeaf& deferred = deferred_.emplace_back(leaf);
  deferred.region.border = {};
  deferred.decision.estimator = Estimator::samples;  // never deferred again
}

bool LeafShader::add_samples(const PyrayLeaf& leaf, std::uint32_t fewest) {
  if (leaf.defocused) {
    sample_defocused(leaf.root, leaf.sample);
    return true;
  }
  const RegionSampler::Goal goal = sample_goal(eye_->error_budget, leaf.weight, fewest);
  if (!eye_->mirrored()) {
    defer(leaf, goal);
    return true;
  }
  // Include the blur, since the samples follow its kernel. Sample 0 is that of the root's centre.
  std::optional<BlurKernel> kernel;
  if (eye_->mask->blur) kernel = eye_->mask->blur->at(static_cast<double>(samples_->hit(0).t));
  return add_estimate(
      leaf, sampler().sample(leaf.region, goal, *eye_->counts, kernel ? &*kernel : nullptr));
}

// Adds the mean of a part to its root, with the weight of the part in the mask.
bool LeafShader::add_estimate(const PyrayLeaf& leaf, const RegionSampler::Mean& found) {
  if (found.cost == 0.0) return false;
  const bool blurred = eye_->mask && eye_->mask->blur;
  if (blurred)
    blurred_->add(leaf.region, 1.0 - found.masked_share, found.value, samples_->hit(0).t);
  sums_[leaf.root].add_samples(found, leaf, blurred ? 0.0 : leaf.weight);
  note_result(leaf.root, leaf.sample, glm::vec3(found.value));
  return true;
}

// Adds contributions that were determined for many leaves together: a leaf's whole radiance, or a
// part of it.
// `light_of` returns the parts of the radiance of one of them.
void LeafShader::add(std::span<const Contribution> contributions, bool whole_leaves,
                     const auto& light_of) {
  for (std::size_t i = 0; i < contributions.size(); ++i) {
    const Contribution& found = contributions[i];
    const PyrayLeaf& leaf = *found.leaf;
    RootSum& sum = sums_[leaf.root];
    sum.rays += static_cast<std::uint64_t>(std::llround(found.rays));
    if (found.dropped) continue;
    sum.radiance += found.radiance;
    if (whole_leaves) sum.weight += leaf.weight;
    if (adds_light_ && whole_leaves) layers_->add_light(leaf.root, light_of(i), leaf.weight);
    if (adds_light_ && !whole_leaves) layers_->add_radiance(leaf.root, light_of(i), leaf.weight);
    glm::vec3 radiance(found.radiance / leaf.weight);
    if (!whole_leaves) radiance += result(leaf.sample);
    note_result(leaf.root, leaf.sample, radiance);
  }
}

void LeafShader::finish() {
  add(single_.run(), true, [&](std::size_t i) -> const LightSum& { return single_.light(i); });
  start_regions();
  if (eye_->stop.stop_requested()) return;
  add(direct_.run(), false, [&](std::size_t i) { return direct_.light(i); });
  add(lobes_.run(), false, [&](std::size_t i) { return lobes_.light(i); });
}

// Runs the first stage of the deferred regions, and adds the regions that meet their goals.
void LeafShader::start_regions() {
  if (deferred_.empty() || eye_->stop.stop_requested()) return;
  const std::uint64_t before = eye_->counts->rays();
  const auto found = sampler_->start(*eye_->counts, LeafTuning::first_stage_error);
  const auto rays = static_cast<double>(eye_->counts->rays() - before);
  const std::vector<PyrayLeaf> leaves = std::exchange(deferred_, {});
  double samples = 0.0;
  for (const RegionSampler::Mean& one : found) samples += one.cost;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    PyrayLeaf leaf = leaves[i];
    if (samples > 0.0)
      sums_[leaf.root].rays +=
          static_cast<std::uint64_t>(std::llround(rays * found[i].cost / samples));
    if (sampler_->open(i)) {
      open_.parts.push_back({leaf, found[i]});
      continue;
    }
    if (layers_) layers_->add(leaf.root, sampler_->layers(i), leaf.weight);
    adds_planes_ = adds_planes(leaf) && !(sampler_->layers(i).weight > 0.0);
    if (add_estimate(leaf, found[i]) || !samples_->hit(leaf.sample).valid()) continue;
    // If a region is so thin that no sample hits it, shade the leaf's own sample.
    leaf.region = sampler_->region(i);
    Leaf& own = chooser_->leaf(leaf);
    own.even = nullptr;
    note_result(leaf.root, leaf.sample, add_leaf(own));
  }
  open_.samples = sampler_->take_open();
}

void LeafShader::note_result(std::uint32_t root, SampleId sample, glm::vec3 radiance) {
  if (eye_->observed.observer && root == eye_->observed_root) results_[sample] = radiance;
}

glm::vec3 LeafShader::result(SampleId sample) const {
  const auto found = results_.find(sample);
  return found != results_.end() ? found->second : glm::vec3(0.0f);
}

}  // namespace asos
