#include "renderer/session/final_blocks.h"

#include "renderer/comparison/method.h"
#include "renderer/session/thread_seconds.h"

#include <algorithm>
#include <utility>

namespace asos {
namespace {

// One block in blocks_a_trial is part of the trial, and at most most_tried in all, to limit its
// time.
constexpr std::size_t blocks_a_trial = 32;
constexpr std::size_t most_tried = 48;
// One block in blocks_a_spread is done in spread order instead of by its gain, so that the cost of
// the remaining blocks can be forecast.
constexpr std::size_t blocks_a_spread = 4;

BlockJob job_of(const PlannedRender& render, std::size_t block, const std::stop_token& stop) {
  return render.job(render.snapshot.settings, render.plan.blocks[block].rect, stop);
}

void set_seconds(double seconds, FinishedTile& tile) {
  const std::size_t pixels = tile.radiance.size();
  const double each = seconds / static_cast<double>(std::max<std::size_t>(pixels, 1));
  tile.seconds.assign(pixels, static_cast<float>(each));
}

}  // namespace

FinalBlocks::FinalBlocks(const PlannedRender& render, std::size_t pass)
    : pass_(pass),
      order_(render.plan.spread_blocks()),
      trial_(std::min(most_tried, (order_.size() + blocks_a_trial - 1) / blocks_a_trial)),
      most_bytes_(bytes_a_pixel * static_cast<std::size_t>(render.plan.visible.width) *
                  static_cast<std::size_t>(render.plan.visible.height)),
      seconds_(trial_, -1.0),
      left_to_start_(order_.size()) {}

// Renders the method's first stage of a block, and publishes it. Returns no rest if the block is
// final, or a stop was requested.
FinalBlocks::Started FinalBlocks::start(const PlannedRender& render, std::size_t block, bool keep,
                                        TileCollector& tiles, RunClock& clock,
                                        const std::stop_token& stop, bool& finished_picture) {
  const RenderSettings& settings = render.snapshot.settings;
  const BlockJob job = job_of(render, block, stop);
  const auto first_stage = row_of(settings.method).start;
  const bool in_stages =
      render.snapshot.progressive && first_stage && !render.motion && !shows_coverage(settings);
  const double before = thread_seconds();
  StartedBlock done;
  if (in_stages) {
    done = first_stage(job);
  } else {
    done.result = render_block(job);
  }
  if (render.unlit) add_unlit(job, done.result);
  Started started{block, std::move(done.rest), {}, 0.0, thread_seconds() - before};
  if (stop.stop_requested()) return {};
  clock.count_block(pass_, block, started.seconds);
  fill_in(done.result);
  set_seconds(started.seconds, done.result.tile);
  if (!started.rest) {
    clock.count_block(pass_ + 1, block, 0.0);
    finished_picture |= tiles.finish_block(block, std::move(done.result));
    return started;
  }
  started.gain = started.rest->gain();
  started.unlit = done.result.tile.unlit;
  if (keep) tiles.publish_started(block, std::move(done.result.tile));
  return started;
}

bool FinalBlocks::finish(const PlannedRender& render, Started& started, TileCollector& tiles,
                         RunClock& clock, const std::stop_token& stop) {
  const double before = thread_seconds();
  BlockResult result = started.rest->finish(job_of(render, started.block, stop));
  started.rest.reset();
  renew_unlit(std::move(started.unlit), result);
  if (stop.stop_requested()) return false;
  const double seconds = thread_seconds() - before;
  clock.count_block(pass_ + 1, started.block, seconds);
  started.seconds += seconds;
  fill_in(result);
  set_seconds(started.seconds, result.tile);
  return tiles.finish_block(started.block, std::move(result));
}

bool FinalBlocks::work_trial(const PlannedRender& render, double enough, TileCollector& tiles,
                             RunClock& clock, const std::stop_token& stop) {
  bool finished_picture = false;
  while (clock.wait_while_paused(stop)) {
    std::size_t index = 0, block = 0;
    {
      const std::lock_guard lock(mutex_);
      if (handed_out_ == 0) enough_ = enough;
      if (ordered_ || trial_is_over() || handed_out_ == trial_) break;
      index = handed_out_++;
      block = order_[index];
    }
    Started tried = start(render, block, false, tiles, clock, stop, finished_picture);
    if (tried.rest) finished_picture |= finish(render, tried, tiles, clock, stop);
    if (stop.stop_requested()) return false;
    {
      const std::lock_guard lock(mutex_);
      seconds_[index] = tried.seconds;
      --left_to_start_;
    }
    changed_.notify_all();
  }
  return finished_picture;
}

// Returns whether the first finished blocks of the trial took more than enough_, or are the whole
// trial. The caller holds mutex_.
bool FinalBlocks::trial_is_over() const {
  double sum = 0.0;
  for (const double seconds : seconds_) {
    if (seconds < 0.0) return false;
    sum += seconds;
    if (sum > enough_) return true;
  }
  return true;
}

bool FinalBlocks::wait_for_trial(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  return changed_.wait(lock, stop, [&] { return trial_is_over(); });
}

double FinalBlocks::expected_seconds() const {
  const std::lock_guard lock(mutex_);
  double sum = 0.0;
  std::size_t count = 0;
  for (const double seconds : seconds_) {
    if (seconds < 0.0 || sum > enough_) break;
    sum += seconds;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) * static_cast<double>(order_.size()) : 0.0;
}

void FinalBlocks::set_gains(std::span<const double> gain) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(ordered_, true)) return;
  next_ = handed_out_;
  const auto rest = order_.begin() + static_cast<std::ptrdiff_t>(handed_out_);
  const std::vector<std::size_t> spread(rest, order_.end());
  std::vector<std::size_t> by_gain = spread;
  std::stable_sort(by_gain.begin(), by_gain.end(),
                   [&](std::size_t a, std::size_t b) { return gain[a] > gain[b]; });
  std::vector<bool> taken(gain.size(), false);
  auto next_by_gain = by_gain.cbegin(), next_spread = spread.cbegin();
  for (std::size_t i = 0; i < spread.size(); ++i) {
    auto& next = i % blocks_a_spread == blocks_a_spread - 1 ? next_spread : next_by_gain;
    while (taken[*next]) ++next;
    taken[*next] = true;
    rest[static_cast<std::ptrdiff_t>(i)] = *next++;
  }
}

