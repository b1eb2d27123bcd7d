#include "renderer/study/timed_render.h"

#include "renderer/session/film_render.h"

#include <ctime>
#include <fstream>
#include <numeric>
#include <string>
#include <utility>

namespace asos {
namespace {

// Linux records the peak resident set of a process and resets it on request (proc(5)).
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
  FilmRender render;
  forget_peak_memory();
  const std::clock_t start = std::clock();
  std::optional<RenderResult> rendered =
      render.render(std::move(snapshot), [&] { return !stop || !stop(); }, {});
  if (!rendered) return std::nullopt;
  TimedRender result;
  result.film = std::move(rendered->film);
  result.statistics = std::move(rendered->statistics);
  result.wall_seconds = rendered->seconds;
  result.cpu_seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  result.memory_mb = peak_memory_mb();
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
