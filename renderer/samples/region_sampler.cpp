#include "renderer/samples/region_sampler.h"

#include "renderer/pyray/tuning.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace asos {
namespace {

constexpr auto parts = static_cast<std::uint32_t>(SequentialMean::parts);
constexpr auto most_sums = static_cast<std::uint32_t>(SequentialMean::most_sums);

/// Returns the first of the `count` samples of its pixel that a square uses. Squares of one pixel
/// use different parts of the same sequence; with equal samples their errors would be equal and add
/// up. Z-order makes neighbours' samples well distributed together. `count` is a power of two. The
/// numbers suffice for `enough` samples each.
std::uint32_t first_sample(glm::dvec2 middle, std::uint32_t count) {
  constexpr std::uint32_t enough = 1u << 14;
  constexpr double cells = 256.0;  // per side of a pixel
  const glm::dvec2 at = cells * (middle - glm::floor(middle));
  const auto x = static_cast<std::uint32_t>(at.x), y = static_cast<std::uint32_t>(at.y);
  std::uint32_t number = 0;
  for (std::uint32_t bit = 0; bit < 8; ++bit)
    number |= ((x >> bit & 1u) << (2 * bit)) | ((y >> bit & 1u) << (2 * bit + 1));
  return number * std::min(count, enough);
}

/// Returns by how many times the bounding rectangle, over which samples are spread, is larger than
/// a region, as a power of two. Only few samples hit a thin region, and a few samples give no error
/// estimate.
std::uint32_t times_larger_around(const LeafRegion& region) {
  // Round to about the nearest power of two.
  const float times = 1.5f / filled_share(region, bounds_of(region));
  return times < SampleTuning::most_times_larger
             ? std::bit_floor(static_cast<std::uint32_t>(std::max(1.0f, times)))
             : static_cast<std::uint32_t>(SampleTuning::most_times_larger);
}

/// Returns whether a region fills most of its pixel.
bool fills_pixel(const RegionSampler::Goal& goal) {
  return goal.share > SampleTuning::most_of_a_pixel;
}

}  // namespace

RegionSampler::RegionSampler(const RenderScene& scene, const ViewContext& viewer,
                             const RenderSettings& settings, PixelRect block, int seed,
                             const ReflectionMask* mask, std::stop_token stop, SummedRadiance shows)
    : block_(block),
      mask_(mask),
      stop_(std::move(stop)),
      white_(1.0 / std::clamp(static_cast<double>(viewer.throughput), 1e-3, 1.0)),
      places_(seed),
      sums_(scene, viewer, settings, places_, shows),
      scene_(&scene),
      viewer_(&viewer),
      settings_(&settings) {
  sums_.widen_colours(colour_side / SampleTuning::footprint_share);
  sums_.subtract_open_sky();
}

std::size_t RegionSampler::add(const LeafRegion& region, const Goal& goal,
                               std::uint32_t layer_samples) {
  Waiting& waiting = waiting_.emplace_back();
  waiting.layer_samples = layer_samples;
  waiting.square = region.square;
  waiting.first_edge = borders_.size();
  waiting.edges = region.border.size();
  borders_.insert(borders_.end(), region.border.begin(), region.border.end());
  waiting.goal = goal;
  const std::uint32_t times = times_larger_around(region);
  waiting.goal.least *= times;
  waiting.goal.most *= times;
  waiting.per_sum = std::max(1u, waiting.goal.least / parts);
  return waiting_.size() - 1;
}

std::span<const RegionSampler::Mean> RegionSampler::run(RenderStatistics& counts,
                                                        const BlurKernel* kernel) {
  make_room();
  sample_stage(1.0, counts, kernel);
  forget();
  return found_;
}

std::span<const RegionSampler::Mean> RegionSampler::start(RenderStatistics& counts, double times) {
  make_room();
  sample_stage(times, counts, nullptr);
  add_samples_for_layers(counts);
  return found_;
}

std::span<const RegionSampler::Mean> RegionSampler::finish(RenderStatistics& counts) {
  sample_stage(1.0, counts, nullptr);
  forget();
  return found_;
}

