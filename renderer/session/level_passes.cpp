#include "renderer/session/level_passes.h"

#include "renderer/session/timed_block.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace asos {
namespace {

// So few blocks of a picture tell which passes it is worth.
constexpr std::size_t most_sample_blocks = 48;
// One block in so many is among them, so that they take little of the time; a picture of fewer
// is finished before anybody looks.
constexpr std::size_t blocks_a_sample = 32;

RenderSettings at_level(RenderSettings settings, int level) {
  settings.asos.max_level = level;
  return settings;
}

}  // namespace

LevelPasses::LevelPasses(const PlannedRender& render) : final_(render.plan.blocks.size(), false) {
  if (!render.snapshot.progressive) return;
  possible_ = possible_levels(render.snapshot.settings);
  if (possible_.empty()) return;
  const std::size_t blocks = render.plan.blocks.size();
  const std::size_t count = std::min(most_sample_blocks, blocks / blocks_a_sample);
  sample_blocks_ = render.plan.spread_blocks();
  sample_blocks_.resize(count);
  if (render.snapshot.settings.asos.max_level > deepest_tried_level) return;
  for (const std::size_t block : sample_blocks_) final_[block] = true;
}

void LevelPasses::work(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
                       const std::stop_token& stop) {
  if (sample_blocks_.empty()) return;
  work_sample(render, tiles, clock, stop);
  if (!wait_for_choice(stop)) return;
  for (const int level : levels_) {
    work_level(render, level, next_group_[static_cast<std::size_t>(level)], tiles, clock, stop);
  }
}

// Each block of the sample at all levels, from the lowest on.
void LevelPasses::work_sample(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
                              const std::stop_token& stop) {
  const RenderSettings& settings = render.snapshot.settings;
  RenderSettings one_sample = settings;
  one_sample.method = Method::uniform;
  one_sample.sampling.spp = 1;
  while (clock.wait_while_paused(stop)) {
    const std::size_t index = next_sample_++;
    if (index >= sample_blocks_.size()) return;
    const std::size_t block = sample_blocks_[index];
    Sample of_block;
    of_block.centres = work_of(timed_block(render, one_sample, block, stop).result.statistics);
    const int max_level = settings.asos.max_level;
    for (int level = 0; level <= std::min(max_level, deepest_tried_level); ++level) {
      TimedBlock done = timed_block(render, at_level(settings, level), block, stop);
      if (stop.stop_requested()) return;
      of_block.work[static_cast<std::size_t>(level)] = work_of(done.result.statistics);
      const bool final = level == max_level;
      clock.count_block(final ? CostForecast::final_pass : static_cast<std::size_t>(level), block,
                        done.seconds);
      // It is never the picture's last one.
      if (final) (void)tiles.finish_block(block, std::move(done.result));
    }
    add_to_sample(of_block, max_level, clock);
  }
}

// Work comes in whole units, whose sum does not depend on the order.
void LevelPasses::add_to_sample(const Sample& block, int max_level, RunClock& clock) {
  {
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < block.work.size(); ++i) sample_.work[i] += block.work[i];
    sample_.centres += block.centres;
    if (++sample_.finished < sample_blocks_.size()) return;
    // What was tried is done, whichever are chosen.
    const double share = static_cast<double>(sample_.finished) / static_cast<double>(final_.size());
    const double tried = share * std::accumulate(sample_.work.begin(), sample_.work.end(), 0.0);
    const double final_work = extrapolate_work(sample_.work, max_level);
    levels_ = choose_levels(possible_, sample_.work, sample_.centres + tried, final_work);
    clock.set_levels(levels_);
    has_chosen_ = true;
  }
  chosen_.notify_all();
}

// False once a stop is requested.
bool LevelPasses::wait_for_choice(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  return chosen_.wait(lock, stop, [this] { return has_chosen_; });
}

void LevelPasses::work_level(const PlannedRender& render, int level, std::atomic<std::size_t>& next,
                             TileCollector& tiles, RunClock& clock, const std::stop_token& stop) {
  const RenderSettings settings = at_level(render.snapshot.settings, level);
  const WorkPlan& plan = render.plan;
  while (clock.wait_while_paused(stop)) {
    const std::size_t index = next++;
    if (index >= plan.groups.size()) return;
    const std::size_t at = render.group_order[index];
    const BlockGroup& group = plan.groups[at];
    FinishedTile tile = tiles.blank_tile(group);
    for (std::size_t block = group.first_block; block < group.first_block + group.block_count;
         ++block) {
      if (final_[block]) continue;
      const TimedBlock done = timed_block(render, settings, block, stop);
      if (stop.stop_requested()) return;
      clock.count_block(static_cast<std::size_t>(level), block, done.seconds);
      copy_pixels(done.result.tile, tile);
    }
    tiles.publish_coarse(at, pass_of_level(level), std::move(tile));
  }
}

}  // namespace asos
