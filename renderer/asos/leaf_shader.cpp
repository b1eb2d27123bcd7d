#include "renderer/asos/leaf_shader.h"

#include "renderer/asos/leaf_transport.h"
#include "renderer/asos/part_shape.h"
#include "renderer/asos/texture_samples.h"
#include "renderer/geometry/finite.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/gloss.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace asos {
namespace {

// Cut leaves have their colours averaged over so many parts along each side, but for small ones.
constexpr int parts_along = 3;
constexpr double least_in_parts = 1.0 / 64.0;

// Samples of a root whose mirrors may show a bright light elsewhere than pyrays do: of few none may
// meet it, and agree.
constexpr double samples_of_light = 256.0;

}  // namespace

LeafShader::LeafShader(const EyeContext& eye, EyeSamples& samples, Refinement& refinement,
                       WeakLights& weak_lights, const ShadowContext& shadows,
                       std::span<RootSum> sums, BlurredSum& blurred)
    : eye_(&eye),
      samples_(&samples),
      refinement_(&refinement),
      weak_lights_(&weak_lights),
      sky_(eye),
      lobes_(eye),
      shadows_(&shadows),
      sums_(sums),
      blurred_(&blurred),
      variation_(eye.settings->judged_tone) {}

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
  if (eye_->mask)
    sums_[leaf.root].misplaced |= refinement_->may_misplace_light(leaf.sample, leaf.region);

  // Leaves that splitting would not make even are sampled.
  const std::uint32_t enough = enough_samples_for(eye_->budget, leaf.weight);
  std::uint32_t fewest = 0;
  Sampled what = Sampled::noisy;
  const BySamples by_samples = leaf.verdict.given
                                   ? leaf.verdict.by_samples
                                   : refinement_->by_samples(leaf.sample, leaf.weight, leaf.region);
  if (refinement_->glints(leaf.sample, leaf.weight)) {
    fewest = few_samples;
  } else if (by_samples == BySamples::cheaper) {
    // So few that agree by chance are not to be believed.
    const double likely = eye_->budget.samples_of_uneven(leaf.weight, 0.0);
    fewest = std::max(enough, std::bit_floor(static_cast<std::uint32_t>(0.25 * likely)));
    if (!may_be_glossy(material_of(leaf))) what = Sampled::smooth;
  } else if (by_samples == BySamples::only) {
    fewest = enough;
  } else if (refinement_->uneven_at_last(leaf.sample, leaf.weight, leaf.region)) {
    fewest = enough;
  }
  if (fewest > 0 &&
      add_samples(leaf.root, leaf.sample, leaf.region, leaf.weight, fewest, what, by_samples))
    return;

  // Textured surfaces are divided into TR x TR samples of a pixel; all else is one leaf.
  if (add_texture_samples(leaf)) return;
  const glm::vec3 radiance = add_leaf(leaf, refinement_->even_around(leaf.sample, leaf.region));
  note_result(leaf, radiance);
}

const Material& LeafShader::material_of(const PyrayLeaf& leaf) const {
  return eye_->scene->world().material_of(samples_->hit(leaf.sample).triangle);
}