RegionSampler::Open RegionSampler::take_open() {
  Open open;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const Waiting& waiting = waiting_[i];
    if (waiting.done) continue;
    if (with_layers_) open.layers_.push_back(std::move(layers_[i]));
    Waiting& kept = open.waiting_.emplace_back(waiting);
    kept.first_edge = open.borders_.size();
    const auto edges = std::span(borders_).subspan(waiting.first_edge, waiting.edges);
    open.borders_.insert(open.borders_.end(), edges.begin(), edges.end());
    for (std::uint32_t k = 0; k < waiting.taken / waiting.per_sum; ++k)
      open.sums_.push_back(sums_.sum(waiting.first_sum + k));
  }
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const Waiting& waiting = waiting_[i];
    if (waiting.done && fills_pixel(waiting.goal) && found_[i].cost > 0.0 &&
        std::any_of(open.waiting_.begin(), open.waiting_.end(), [&](const Waiting& other) {
          return fills_pixel(other.goal) && near(waiting.square, other.square);
        }))
      open.finished_.push_back({waiting.square, waiting.taken, found_[i].error});
  }
  forget();
  return open;
}

std::span<const RegionSampler::Mean> RegionSampler::resume(Open&& open, RenderStatistics& counts) {
  waiting_ = std::move(open.waiting_);
  finished_ = std::move(open.finished_);
  borders_ = std::move(open.borders_);
  make_room();
  if (with_layers_) layers_ = std::move(open.layers_);
  note_layers_of_waiting();
  std::size_t next = 0;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    const Waiting& waiting = waiting_[i];
    for (std::uint32_t k = 0; k < waiting.taken / waiting.per_sum; ++k)
      sums_.continue_from(waiting.first_sum + k, open.sums_[next++]);
    found_[i] = mean_of(waiting);
    found_[i].error = standard_error(waiting, found_[i].value);
  }
  sample_stage(1.0, counts, nullptr);
  add_samples_for_layers(counts);
  forget();
  return found_;
}

// Makes room for the sums and estimates of all waiting regions.
void RegionSampler::make_room() {
  for (std::size_t i = 0; i < waiting_.size(); ++i) waiting_[i].first_sum = most_sums * i;
  sums_.resize(0);
  sums_.resize(most_sums * waiting_.size());
  found_.assign(waiting_.size(), {});
  if (!with_layers_) return;
  layers_.assign(waiting_.size(), {});
  note_layers_of_waiting();
}

void RegionSampler::note_layers_of_waiting() {
  if (!with_layers_) return;
  targets_ = {};
  targets_.targets_each = most_sums;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    targets_.surfaces.push_back(waiting_[i].layer_samples > 0 ? &layers_[i] : nullptr);
    targets_.light.push_back(&layers_[i].light);
  }
  sums_.note_layers(*settings_, targets_);
}

// Adds eye rays to regions whose radiance converged early: few samples may not give the coverage of
// a dark object before a dark background. Eye rays are cheap.
void RegionSampler::add_samples_for_layers(RenderStatistics& counts) {
  const auto needs_more = [](const Waiting& waiting) {
    return waiting.done && waiting.taken < waiting.layer_samples;
  };
  if (!with_layers_ || std::none_of(waiting_.begin(), waiting_.end(), needs_more)) return;
  SampleSums rays(*scene_, *viewer_, *settings_, places_, SummedRadiance::layers);
  rays.resize(most_sums * waiting_.size());
  rays.note_layers(*settings_, targets_);
  for (const Waiting& waiting : waiting_) {
    if (!needs_more(waiting)) continue;
    Waiting more = waiting;
    add_samples(rays, more, waiting.layer_samples, nullptr);
  }
  rays.trace();
  counts += rays.statistics();
}

void RegionSampler::forget() {
  waiting_.clear();
  finished_.clear();
  borders_.clear();
}

