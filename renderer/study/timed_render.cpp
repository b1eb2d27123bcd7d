#include "renderer/study/timed_render.h"

#include <chrono>
#include <condition_variable>
#include <ctime>
#include <fstream>
#include <mutex>
#include <numeric>
#include <string>
#include <utility>

namespace asos {
namespace {

constexpr std::chrono::milliseconds patience{20};

// Linux keeps the largest resident set of a process and forgets it on request (proc(5)).
void forget_peak_memory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

double peak_memory_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word != "VmHWM:") continue;
    double kib = 0.0;
    status >> kib;
    return kib * 1024.0 / 1e6;
  }
  return 0.0;
}

}  // namespace

std::optional<TimedRender> timed_render(Snapshot snapshot, const std::function<bool()>& stop) {
  std::mutex mutex;
  std::condition_variable knock;
  bool waiting = false;
  snapshot.progressive = false;
  RenderSession session([&] {
    const std::lock_guard lock(mutex);
    waiting = true;
    knock.notify_one();
  });

  forget_peak_memory();
  const std::clock_t start = std::clock();
  session.restart(std::move(snapshot));
  TimedRender result;
  const PixelRect visible = session.visible();
  result.film = Film(visible.width, visible.height);
  for (bool finished = false; !finished;) {
    if (stop && stop()) {
      session.cancel();
      return std::nullopt;
    }
    // Asked before the tiles are taken: what was published up to the end is then among them.
    finished = session.progress().finished;
    for (const FinishedTile& tile : session.take_finished()) result.film.put(tile);
    if (finished) break;
    std::unique_lock lock(mutex);
    knock.wait_for(lock, patience, [&] { return waiting; });
    waiting = false;
  }
  session.wait();
  result.wall_seconds = session.progress().seconds;
  result.cpu_seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  result.memory_mb = peak_memory_mb();
  result.statistics = session.statistics();
  return result;
}

std::uint64_t pyrays_of(const RenderStatistics& statistics) {
  const auto& pyrays = statistics.pyrays_by_level;
  return std::accumulate(pyrays.begin(), pyrays.end(), std::uint64_t{0});
}

std::uint64_t rays_of(const RenderStatistics& statistics) {
  return statistics.rays();
}

}  // namespace asos
