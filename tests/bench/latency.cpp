// Latency of the window's picture: from a camera change to the first coarse picture of the whole
// view, and from a change until no worker uses the old picture. Changes occur during a render, at
// times spread over its first half second. The limit for the first coarse picture is 50 ms. Then
// EPS is dragged, with a limit of 100 ms for its split map.
//
//   bench latency [SCENE] [--size WxH] [--changes N] [--threads N]

#include "renderer/session/tile_bell.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"
#include "ui/previewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

namespace asos::bench::latency {

using Clock = std::chrono::steady_clock;
using ui::Previewer;

struct Settings {
  std::string scene = "builtin:mixed";
  PictureSize size{1280, 720};
  int changes = 100;
  int threads = 1;
};

/// Waits as the window's event loop does.
void wait(TileBell& bell) {
  bell.wait(std::chrono::milliseconds(5));
  bell.quiet();
}

/// CPU time of all threads together, which excludes other programs.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void print(const char* what, std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const auto at = [&](double share) {
    const auto last = static_cast<double>(seconds.size() - 1);
    return 1e3 * seconds[static_cast<std::size_t>(share * last + 0.5)];
  };
  fmt::print("{:<42} median {:7.2f} ms   p99 {:7.2f} ms   most {:7.2f} ms\n", what, at(0.5),
             at(0.99), at(1.0));
}

/// Time in seconds from changes of EPS to their predicted split maps, as if a slider were dragged.
std::vector<double> drag_eps(Previewer& previewer, Clock::time_point start, int changes) {
  std::vector<double> seconds;
  for (int i = 0; i < changes; ++i) {
    const Clock::time_point next = Clock::now() + std::chrono::milliseconds(16);
    previewer.edits().settings().asos.eps = 1.0 / (8.0 + 10.0 * i);
    const std::uint64_t before = previewer.render().map_revision();
    const Clock::time_point changed = Clock::now();
    while (previewer.render().map_revision() == before) previewer.update(seconds_since(start));
    seconds.push_back(seconds_since(changed));
    std::this_thread::sleep_until(next);
  }
  return seconds;
}

int measure(const Settings& settings) {
  TileBell bell;
  RenderSettings render;
  render.threads = settings.threads;
  Previewer previewer({{}, [&bell] { bell.ring(); }}, render);
  const Clock::time_point start = Clock::now();
  previewer.viewpoint().set_picture_size(settings.size.width, settings.size.height, 0.0);
  previewer.scene().open(settings.scene);
  while (previewer.render().restarts() == 0) {
    wait(bell);
    previewer.update(seconds_since(start));
    if (previewer.scene().error()) return fail(*previewer.scene().error());
  }

  std::vector<double> coarse, coarse_cpu, cancel;
  for (int i = 0; i < settings.changes; ++i) {
    // Lets the previous render run for 150 to 495 ms.
    const Clock::time_point resume = Clock::now() + std::chrono::milliseconds(150 + 5 * (i % 70));
    while (Clock::now() < resume) {
      wait(bell);
      previewer.update(seconds_since(start));
    }
    previewer.viewpoint().camera().orbit(0.01, 0.0);
    const Clock::time_point changed = Clock::now();
    const double cpu = cpu_seconds();
    const std::uint64_t restarts = previewer.render().restarts();
    previewer.update(seconds_since(start));
    if (previewer.render().restarts() == restarts)
      return fail({"latency", "the change had to wait"});
    cancel.push_back(seconds_since(changed));
    while (previewer.render().first_picture_pending()) {
      wait(bell);
      previewer.update(seconds_since(start));
    }
    coarse.push_back(seconds_since(changed));
    coarse_cpu.push_back(cpu_seconds() - cpu);
  }
  const std::vector<double> map = drag_eps(previewer, start, settings.changes);
  fmt::print("{} at {}x{}, {} worker{}, {} changes\n", settings.scene, settings.size.width,
             settings.size.height, settings.threads, settings.threads == 1 ? "" : "s",
             settings.changes);
  print("change to first coarse picture", coarse);
  print("   of processor time, all threads", coarse_cpu);
  print("change to the old render's end, and restart", cancel);
  print("change of EPS to its split map", map);
  constexpr double limit_seconds = 0.1;
  fmt::print("   the longest is {:.3f} of the limit of 100 ms\n",
             *std::max_element(map.begin(), map.end()) / limit_seconds);
  return 0;
}

int run(int argc, char** argv) {
  Settings settings;
  Options options("How long the window's picture takes to follow a change.");
  options.text("SCENE", settings.scene);
  options.size(settings.size);
  options.number("--changes", settings.changes, 1, 100000);
  options.number("--threads", settings.threads, 1, 1024);
  if (const auto code = options.end(argc, argv)) return *code;
  return measure(settings);
}

}  // namespace asos::bench::latency