// Samples, in rounds, all regions with errors above `times` their goals' errors.
void RegionSampler::sample_stage(double times, RenderStatistics& counts, const BlurKernel* kernel) {
  for (Waiting& waiting : waiting_) waiting.rests = waiting.done;
  const auto left = [&] {
    return std::any_of(waiting_.begin(), waiting_.end(), [](const Waiting& w) { return !w.rests; });
  };
  while (left() && !stop_.stop_requested()) {
    for (Waiting& waiting : waiting_)
      if (!waiting.rests) add_round(waiting, kernel);
    sums_.trace();
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      if (waiting_[i].rests) continue;
      found_[i] = mean_of(waiting_[i]);
      found_[i].error = standard_error(waiting_[i], found_[i].value);
    }
    // Decide for all regions before any of them ends, since they use their neighbours' errors.
    suffices_.clear();
    for (std::size_t i = 0; i < waiting_.size(); ++i) suffices_.push_back(suffices(i, times));
    for (std::size_t i = 0; i < waiting_.size(); ++i)
      waiting_[i].rests = waiting_[i].rests || suffices_[i];
  }
  sample_inside();
  suffices_.clear();
  for (std::size_t i = 0; i < waiting_.size(); ++i) suffices_.push_back(suffices(i, 1.0));
  for (std::size_t i = 0; i < waiting_.size(); ++i)
    if (suffices_[i]) end(i);
  counts += sums_.statistics();
  sums_.statistics() = {};
}

void RegionSampler::end(std::size_t number) {
  if (std::exchange(waiting_[number].done, true) || !with_layers_) return;
  LightSum& light = layers_[number].light;
  light.add(LightPart::direct, light.weight * found_[number].raised);
}

bool RegionSampler::suffices(std::size_t number, double times) const {
  const Waiting& waiting = waiting_[number];
  if (waiting.done || waiting.goal.exhausted(waiting.taken)) return true;
  return found_[number].cost > 0.0 &&
         waiting.goal.met(waiting.taken, expected_error(number) / times);
}

// Returns whether two regions that fill their pixels are in neighbouring pixels.
bool RegionSampler::near(const Square& a, const Square& b) const {
  const double reach = 1.5 / static_cast<double>(block_.width);
  return std::abs(a.centre_u() - b.centre_u()) <= reach &&
         std::abs(a.centre_v() - b.centre_v()) <= reach;
}

// Returns a region's error, increased by a part of the variance of its neighbours. Neighbours are
// regions that fill most of one of the eight surrounding pixels; their variance is scaled to the
// same number of samples. With few samples, all may miss a small bright spot, so that their
// variance is wrongly zero. If neighbours have hit one, it is likely to be there.
double RegionSampler::expected_error(std::size_t number) const {
  const Waiting& own = waiting_[number];
  const double error = found_[number].error;
  if (!fills_pixel(own.goal)) return error;
  double squares = 0.0;
  int count = 0;
  const auto add = [&](const Square& square, double off, std::uint32_t taken) {
    if (!near(own.square, square)) return;
    squares += off * off * taken / own.taken;
    ++count;
  };
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    if (i != number && fills_pixel(waiting_[i].goal) && found_[i].cost > 0.0)
      add(waiting_[i].square, found_[i].error, waiting_[i].taken);
  }
  for (const Finished& other : finished_) add(other.square, other.error, other.taken);
  return count > 0 ? std::sqrt(error * error + SampleTuning::of_neighbours * squares / count)
                   : error;
}

// Adds as many samples as there are so far.
void RegionSampler::add_round(Waiting& waiting, const BlurKernel* kernel) {
  const std::uint32_t end = waiting.goal.after_next_round(waiting.taken);
  if (end > most_sums * waiting.per_sum) {
    sums_.add_pairs(waiting.first_sum, waiting.taken / waiting.per_sum);
    waiting.per_sum *= 2;
  }
  add_samples(sums_, waiting, end, kernel);
}