// Shades a leaf by its one sample and adds it to its root.
glm::vec3 LeafShader::add_leaf(const PyrayLeaf& leaf, EvenPatch* even) {
  const Viewer& viewer = eye_->viewer;
  const Hit& hit = samples_->hit(leaf.sample);
  const Ray& ray = samples_->ray(leaf.sample);
  RootSum& sum = sums_[leaf.root];
  const LeafContext context = context_of(leaf, even);
  const std::uint32_t share =
      eye_->mask ? 0 : weak_lights_->start(leaf.root, leaf.sample, leaf.weight);
  const std::uint32_t sky_share = eye_->mask ? 0 : sky_.start(leaf.root, leaf.sample, leaf.weight);
  LeafTransport transport(*eye_, *shadows_, context, *weak_lights_, share, sky_, sky_share);
  ViewedRay seen =
      viewer.viewed(ray, hit, eye_->side_of(leaf.weight), part_shape(leaf.region, context.at));
  seen.parts = colour_parts(leaf, context.at);
  glm::vec3 radiance = viewer.shader.radiance(seen, transport, *eye_->counts);
  radiance += transport.at_once();
  sum.shadow_cut |= transport.met_shadow_edge();
  sum.mirror_cut |= transport.met_mirror_edge();
  sum.misplaced |= transport.misplaces_light();
  if (!finite(radiance)) {
    ++eye_->counts->rejected_samples;
    drop(share, sky_share);
    return radiance;
  }
  const bool by_lobe = transport.lobes() != glm::vec3(0.0f);
  if (by_lobe && eye_->mask) radiance += lobes_.at_once(leaf, transport.lobes());
  if (eye_->mask && eye_->mask->blur) {
    const auto light = viewer.sees_bare_lights() ? viewer.shader.nearest_light_without_geometry(ray)
                                                 : std::nullopt;
    blurred_->add(leaf.region, 1.0, glm::dvec3(radiance),
                  light ? std::min(light->t, hit.t) : hit.t);
    return radiance;
  }
  std::uint32_t fewest = 0;
  if (light_misplaced(leaf, transport)) {
    const auto samples = static_cast<std::uint32_t>(samples_of_light * leaf.weight);
    fewest = std::max(enough_samples, std::bit_ceil(samples));
  }
  if (highlight_unsure(leaf, transport)) fewest = enough_for(leaf, transport.unsure_highlights());
  if (fewest > 0 && add_samples(leaf.root, leaf.sample, leaf.region, leaf.weight, fewest)) {
    drop(share, sky_share);
    return radiance;
  }
  sum.add(glm::dvec3(radiance), leaf.weight);
  std::optional<std::uint32_t> lobe_share;
  if (by_lobe && !eye_->mask) lobe_share = lobes_.add(leaf, transport.lobes());
  note_variation({leaf, samples_->surface(leaf.sample), context.at, radiance,
                  radiance + transport.inexact(), share, sky_share, lobe_share});
  return radiance;
}

// What a boundary has cut is no parallelogram: where that would reach beyond it a texture may show
// something else, as textures do along their seams. So colours are averaged over its parts.
std::span<const SharedShape> LeafShader::colour_parts(const PyrayLeaf& leaf, glm::vec2 at) {
  parts_.clear();
  const LeafRegion& region = leaf.region;
  const Hit& hit = samples_->hit(leaf.sample);
  if (region.border.empty() || !hit.valid() || leaf.weight < least_in_parts ||
      eye_->settings->texture.filter == TextureFilter::point)
    return {};
  const Material& material = material_of(leaf);
  if (!eye_->scene->needs.textures ||
      !(material.base_color_texture.used() || material.emissive_texture.used()))
    return {};
  add_part_shapes(region, at, parts_along, parts_);
  return parts_;
}

// Whether highlights of lights that are seen in part may be off by more than a leaf may. At most
// they are by what unsure_highlights says: all of the highlight may lie in what is hidden.
bool LeafShader::highlight_unsure(const PyrayLeaf& leaf, const LeafTransport& transport) const {
  const Budget& budget = eye_->budget;
  return !eye_->mask && budget.refines() && budget.max_level > 0 && !leaf.region.marginal &&
         !leaf.verdict.sampled() && transport.unsure_highlights() > budget.tolerance;
}

// How many samples tell such a highlight: of few samples none may see what is left of the light,
// and agree. Half of those that are likely to be needed.
std::uint32_t LeafShader::enough_for(const PyrayLeaf& leaf, float highlights) const {
  constexpr double most = 256.0;
  const double likely =
      eye_->budget.samples_of_uneven(leaf.weight, static_cast<double>(highlights));
  return std::max(enough_samples,
                  std::bit_floor(static_cast<std::uint32_t>(std::min(0.5 * likely, most))));
}

// Whether what the leaf mirrors has to be sampled, for a bright light would be shown elsewhere.
bool LeafShader::light_misplaced(const PyrayLeaf& leaf, const LeafTransport& transport) const {
  const Budget& budget = eye_->budget;
  return !eye_->mask && budget.refines() && budget.max_level > 0 && !leaf.region.marginal &&
         !leaf.verdict.sampled() && transport.misplaces_light();
}

