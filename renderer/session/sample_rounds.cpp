#include "renderer/session/sample_rounds.h"

#include "renderer/comparison/method.h"
#include "renderer/session/thread_seconds.h"

#include <algorithm>
#include <memory>
#include <numeric>
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

std::vector<int> rounds_of(const RenderSettings& settings) {
  const int most = samples_a_pixel(settings);
  std::vector<int> rounds;
  for (int samples = 0; samples < most; rounds.push_back(samples))
    samples = PixelSamples::after_round(samples, most);
  return rounds;
}

}  // namespace

SampleRounds::SampleRounds(const PlannedRender& render)
    : settings_(ends_with_samples(render.snapshot.settings)
                    ? render.snapshot.settings
                    : by_sobol(render.snapshot.settings, 1 << (most_rounds - 1))),
      own_(ends_with_samples(render.snapshot.settings)),
      rounds_(rounds_of(settings_)),
      groups_(render.plan.groups.size()),
      next_(rounds_.size()),
      done_(rounds_.size()),
      order_(render.group_order) {
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

void SampleRounds::release() {
  for (Group& group : groups_) {
    const std::lock_guard lock(group.mutex);
    drop_samples(group);
  }
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

bool SampleRounds::work(const PlannedRender& render, std::size_t round, std::size_t pass,
                        TileCollector& tiles, RunClock& clock, const std::stop_token& stop) {
  const WorkPlan& plan = render.plan;
  const bool last = own_ && round + 1 == rounds_.size();
  bool finished_picture = false;
  while (clock.wait_while_paused(stop)) {
    const std::size_t index = next_[round]++;
    if (index >= plan.groups.size()) break;
    const std::size_t at = order_[index];
    const BlockGroup& group = plan.groups[at];
    double seconds = 0.0;
    std::optional<BlockResult> result = advance(render, at, rounds_[round], seconds, stop);
    if (stop.stop_requested()) break;
    for (std::size_t k = 0; k < group.block_count; ++k)
      clock.count_block(pass, group.first_block + k,
                        seconds / static_cast<double>(group.block_count));
    if (result && last) {
      finished_picture |= tiles.finish_block(group.first_block, *std::move(result));
    } else if (result) {
      tiles.publish_coarse(at, pass_of_samples(rounds_[round]), std::move(result->tile));
    }
    {
      const std::lock_guard lock(mutex_);
      done_[round].seconds += seconds;
      if (++done_[round].groups < plan.groups.size()) continue;
    }
    finished_.notify_all();
  }
  return finished_picture;
}

void SampleRounds::put_what_moves_first(std::size_t next_round) {
  const std::lock_guard lock(mutex_);
  if (ordered_round_ == next_round) return;
  ordered_round_ = next_round;
  std::vector<double> moved;
  for (const Group& group : groups_) {
    const std::vector<float>& pixels = group.pixels->moved();
    moved.push_back(std::accumulate(pixels.begin(), pixels.end(), 0.0));
  }
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return moved[a] > moved[b]; });
}

bool SampleRounds::wait_for(std::size_t round, const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  return finished_.wait(lock, stop, [&] { return done_[round].groups == groups_.size(); });
}

double SampleRounds::seconds_up_to(std::size_t round) const {
  const std::lock_guard lock(mutex_);
  double seconds = 0.0;
  for (std::size_t i = 0; i <= round; ++i) seconds += done_[i].seconds;
  return seconds;
}

std::vector<double> SampleRounds::moved(const WorkPlan& plan) const {
  std::vector<double> sums(plan.blocks.size(), 0.0);
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    const std::size_t group = plan.blocks[i].group;
    if (!groups_[group].pixels) continue;
    const std::vector<float>& moved = groups_[group].pixels->moved();
    const PixelRect& all = plan.groups[group].rect;
    const PixelRect part = intersection(plan.blocks[i].rect, all);
    for (int y = part.y; y < part.y + part.height; ++y)
      for (int x = part.x; x < part.x + part.width; ++x)
        sums[i] += static_cast<double>(
            moved[static_cast<std::size_t>((y - all.y) * all.width + (x - all.x))]);
  }
  return sums;
}

}  // namespace asos
