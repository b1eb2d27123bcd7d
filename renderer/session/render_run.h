#pragma once

#include "renderer/session/coarse_passes.h"
#include "renderer/session/level_passes.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/render_session.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/tile_collector.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

namespace asos {

/// One snapshot's render: the work that is left, what is finished, and how fast it goes. Workers
/// call `work` and share nothing else. A session makes one for each restart and drops it once its
/// workers have ended, so that no tile can outlive its snapshot.
class RenderRun {
 public:
  RenderRun(Snapshot snapshot, std::function<void()> on_tiles);

  /// Takes work until none is left or `stop` is requested. Any number of threads.
  void work(const std::stop_token& stop);

  [[nodiscard]] PixelRect visible() const { return render_.plan.visible; }
  [[nodiscard]] std::vector<FinishedTile> take_finished() { return tiles_.take_finished(); }
  [[nodiscard]] Progress progress() const { return clock_.progress(); }
  [[nodiscard]] Reached reached() const { return tiles_.reached(); }
  /// See TileCollector.
  void publish_unfinished() { tiles_.publish_unfinished(); }
  [[nodiscard]] RenderStatistics statistics() const { return tiles_.statistics(); }
  /// Lets the final pass rest, after the blocks that are being worked on, and go on.
  void pause() { clock_.pause(); }
  void resume() { clock_.resume(); }
  /// Called once the workers have ended: time stands still from here.
  void close() { clock_.close(); }

 private:
  /// False: the final pass cannot go on, for there are no boundaries, or `stop` is requested.
  [[nodiscard]] bool wait_for_boundaries(const std::stop_token& stop);
  void work_final(const std::stop_token& stop);

  const PlannedRender render_;
  TileCollector tiles_;
  RunClock clock_;
  CoarsePasses coarse_;
  LevelPasses levels_;
  std::atomic<std::size_t> next_final_{0};  // blocks
};

}  // namespace asos
