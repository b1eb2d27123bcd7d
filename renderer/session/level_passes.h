#pragma once

#include "renderer/session/level_choice.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/tile_collector.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stop_token>
#include <vector>

namespace asos {

/// The passes between one sample a pixel and the final one: all of the picture at a low MAX, then
/// at the next. Which of them are worth their work is decided by what a few blocks need that are
/// spread over the picture, and that are rendered to the end at once where MAX is low. The decision
/// counts rays and never looks at a clock, so that what is shown is the same each time. Any number
/// of threads.
///
/// No pixel of a pass is taken over into the next. Blocks that no boundary crosses mostly stay as
/// they are at a higher MAX, but they are 1 to 8 % of the work at 320x180 and 9 to 18 % at
/// 1280x720, and that they stay so is not known beforehand: the tolerance depends on MAX.
class LevelPasses {
 public:
  explicit LevelPasses(const PlannedRender& render);

  /// Renders into `tiles` until no group is left or `stop` is requested.
  void work(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
            const std::stop_token& stop);
  /// Whether a block was among the few and is final.
  [[nodiscard]] bool is_final(std::size_t block) const { return final_[block]; }

 private:
  struct Sample {
    WorkByLevel work{};
    double centres = 0.0;
    std::size_t finished = 0;  // blocks
  };

  void work_sample(const PlannedRender& render, TileCollector& tiles, RunClock& clock,
                   const std::stop_token& stop);
  void add_to_sample(const Sample& block, int max_level, RunClock& clock);
  [[nodiscard]] bool wait_for_choice(const std::stop_token& stop);
  void work_level(const PlannedRender& render, int level, std::atomic<std::size_t>& next,
                  TileCollector& tiles, RunClock& clock, const std::stop_token& stop);

  std::vector<int> possible_;
  std::vector<std::size_t> sample_blocks_;
  std::vector<bool> final_;  // by block; written before there are workers
  std::atomic<std::size_t> next_sample_{0};
  std::array<std::atomic<std::size_t>, max_level_limit> next_group_{};

  std::mutex mutex_;
  std::condition_variable_any chosen_;
  Sample sample_;
  bool has_chosen_ = false;
  std::vector<int> levels_;  // once it has
};

}  // namespace asos
