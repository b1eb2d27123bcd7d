#pragma once

#include "renderer/comparison/method.h"
#include "renderer/session/render_session.h"
#include "renderer/session/work_plan.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <vector>

namespace asos {

/// One snapshot's render: the work that is left, what is finished, and how fast it goes. Workers
/// call `work` and share nothing else. A session makes one for each restart and drops it once its
/// workers have ended, so that no tile can outlive its snapshot.
class RenderRun {
 public:
  RenderRun(Snapshot snapshot, const std::function<void()>& on_tiles);

  /// Takes work until none is left or `stop` is requested. Any number of threads.
  void work(const std::stop_token& stop);

  [[nodiscard]] PixelRect visible() const { return plan_.visible; }
  [[nodiscard]] std::vector<FinishedTile> take_finished();
  [[nodiscard]] Progress progress() const;
  [[nodiscard]] RenderStatistics statistics() const;
  /// Lets the final pass rest, after the blocks that are being worked on, and go on.
  void pause();
  void resume();
  /// Called once the workers have ended: time stands still from here.
  void close();

 private:
  using Clock = std::chrono::steady_clock;
  enum Pass { nothing, coarse, centres, final_pixels };

  /// A group's state; all of it under mutex_.
  struct GroupState {
    Pass published = nothing;
    std::size_t finished_blocks = 0;
    double unresolved_area = 0.0;
    std::vector<BlockResult> blocks;  // of the final pass, until all are there
  };
  struct Pace {
    Clock::time_point time;
    std::size_t blocks;
  };

  void work_coarse(const std::stop_token& stop);
  void work_centres(const std::stop_token& stop);
  void work_final(const std::stop_token& stop);
  /// False once `stop` is requested.
  [[nodiscard]] bool wait_while_paused(const std::stop_token& stop);
  void finish_block(std::size_t index, BlockResult&& result);
  [[nodiscard]] FinishedTile tile_of(const BlockGroup& group) const;
  void copy_into(FinishedTile& tile, const FinishedTile& block) const;
  void publish(std::size_t group, Pass pass, FinishedTile&& tile);
  [[nodiscard]] double seconds_left(Clock::time_point now) const;

  const Snapshot snapshot_;
  const View view_;
  const WorkPlan plan_;
  const std::function<void()>& on_tiles_;
  const Clock::time_point start_ = Clock::now();

  std::atomic<std::size_t> next_coarse_{0};  // groups
  std::atomic<std::size_t> next_centres_{0};
  std::atomic<std::size_t> next_final_{0};  // blocks

  mutable std::mutex mutex_;
  std::condition_variable_any resumed_;
  std::atomic<bool> paused_ = false;  // changed under the mutex
  Clock::time_point paused_since_;
  Clock::duration rested_{0};  // before
  std::vector<GroupState> groups_;
  std::vector<FinishedTile> finished_;
  RenderStatistics totals_;
  std::size_t finished_blocks_ = 0;
  std::deque<Pace> pace_;
  bool complete_ = false;
  bool closed_ = false;
  Clock::time_point end_;
};

}  // namespace asos
