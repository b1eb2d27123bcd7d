#include "renderer/session/sample_rounds.h"

#include "renderer/comparison/method.h"
#include "renderer/session/thread_seconds.h"
#include "renderer/session/tuning.h"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

namespace asos {
namespace {

bool ends_with_samples(const RenderSettings& settings) {
  return row_of(settings.method).places != nullptr;
}

RenderSettings by_sobol(RenderSettings settings, int samples) {
  settings.method = Method::sobol;
  settings.sampling.spp = samples;
  return settings;
}

// Samples of a pixel in the rounds before the blocks of a method, or only 1 if blocks take no more
// themselves.
int first_samples(const RenderSettings& settings) {
  return in_object_space(settings.method) && settings.asos.max_level == 0
             ? 1
             : tuning::samples_before_steps;
}

std::vector<int> rounds_of(int most) {
  std::vector<int> rounds;
  for (int samples = 0; samples < most; rounds.push_back(samples))
    samples = PixelSamples::after_round(samples, most);
  return rounds;
}

}  // namespace

SampleRounds::SampleRounds(const PlannedRender& render)
    : settings_(ends_with_samples(render.snapshot.settings)
                    ? render.snapshot.settings
                    : by_sobol(render.snapshot.settings, tuning::most_samples)),
      own_(ends_with_samples(render.snapshot.settings)),
      rounds_(
          rounds_of(own_ ? samples_a_pixel(settings_) : first_samples(render.snapshot.settings))),
      groups_(render.plan.groups.size()),
      next_(rounds_.size()),
      order_(render.plan.spread_groups()) {
  if (shows_coverage(settings_)) settings_ = with_coverage(settings_);
}

// Renders the missing rounds of a group up to this one; other threads may have rendered them
// already.
std::optional<BlockResult> SampleRounds::advance(const PlannedRender& render, std::size_t group,
                                                 int samples, double& seconds,
                                                 const std::stop_token& stop) {
  Group& own = groups_[group];
  const std::lock_guard lock(own.mutex);
  if (own.done) return std::nullopt;
  const double start = thread_seconds();
  const PixelRect& rect = render.plan.groups[group].rect;
  const BlockJob job = render.job(settings_, rect, stop);
  const auto take = [&](std::optional<PixelSamples>& pixels, const BlockJob& of) {
    if (!pixels) pixels.emplace(rect);
    const std::unique_ptr<PixelSampler> places = row_of(settings_.method).places(settings_);
    while (pixels->taken() < samples && !stop.stop_requested()) {
      const int end = PixelSamples::after_round(pixels->taken(), samples);
      pixels->advance(of, *places, end, own_ ? rounds_.back() : end);
    }
  };
  take(own.pixels, job);
  BlockResult result = own.pixels->result();
  if (shows_coverage(settings_)) take_coverage(render.snapshot.settings.layers, result);
  if (render.unlit) {
    const UnlitPasses passes(settings_);
    take(own.unlit_share, job.with(passes.share));
    add_unlit_share(own.unlit_share->result(), result);
    if (needs_unlit_colour(result.tile)) {
      take(own.unlit_colour, job.with(passes.colour));
      add_unlit_colour(own.unlit_colour->result(), result);
    }
  }
  fill_in(result);
  seconds = thread_seconds() - start;
  own.seconds += seconds;
  const std::size_t pixels = result.tile.radiance.size();
  result.tile.seconds.assign(
      pixels,
      static_cast<float>(own.seconds / static_cast<double>(std::max<std::size_t>(pixels, 1))));
  if (own_ && samples == rounds_.back()) drop_samples(own);
  return result;
}

// The caller holds the group's mutex.
void SampleRounds::drop_samples(Group& group) {
  group.done = true;
  group.pixels.reset();
  group.unlit_share.reset();
  group.unlit_colour.reset();
}

std::size_t SampleRounds::bytes() const {
  std::size_t sum = 0;
  for (const Group& group : groups_) {
    const std::lock_guard lock(group.mutex);
    for (const auto* pixels : {&group.pixels, &group.unlit_share, &group.unlit_colour})
      if (*pixels) sum += (*pixels)->bytes();
  }
  return sum;
}

// Counts a group's work. Its further rounds are expected at the pace of the latest one, and groups
// without a round at the mean pace. Another thread may have counted a later round.
void SampleRounds::count(std::size_t group, int samples, double seconds, RunClock& clock) {
  std::optional<double> left;
  {
    const std::lock_guard lock(mutex_);
    Group& own = groups_[group];
    if (samples > own.taken) {
      if (own.taken == 0) ++paced_;
      pace_ -= own.pace;
      left_ -= own.pace * (rounds_.back() - own.taken);
      own.pace = seconds / (samples - own.taken);
      own.taken = samples;
      pace_ += own.pace;
      left_ += own.pace * (rounds_.back() - own.taken);
      const double mean = pace_ / static_cast<double>(paced_);
      left = left_ + mean * rounds_.back() * static_cast<double>(groups_.size() - paced_);
      if (!own_) *left += tuning::blocks_over_sample * mean * static_cast<double>(groups_.size());
    }
  }
  clock.count(seconds, left, !own_);
}

void SampleRounds::prefer(const WorkPlan& plan, const PixelRect& part) {
  if (!own_) return;
  const std::lock_guard lock(mutex_);
  preferred_.clear();
  for (std::size_t g = 0; g < plan.groups.size(); ++g)
    if (!intersection(plan.groups[g].rect, part).empty()) preferred_.push_back(g);
}

std::optional<std::size_t> SampleRounds::take_preferred() {
  const std::lock_guard lock(mutex_);
  if (preferred_.empty()) return std::nullopt;
  const std::size_t group = preferred_.back();
  preferred_.pop_back();
  return group;
}

// Renders a group up to a round and publishes it. Returns true if that finished the picture.
bool SampleRounds::render(const PlannedRender& render, std::size_t group, std::size_t round,
                          TileCollector& tiles, RunClock& clock, const std::stop_token& stop) {
  const bool last = own_ && round + 1 == rounds_.size();
  double seconds = 0.0;
  std::optional<BlockResult> result = advance(render, group, rounds_[round], seconds, stop);
  if (!result || stop.stop_requested()) return false;
  count(group, rounds_[round], seconds, clock);
  if (last) return tiles.finish_block(render.plan.groups[group].first_block, *std::move(result));
  tiles.publish_coarse(group, pass_of_samples(rounds_[round]), std::move(result->tile));
  return false;
}

bool SampleRounds::work(const PlannedRender& render, std::size_t round, TileCollector& tiles,
                        RunClock& clock, const std::stop_token& stop) {
  const WorkPlan& plan = render.plan;
  bool finished_picture = false;
  while (clock.wait_while_paused(stop)) {
    // The first round covers the picture, whatever is preferred.
    const auto first = round > 0 ? take_preferred() : std::nullopt;
    if (first) {
      finished_picture |= this->render(render, *first, rounds_.size() - 1, tiles, clock, stop);
      continue;
    }
    const std::size_t index = next_[round]++;
    if (index >= plan.groups.size()) break;
    finished_picture |= this->render(render, order_[index], round, tiles, clock, stop);
    if (stop.stop_requested()) break;
    {
      const std::lock_guard lock(mutex_);
      if (++done_ % plan.groups.size() != 0) continue;
    }
    finished_.notify_all();
  }
  return finished_picture;
}

bool SampleRounds::wait_for_rounds(std::size_t before, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  return finished_.wait(lock, stop, [&] { return done_ >= before * groups_.size(); });
}

bool SampleRounds::put_what_moves_first(std::size_t round, const std::stop_token& stop) {
  if (!wait_for_rounds(round, stop)) return false;
  const std::lock_guard lock(mutex_);
  if (round <= ordered_round_) return true;
  ordered_round_ = round;
  std::vector<double> moved;
  for (const Group& group : groups_) moved.push_back(group.pixels->moved());
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return moved[a] > moved[b]; });
  return true;
}

