#include "renderer/session/render_run.h"

#include "renderer/comparison/method.h"

#include <algorithm>
#include <ctime>
#include <utility>

namespace asos {
namespace {

// The calling thread's own time: what others do meanwhile does not count.
double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

RenderRun::RenderRun(Snapshot snapshot, std::function<void()> on_tiles)
    : render_(std::move(snapshot)),
      tiles_(render_.plan, std::move(on_tiles)),
      clock_(render_.plan.blocks.size()) {}

void RenderRun::work(const std::stop_token& stop) {
  if (render_.snapshot.progressive) coarse_.work(render_, tiles_, stop);
  work_final(stop);
}

void RenderRun::work_final(const std::stop_token& stop) {
  const auto& [snapshot, view, plan] = render_;
  clock_.begin_final_pass();
  while (clock_.wait_while_paused(stop)) {
    const std::size_t index = next_final_++;
    if (index >= plan.blocks.size()) return;
    const double start = thread_seconds();
    BlockResult result =
        render_block(*snapshot.scene, view, snapshot.settings, plan.blocks[index].rect, stop);
    if (stop.stop_requested()) return;
    const std::size_t pixels = result.tile.radiance.size();
    const double each =
        (thread_seconds() - start) / static_cast<double>(std::max<std::size_t>(pixels, 1));
    result.tile.seconds.assign(pixels, static_cast<float>(each));

    // The picture is complete once its last tile is published, and its user is told so.
    clock_.count_block();
    if (!tiles_.finish_block(index, std::move(result))) continue;
    clock_.complete();
    tiles_.notify();
  }
}

}  // namespace asos
