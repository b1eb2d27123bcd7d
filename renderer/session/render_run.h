#pragma once

#include "renderer/session/coarse_passes.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/render_session.h"
#include "renderer/session/render_steps.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/sample_rounds.h"
#include "renderer/session/tile_collector.h"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

namespace asos {

/// The render of one snapshot: the remaining work, the finished tiles, and the speed. Workers call
/// `work` and share nothing else. A session creates one for each restart and drops it after its
/// workers have ended, so that no tile can outlive its snapshot.
class RenderRun {
 public:
  RenderRun(Snapshot snapshot, std::function<void()> on_tiles);

  /// Takes work until none is left or `stop` is requested. Any number of threads.
  void work(const std::stop_token& stop);

  [[nodiscard]] PixelRect visible() const { return render_.plan.visible; }
  [[nodiscard]] std::vector<FinishedTile> take_finished() { return tiles_.take_finished(); }
  [[nodiscard]] Progress progress() const { return clock_.progress(); }
  [[nodiscard]] Reached reached() const;
  [[nodiscard]] RenderStatistics statistics() const { return tiles_.statistics(); }
  /// Pauses all but the coarse passes after the current pieces of work, and resumes them.
  void pause() { clock_.pause(); }
  void resume() { clock_.resume(); }
  /// Called after the workers have ended: stops the clock.
  void close() { clock_.close(); }

 private:
  void work_rounds(std::size_t first, const std::stop_token& stop);
  void count(bool finished_picture);

  const PlannedRender render_;
  TileCollector tiles_;
  CoarsePasses coarse_;
  SampleRounds samples_;
  RenderSteps steps_;
  RunClock clock_;
};

}  // namespace asos