// Continues the samples of one pass. Pixels with the same number of samples go together.
SampleRounds::Continued SampleRounds::continued(const PlannedRender& render,
                                                std::span<const PlannedPixel> pixels,
                                                PassOfGroup pass, const RenderSettings& settings,
                                                const std::stop_token& stop) const {
  Continued all;
  all.places.assign(pixels.begin(), pixels.end());
  const auto group_of = [&](const PlannedPixel& p) -> const Group& {
    return groups_[render.plan.blocks[p.block].group];
  };
  const auto taken = [&](const PlannedPixel& p) {
    const PixelSamples& samples = *group_of(p).pixels;
    return samples.taken(samples.index(p.x, p.y));
  };
  std::stable_sort(
      all.places.begin(), all.places.end(),
      [&](const PlannedPixel& a, const PlannedPixel& b) { return taken(a) < taken(b); });
  const bool layers = settings.layers.of_surfaces();
  if (layers) all.layers.resize(pixels.size());
  for (const PlannedPixel& p : all.places) {
    ContinuedPixel next{p.x, p.y, 0, {}, nullptr};
    const std::lock_guard lock(group_of(p).mutex);
    if (const std::optional<PixelSamples>& samples = group_of(p).*pass) {
      const std::size_t i = samples->index(p.x, p.y);
      next.taken = samples->taken(i);
      next.sum = samples->sum(i);
      if (layers) all.layers[all.pixels.size()] = *samples->layers(i);
    }
    if (layers) next.layers = &all.layers[all.pixels.size()];
    all.ends.push_back(4 * taken(p));
    all.pixels.push_back(next);
  }
  const BlockJob job = render.job(settings, {}, stop);
  const std::unique_ptr<PixelSampler> places = row_of(settings_.method).places(settings_);
  for (std::size_t first = 0, end = 0; first < all.pixels.size(); first = end) {
    while (end < all.pixels.size() && all.ends[end] == all.ends[first]) ++end;
    (void)asos::continue_pixels(job, *places, std::span(all.pixels).subspan(first, end - first),
                                all.ends[first], all.ends[first]);
  }
  return all;
}

