#include "renderer/study/progress_curve.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>
#include <utility>

namespace asos {
namespace {

// Time between two checks of a render, in seconds.
constexpr double shortest_wait = 1e-4;
constexpr double longest_wait = 1e-2;
// CPU time before which no picture is kept, in seconds. The system adds the time of running threads
// late: in 2 % of 400 runs, 40 rays took less than 1e-6 s.
constexpr double first_picture = 1e-4;

double clock_seconds(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Returns the CPU time of all threads except the calling one.
double others_seconds() {
  return clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - clock_seconds(CLOCK_THREAD_CPUTIME_ID);
}

Film radiance_of(const Film& film) {
  Film copy;
  copy.width = film.width;
  copy.height = film.height;
  copy.radiance = film.radiance;
  return copy;
}

void wait_until(double next, double now) {
  const double seconds = std::clamp(0.1 * (next - now), shortest_wait, longest_wait);
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace

RecordedRender watch_render(const Snapshot& snapshot, double factor,
                            const std::function<bool()>& stop) {
  RecordedRender watched;
  RenderSession session;
  const double start = others_seconds();
  double next = first_picture;
  session.restart(snapshot);
  Film film(session.visible().width, session.visible().height);
  while (!watched.finished && !(stop && stop())) {
    // Query this before taking the tiles, so that they include the last ones of a finished picture.
    const Progress progress = session.progress();
    const double now = others_seconds() - start;
    if (progress.failed) break;
    if (!progress.finished && now < next) {
      wait_until(next, now);
      continue;
    }
    const Reached reached = session.reached();
    for (const FinishedTile& tile : session.take_finished()) film.put(tile);
    watched.finished = progress.finished;
    // Workers may have finished tiles since `now`: the time counts once they are taken.
    const double taken = others_seconds() - start;
    // All pixels may be final shortly before the render reports that it is finished.
    const bool between =
        reached.pass != Reached::Pass::nothing && reached.pass != Reached::Pass::final_pixels;
    if (progress.finished || between) {
      watched.pictures.push_back({taken, radiance_of(film), reached, progress});
      next = factor * taken;
    } else {
      wait_until(now, now);
    }
  }
  session.cancel();
  return watched;
}

}  // namespace asos