LeafContext LeafShader::context_of(const PyrayLeaf& leaf, EvenPatch* even) const {
  LeafContext context;
  context.region = leaf.region;
  context.root_side = eye_->root_side();
  context.weight = leaf.weight;
  context.at = samples_->at(leaf.sample);
  context.seed = samples_->seed(leaf.sample);
  context.even = even;
  context.saturated = refinement_->saturated(leaf.verdict.note);
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
  // What a boundary has cut is marginal, too: parts of its square would not count by their areas.
  if (n == 1 || region.marginal || !region.border.empty() || !hit.valid() ||
      !is_textured(eye_->scene->world().material_of(hit.triangle), eye_->scene->needs))
    return false;
  // Sample its parts.
  const LeafPlace place{{eye_->block.x, eye_->block.y}, eye_->block.width};
  const std::vector<TexturePart> parts =
      texture_parts(region.square, n, place, eye_->seed, settings.filter == TextureFilter::point);
  std::vector<glm::vec2> places;
  for (const TexturePart& part : parts) places.push_back(part.at);
  const SampleId first = samples_->probe(places);

  // One look at the lights does for all of them.
  EvenPatch whole = refinement_->even_patch(leaf.sample, region, leaf.verdict.note);
  const bool even = samples_->opaque(leaf.sample);
  const RootSum before = sums_[leaf.root];
  const double share = leaf.weight / static_cast<double>(parts.size());
  for (std::uint32_t i = 0; i < parts.size() && !eye_->stop.stop_requested(); ++i) {
    const PyrayLeaf part{leaf.root, first + i, share, {parts[i].square, {}}};
    (void)add_leaf(part, even ? &whole : refinement_->even_around(part.sample, part.region));
  }
  // Note their mean as the leaf's.
  const double added = sums_[leaf.root].weight - before.weight;
  const glm::dvec3 radiance = sums_[leaf.root].radiance - before.radiance;
  note_result(leaf, added > 0.0 ? glm::vec3(radiance / added) : glm::vec3(0.0f));
  return true;
}

bool LeafShader::add_samples(std::uint32_t root, SampleId sample, const LeafRegion& region,
                             double weight, std::uint32_t fewest, Sampled what,
                             BySamples by_samples) {
  if (!sampler_) {
    sampler_.emplace(*eye_->scene, eye_->viewer, *eye_->settings, eye_->block, eye_->seed,
                     eye_->mask, eye_->stop);
  }
  const RegionSampler::Goal goal = sample_goal(*eye_, weight, fewest, what);
  const PyrayLeaf leaf{root, sample, weight, region, {Unevenness::none, 0, by_samples}};
  if (!eye_->mask) {
    sampler_->add(region, goal);
    put_off_.push_back(leaf);
    put_off_.back().region.border = {};
    return true;
  }
  // With blur, as its kernel is distributed there. The first sample is that of the root's middle.
  std::optional<BlurKernel> kernel;
  if (eye_->mask->blur) kernel = eye_->mask->blur->at(static_cast<double>(samples_->hit(0).t));
  return add_estimate(leaf,
                      sampler_->sample(region, goal, *eye_->counts, kernel ? &*kernel : nullptr));
}

// Adds the mean of a part to its root, for the share of it that the mask holds.
bool LeafShader::add_estimate(const PyrayLeaf& leaf, const RegionSampler::Estimate& found) {
  if (found.samples == 0) return false;
  const double held = 1.0 - found.masked_share;
  RootSum& sum = sums_[leaf.root];
  if (eye_->mask && eye_->mask->blur) {
    blurred_->add(leaf.region, held, found.mean, samples_->hit(0).t);
  } else {
    sum.radiance += held * leaf.weight * found.mean;
    sum.weight += held * leaf.weight;
  }
  sum.samples += found.samples;
  sum.cut_out |= found.standard_error > 0.0 && leaf.verdict.by_samples == BySamples::only;
  note_result(leaf, glm::vec3(found.mean));
  return true;
}

