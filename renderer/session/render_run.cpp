#include "renderer/session/render_run.h"

#include "renderer/comparison/method.h"
#include "renderer/session/timed_block.h"

#include <utility>

namespace asos {

RenderRun::RenderRun(Snapshot snapshot, std::function<void()> on_tiles)
    : render_(std::move(snapshot)),
      tiles_(render_.plan, std::move(on_tiles)),
      clock_(render_.plan.blocks.size()),
      levels_(render_) {}

void RenderRun::work(const std::stop_token& stop) {
  if (render_.snapshot.progressive) coarse_.work(render_, tiles_, stop);
  if (!wait_for_boundaries(stop)) return;
  clock_.begin_forecast();
  levels_.work(render_, tiles_, clock_, stop);
  work_final(stop);
}

bool RenderRun::wait_for_boundaries(const std::stop_token& stop) {
  if (!needs_boundaries(render_.snapshot.settings.method)) return true;
  const BoundaryFeatures& boundaries = render_.snapshot.scene->geometry->boundaries;
  const bool known = boundaries.wait(stop);
  if (boundaries.failed()) clock_.fail();
  return known;
}

void RenderRun::work_final(const std::stop_token& stop) {
  const std::size_t count = render_.order.size();
  while (clock_.wait_while_paused(stop)) {
    const std::size_t index = next_final_++;
    if (index >= count) return;
    const std::size_t block = render_.order[index];
    if (levels_.is_final(block)) continue;
    TimedBlock done = timed_block(render_, render_.snapshot.settings, block, stop);
    if (stop.stop_requested()) return;

    // The picture is complete once its last tile is published, and its user is told so.
    clock_.count_block(CostForecast::final_pass, block, done.seconds);
    if (!tiles_.finish_block(block, std::move(done.result))) continue;
    clock_.complete();
    tiles_.notify();
  }
}

}  // namespace asos
