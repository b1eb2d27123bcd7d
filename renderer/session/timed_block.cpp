#include "renderer/session/timed_block.h"

#include "renderer/render_block.h"

#include <algorithm>
#include <ctime>

namespace asos {
namespace {

// The calling thread's own time: what others do meanwhile does not count.
double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

TimedBlock timed_block(const PlannedRender& render, const RenderSettings& settings,
                       std::size_t block, const std::stop_token& stop) {
  const double start = thread_seconds();
  TimedBlock done;
  done.result = render_block(*render.snapshot.scene, render.view, settings,
                             render.plan.blocks[block].rect, stop);
  done.seconds = thread_seconds() - start;
  const std::size_t pixels = done.result.tile.radiance.size();
  const double each = done.seconds / static_cast<double>(std::max<std::size_t>(pixels, 1));
  done.result.tile.seconds.assign(pixels, static_cast<float>(each));
  return done;
}

}  // namespace asos