// A highlight, or what a bent or bumpy surface mirrors, is one sample's for a whole leaf.
void LeafShader::note_variation(const ShadedLeaf& shaded) {
  const PyrayLeaf& leaf = shaded.leaf;
  const Hit& hit = samples_->hit(leaf.sample);
  if (eye_->mask || !eye_->budget.refines() || leaf.region.marginal || leaf.weight == 1.0 ||
      !hit.valid())
    return;
  const Material& material = material_of(leaf);
  if (material.unlit || !may_be_glossy(material)) return;
  variation_.add(shaded);
}

// Leaves out what a leaf gets of the weak lights and the sky, which mirrored leaves have already.
void LeafShader::drop(std::uint32_t weak_share, std::uint32_t sky_share) {
  if (eye_->mask) return;
  weak_lights_->drop(weak_share);
  sky_.drop(sky_share);
}

// Leaves that turn out to differ are sampled after all.
void LeafShader::sample_uneven() {
  // Highlights bend between leaves, too, which their samples allow for.
  constexpr double allowed = 4.0;
  const auto tolerance = allowed * static_cast<double>(eye_->budget.tolerance);
  for (const ShadedLeaf& shaded : variation_.take_uneven(tolerance)) {
    const PyrayLeaf& leaf = shaded.leaf;
    sums_[leaf.root].add(glm::dvec3(shaded.radiance), -leaf.weight);
    drop(shaded.weak_lights, shaded.sky);
    if (shaded.lobes) lobes_.drop(*shaded.lobes);
    add_samples(leaf.root, leaf.sample, leaf.region, leaf.weight, few_samples);
  }
}

// Adds what leaves get of the weak lights.
void LeafShader::add_weak_lights() {
  if (weak_lights_->lights().empty()) return;
  const std::uint64_t before = eye_->counts->rays();
  const std::span<const WeakLights::Share> shares = weak_lights_->run();
  const auto rays = static_cast<double>(eye_->counts->rays() - before);
  for (const WeakLights::Share& share : shares) {
    if (share.sample == no_sample) continue;
    RootSum& sum = sums_[share.root];
    sum.radiance += share.radiance;
    sum.rays += static_cast<std::uint64_t>(rays / static_cast<double>(shares.size()));
    if (const auto found = results_.find(share.sample); found != results_.end())
      found->second += glm::vec3(share.radiance / share.weight);
  }
}

// Adds what leaves get of the sky, or by their lobes.
void LeafShader::add_shares(std::span<const LeafShare> shares) {
  for (const LeafShare& share : shares) {
    if (share.sample == no_sample) continue;
    RootSum& sum = sums_[share.root];
    sum.radiance += share.radiance;
    sum.rays += share.rays;
    if (const auto found = results_.find(share.sample); found != results_.end())
      found->second += glm::vec3(share.radiance / share.weight);
  }
}

void LeafShader::finish() {
  sample_uneven();
  sample_put_off();
  add_weak_lights();
  if (eye_->stop.stop_requested()) return;
  add_shares(sky_.run());
  add_shares(lobes_.run());
}

void LeafShader::sample_put_off() {
  if (put_off_.empty() || eye_->stop.stop_requested()) return;
  const std::uint64_t before = eye_->counts->rays();
  const auto found = sampler_->run(*eye_->counts);
  const auto rays = static_cast<double>(eye_->counts->rays() - before);
  const std::vector<PyrayLeaf> leaves = std::exchange(put_off_, {});
  std::uint64_t samples = 0;
  for (std::size_t i = 0; i < leaves.size(); ++i) samples += found[i].samples;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    // What is too thin to be met is shaded by its one sample.
    if (!add_estimate(leaves[i], found[i]) && samples_->hit(leaves[i].sample).valid())
      note_result(leaves[i], add_leaf(leaves[i], nullptr));
    // Each root's share of their rays.
    const double share =
        samples > 0 ? static_cast<double>(found[i].samples) / static_cast<double>(samples) : 0.0;
    sums_[leaves[i].root].rays += static_cast<std::uint64_t>(std::llround(share * rays));
  }
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