bool FinalBlocks::work(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
                       const std::stop_token& stop) {
  bool finished_picture = false;
  while (clock.wait_while_paused(stop)) {
    const std::size_t index = next_++;
    if (index >= order_.size()) break;
    const bool keep = bytes_ < most_bytes_;
    Started started = start(render, order_[index], keep, tiles, clock, stop, finished_picture);
    if (started.rest && !keep) finished_picture |= finish(render, started, tiles, clock, stop);
    if (stop.stop_requested()) return false;
    const std::lock_guard lock(mutex_);
    if (started.rest) {
      bytes_ += started.rest->bytes() + started.unlit.size() * sizeof(started.unlit[0]);
      started_.push_back(std::move(started));
    }
    --left_to_start_;
    changed_.notify_all();
  }
  if (stop.stop_requested()) return false;
  return finish_all(render, tiles, clock, stop) || finished_picture;
}

// Waits until all blocks are started, then finishes them by falling gain.
bool FinalBlocks::finish_all(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
                             const std::stop_token& stop) {
  {
    std::unique_lock lock(mutex_);
    if (!changed_.wait(lock, stop, [&] { return left_to_start_ == 0; })) return false;
    if (!std::exchange(sorted_, true))
      std::sort(started_.begin(), started_.end(), [](const Started& a, const Started& b) {
        return a.gain != b.gain ? a.gain > b.gain : a.block < b.block;
      });
  }
  bool finished_picture = false;
  while (clock.wait_while_paused(stop)) {
    const std::size_t index = next_started_++;
    if (index >= started_.size()) break;
    finished_picture |= finish(render, started_[index], tiles, clock, stop);
  }
  return finished_picture;
}

}  // namespace asos