void SampleRounds::put(const PlannedRender& render, const Continued& done, PassOfGroup pass) {
  for (std::size_t i = 0; i < done.places.size(); ++i) {
    const PlannedPixel& p = done.places[i];
    const std::size_t number = render.plan.blocks[p.block].group;
    Group& group = groups_[number];
    const std::lock_guard lock(group.mutex);
    std::optional<PixelSamples>& samples = group.*pass;
    if (!samples) samples.emplace(render.plan.groups[number].rect);
    samples->put(samples->index(p.x, p.y), done.ends[i], done.pixels[i].sum,
                 done.layers.empty() ? nullptr : &done.layers[i]);
  }
}

// The caller holds the group's mutex.
FinishedTile SampleRounds::tile(const PlannedRender& render, const Group& group,
                                const PixelRect& part) const {
  BlockResult result{group.pixels->tile(part), {}};
  if (shows_coverage(settings_)) take_coverage(render.snapshot.settings.layers, result);
  if (group.unlit_share) {
    add_unlit_share({group.unlit_share->tile(part), {}}, result);
    if (group.unlit_colour && needs_unlit_colour(result.tile))
      add_unlit_colour({group.unlit_colour->tile(part), {}}, result);
  }
  fill_in(result);
  const auto pixels = static_cast<double>(group.pixels->pixel_count());
  result.tile.seconds.assign(result.tile.radiance.size(),
                             static_cast<float>(group.seconds / pixels));
  return std::move(result.tile);
}

std::vector<StepQueue::Sampled> SampleRounds::continue_pixels(const PlannedRender& render,
                                                              std::span<const PlannedPixel> pixels,
                                                              TileCollector& tiles,
                                                              const std::stop_token& stop) {
  if (render.unlit) {
    const UnlitPasses passes(settings_);
    const Continued share = continued(render, pixels, &Group::unlit_share, passes.share, stop);
    std::vector<PlannedPixel> partly;
    for (std::size_t i = 0; i < share.places.size(); ++i) {
      const double mean = share.pixels[i].sum.mean().x;
      if (mean > 0.0 && mean < 1.0) partly.push_back(share.places[i]);
    }
    const Continued colour = continued(render, partly, &Group::unlit_colour, passes.colour, stop);
    if (stop.stop_requested()) return {};
    put(render, share, &Group::unlit_share);
    put(render, colour, &Group::unlit_colour);
  }
  const Continued done = continued(render, pixels, &Group::pixels, settings_, stop);
  if (stop.stop_requested()) return {};
  put(render, done, &Group::pixels);
  std::vector<StepQueue::Sampled> sampled;
  std::vector<std::uint32_t> blocks;
  for (const PlannedPixel& p : pixels) {
    const PixelSamples& of = *groups_[render.plan.blocks[p.block].group].pixels;
    const std::size_t i = of.index(p.x, p.y);
    sampled.push_back({of.taken(i), of.moved(i)});
    blocks.push_back(p.block);
  }
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  for (const std::uint32_t block : blocks) {
    const WorkPlan::Block& of = render.plan.blocks[block];
    Group& group = groups_[of.group];
    // Published under the mutex, so that an older tile cannot follow a newer one.
    const std::lock_guard lock(group.mutex);
    tiles.publish_sampled(block, tile(render, group, of.rect));
  }
  return sampled;
}

}  // namespace asos