// Samples `waiting.taken` to `end` - 1 of a region.
void RegionSampler::add_samples(SampleSums& sums, Waiting& waiting, std::uint32_t end,
                                const BlurKernel* kernel) {
  const LeafRegion part = region(waiting);
  const Bounds2 bounds = bounds_of(part);
  const double width = static_cast<double>(block_.width);
  const glm::dvec2 origin(block_.x, block_.y);
  const auto x = static_cast<int>(std::floor(origin.x + width * part.square.u));
  const auto y = static_cast<int>(std::floor(origin.y + width * part.square.v));
  const glm::vec2 size = (bounds.hi - bounds.lo) * static_cast<float>(width);
  const float side =
      SampleTuning::footprint_share * std::sqrt(size.x * size.y / static_cast<float>(end));
  const glm::dvec2 middle(part.square.centre_u(), part.square.centre_v());
  const std::uint32_t first = first_sample(origin + width * middle, waiting.goal.most);
  places_.start_pixel(x, y);
  for (std::uint32_t i = waiting.taken; i < end && !stop_.stop_requested(); ++i) {
    const auto index = static_cast<int>(first + i);
    places_.start_sample(index);
    const PixelPoint p = places_.in_pixel();
    glm::vec2 at = glm::mix(bounds.lo, bounds.hi, glm::vec2(p.x, p.y));
    if (kernel) at = kernel->warped(at, bounds);
    if (!part.holds(at)) continue;
    ++waiting.in_region;
    if (mask_ && !mask_->holds(at)) {
      ++waiting.masked;
      continue;
    }
    const std::uint32_t sum = std::min(i / waiting.per_sum, most_sums - 1);
    if (sums.add({origin + width * glm::dvec2(at), side, x, y, index, waiting.first_sum + sum}))
      places_.start_pixel(x, y);
  }
  waiting.taken = end;
}

// Samples the place inside each region that no sample met. Its samples are the only ones.
void RegionSampler::sample_inside() {
  if (stop_.stop_requested()) return;
  const auto alone = [&](std::size_t i) { return waiting_[i].inside && found_[i].cost == 0.0; };
  const double width = static_cast<double>(block_.width);
  const glm::dvec2 origin(block_.x, block_.y);
  bool any = false;
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    if (!alone(i)) continue;
    const Waiting& waiting = waiting_[i];
    const glm::dvec2 at = origin + width * glm::dvec2(*waiting.inside);
    const auto side =
        SampleTuning::footprint_share * static_cast<float>(std::sqrt(waiting.goal.share));
    const std::uint32_t index = first_sample(at, waiting.goal.most) + waiting.taken;
    sums_.add({at, side, static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)),
               static_cast<int>(index), waiting.first_sum});
    any = true;
  }
  if (!any) return;
  sums_.trace();
  for (std::size_t i = 0; i < waiting_.size(); ++i)
    if (alone(i)) found_[i] = mean_of(waiting_[i]);
}

RegionSampler::Mean RegionSampler::mean_of(const Waiting& waiting) const {
  Mean all;
  for (std::uint32_t k = 0; k < waiting.taken / waiting.per_sum; ++k) {
    const SampleSums::Sum sum = sums_.sum(waiting.first_sum + k);
    all.value += sum.radiance;
    all.cost += sum.count;
  }
  if (all.cost > 0.0) all.value /= all.cost;
  all.raised = glm::max(-all.value, glm::dvec3(0.0));
  all.value = glm::max(all.value, glm::dvec3(0.0));
  all.one_round = waiting.taken <= waiting.goal.least;
  if (waiting.in_region > 0)
    all.masked_share = static_cast<double>(waiting.masked) / waiting.in_region;
  return all;
}

// For a pixel that is certainly brighter than white, the error is relative to its value: it has the
// accuracy of white after an exposure that shows it as white.
double RegionSampler::standard_error(const Waiting& waiting, glm::dvec3 mean) const {
  std::array<SequentialMean::Sum, most_sums> sums;
  const std::uint32_t count = waiting.taken / waiting.per_sum;
  for (std::uint32_t k = 0; k < count; ++k) {
    const SampleSums::Sum sum = sums_.sum(waiting.first_sum + k);
    sums[k] = {sum.radiance, static_cast<double>(sum.count)};
  }
  const glm::dvec3 white = glm::max(glm::dvec3(1.0), waiting.goal.share / white_ * mean);
  return SequentialMean::standard_error_of(std::span(sums).first(count), mean, [&](glm::dvec3 off) {
    off /= white;
    return std::min(white_, std::max({off.x, off.y, off.z}));
  });
}

RegionSampler::Goal sample_goal(const ErrorBudget& error_budget, double weight,
                                std::uint32_t fewest) {
  constexpr double most = 1u << 20;
  RegionSampler::Goal goal;
  goal.standard_error = error_budget.standard_error(weight);
  goal.share = error_budget.weight * weight;
  goal.most =
      std::bit_floor(static_cast<std::uint32_t>(std::min(most, error_budget.most_samples(weight))));
  goal.least = std::min(goal.most, std::max(error_budget.pilot_samples(weight), fewest));
  return goal;
}

}  // namespace asos
