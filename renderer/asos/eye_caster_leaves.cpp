#include "renderer/asos/eye_caster.h"
#include "renderer/asos/texture_samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

// What becomes of a pyray's leaves: shaded as they are, divided for their textures, or sampled.

namespace asos {
namespace {

/// Samples of a part of a pixel, at least: so many tell how far their mean may be off; so few are
/// right where there are many such parts, or the part is only one of what a mirror shows.
constexpr std::uint32_t enough_samples = 16;
constexpr std::uint32_t few_samples = 4;

}  // namespace

void EyeCaster::leaf(std::uint32_t root, SampleId sample, double weight, const LeafRegion& region) {
  if (cancelled()) return;
  const std::uint64_t before = counts_.rays();
  if (PyrayLog* log = work_.shadows.log) {
    // The pyrays of other roots are not written down.
    const PyrayLog::Leaf outer = log->leaf();
    const bool logged = root == logged_root_;
    log->set_leaf({logged, outer.parent, points_[sample], weight});
    finish_leaf(root, sample, weight, region);
    log->set_leaf(outer);
  } else {
    finish_leaf(root, sample, weight, region);
  }
  sums_[root].rays += counts_.rays() - before;
}

void EyeCaster::finish_leaf(std::uint32_t root, SampleId sample, double weight,
                            const LeafRegion& region) {
  if (mask_ && !mask_->holds(points_[sample])) return;
  const std::uint32_t fewest = glints(sample, weight)                   ? few_samples
                               : uneven_at_last(sample, weight, region) ? enough_samples
                                                                        : 0;
  if (fewest > 0 && add_samples(root, sample, region, weight, fewest) > 0) return;
  if (add_texture_samples(root, sample, region, weight)) return;
  const glm::vec3 radiance = add_leaf(root, sample, weight, region);
  if (root == logged_root_) log_leaf(sample, weight, radiance);
}

glm::vec3 EyeCaster::add_leaf(std::uint32_t root, SampleId sample, double weight,
                              const LeafRegion& region) {
  counted_shadows_.forget();
  met_mirror_edge_ = false;
  const glm::vec3 radiance = shade(sample, weight, region, counts_);
  sums_[root].shadow_cut |= counted_shadows_.met_shadow_edge();
  sums_[root].mirror_cut |= met_mirror_edge_;
  if (!std::isfinite(radiance.x + radiance.y + radiance.z)) {
    ++counts_.rejected_samples;
    return radiance;
  }
  if (mask_ && mask_->blur) {
    const auto light = shader_.nearest_bare_light(rays_[sample]);
    add_blurred(region, 1.0, glm::dvec3(radiance),
                light ? std::min(light->t, hits_[sample].t) : hits_[sample].t);
    return radiance;
  }
  sums_[root].radiance += weight * glm::dvec3(radiance);
  sums_[root].weight += weight;
  return radiance;
}

void EyeCaster::add_blurred(const LeafRegion& region, double share, glm::dvec3 radiance,
                            float distance) {
  blurred_.push_back({region.square, blurred_sides_.size(), region.sides.size(), share, radiance});
  blurred_sides_.insert(blurred_sides_.end(), region.sides.begin(), region.sides.end());
  nearest_blurred_ = std::min(nearest_blurred_, distance);
}

// The boundaries between the leaves are mostly the nearest surface's: its depth says how they are
// blurred.
glm::vec3 EyeCaster::blurred_colour() const {
  const BlurKernel kernel = mask_->blur->at(static_cast<double>(nearest_blurred_));
  Sum sum;
  for (const BlurredLeaf& leaf : blurred_) {
    const auto sides = std::span(blurred_sides_).subspan(leaf.first_side, leaf.side_count);
    const double weight = leaf.share * kernel.integral({leaf.square, sides});
    sum.radiance += weight * leaf.radiance;
    sum.weight += weight;
  }
  return sum.weight > 0.0 ? glm::vec3(sum.radiance / sum.weight) : glm::vec3(0.0f);
}

// Divides a leaf of a textured surface that no boundary passes through into TR x TR samples of a
// pixel, each with its own share of the area (CGF'98 section 3.2). False: it is not to be divided.
bool EyeCaster::add_texture_samples(std::uint32_t root, SampleId sample, const LeafRegion& region,
                                    double weight) {
  const double side = static_cast<double>(region.square.side) * block_.width;
  const int n =
      texture_divisions(settings_.texture.resolution, side / static_cast<double>(viewer_.pixel));
  const Hit& hit = hits_[sample];
  // What a mask cuts off is told by whole leaves only.
  const bool masked_part = mask_ && !region.sides.empty();
  if (n == 1 || region.marginal || masked_part || !hit.valid() ||
      !is_textured(scene_.world.material_of(hit.triangle), scene_.needs))
    return false;
  const std::vector<TexturePart> parts =
      texture_parts(region, n, {{block_.x, block_.y}, block_.width}, settings_.seed,
                    settings_.texture.filter == TextureFilter::point);
  if (parts.empty()) return false;
  std::vector<glm::vec2> places;
  for (const TexturePart& part : parts) places.push_back(part.at);
  const SampleId first = probe(places);
  const Sum before = sums_[root];
  const double share = weight / static_cast<double>(parts.size());
  // One look at the lights does for all of them.
  EvenPatch whole = even_patch(sample, region);
  divided_ = region.sides.empty() && opaque(sample) ? &whole : nullptr;
  for (std::size_t i = 0; i < parts.size() && !cancelled(); ++i)
    (void)add_leaf(root, first + static_cast<SampleId>(i), share,
                   {parts[i].square, {}, parts[i].marginal});
  divided_ = nullptr;
  if (root == logged_root_) {
    const double added = sums_[root].weight - before.weight;
    const glm::dvec3 radiance = sums_[root].radiance - before.radiance;
    log_leaf(sample, weight, added > 0.0 ? glm::vec3(radiance / added) : glm::vec3(0.0f));
  }
  return true;
}

void EyeCaster::log_leaf(SampleId sample, double weight, glm::vec3 radiance) {
  logged_leaves_.push_back({sample, points_[sample], weight});
  logged_radiance_.emplace(sample, radiance);
}

Caster::TakenOver EyeCaster::sample_tangle(std::uint32_t root, const Square& square,
                                           double weight) {
  if (!std::isfinite(most_uneven_)) return {};
  // A number for all of the samples, where nothing was met.
  const auto sample = static_cast<SampleId>(rays_.size());
  points_.emplace_back(square.centre_u(), square.centre_v());
  rays_.push_back(ray_through(points_.back()));
  hits_.emplace_back();
  const std::uint64_t before = counts_.rays();
  const std::uint32_t taken = add_samples(root, sample, {square, {}}, weight, enough_samples);
  sums_[root].rays += counts_.rays() - before;
  return {taken, sample};
}

// Half of what is let pass for a pixel, so that its parts, whose errors are independent, stay
// within it together; one sample for each finest cell at least, and four at most, or sixteen where
// what is mirrored may be far brighter than white.
std::uint32_t EyeCaster::add_samples(std::uint32_t root, SampleId sample, const LeafRegion& region,
                                     double weight, std::uint32_t fewest) {
  if (!sampler_) sampler_.emplace(scene_, viewer_, settings_, block_, mask_);
  RegionSampler::Goal goal;
  goal.standard_error = 0.5 * static_cast<double>(most_uneven_) / std::sqrt(weight);
  const double finest_cells = weight * std::ldexp(1.0, 2 * settings_.asos.max_level);
  const bool reflected = viewer_.bounces > 0;
  if (reflected) fewest = few_samples;
  const auto number = [&](double samples) {
    return std::bit_ceil(std::max(fewest, static_cast<std::uint32_t>(samples)));
  };
  goal.least = number(finest_cells);
  goal.most = number((reflected ? 16.0 : 4.0) * finest_cells);
  const bool blurred = mask_ && mask_->blur;
  std::optional<BlurKernel> kernel;
  // The first sample is that of the root's middle.
  if (blurred) kernel = mask_->blur->at(static_cast<double>(hits_[0].t));
  const RegionSampler::Estimate found =
      sampler_->sample(region, goal, counts_, kernel ? &*kernel : nullptr);
  const double held = 1.0 - found.masked_share;
  if (blurred && found.samples > 0) {
    add_blurred(region, held, found.mean, hits_[0].t);
  } else if (found.samples > 0) {
    sums_[root].radiance += held * weight * found.mean;
    sums_[root].weight += held * weight;
  }
  if (root == logged_root_ && found.samples > 0) log_leaf(sample, weight, glm::vec3(found.mean));
  return found.samples;
}

glm::vec3 EyeCaster::colour(std::uint32_t root) const {
  if (mask_ && mask_->blur) return blurred_colour();
  const Sum& sum = sums_[root];
  return sum.weight > 0.0 ? glm::vec3(sum.radiance / sum.weight) : glm::vec3(0.0f);
}

}  // namespace asos
