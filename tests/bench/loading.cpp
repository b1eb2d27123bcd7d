// Time and memory of opening a scene, step by step: reading the file; building everything that rays
// need; the first coarse picture (one sample per block) and one sample per pixel, which a window
// shows meanwhile; searching the edges, which ASOS needs. Prints wall-clock seconds since the
// start, and CPU time of all threads.
//
//   bench loading [SCENE] [--size WxH] [--threads N]

#include "app/large_blocks.h"
#include "renderer/gltf/load.h"
#include "renderer/session/render_session.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <sys/resource.h>
#include <thread>

namespace asos::bench::loading {

using Clock = std::chrono::steady_clock;

struct Settings {
  std::string scene = "builtin:dense";
  PictureSize size{1280, 720};
  int threads = 2;
};

class Steps {
 public:
  void print(const char* step, std::size_t triangles = 0) const {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](timeval t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    const double peak_bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
    fmt::print("{:<22} {:8.2f} s   processors {:8.2f} s   peak {:7.0f} MB", step,
               seconds_since(start_), seconds(usage.ru_utime) + seconds(usage.ru_stime),
               1e-6 * peak_bytes);
    if (triangles > 0)
      fmt::print("   {:6.1f} bytes a triangle", peak_bytes / static_cast<double>(triangles));
    fmt::print("\n");
    std::fflush(stdout);
  }

 private:
  Clock::time_point start_ = Clock::now();
};

void wait_for(const RenderSession& session, Reached::Pass pass) {
  while (session.reached().pass < pass) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

int measure(const Settings& settings) {
  const Steps steps;
  auto scene = load_scene(settings.scene);
  if (!scene) return fail(scene.error());
  steps.print("read");
  const auto prepared = prepare(*scene);
  if (!prepared) return fail(prepared.error());
  *scene = Scene{};  // as the program does
  const std::size_t triangles = (*prepared)->world().triangles.size();
  steps.print("rays", triangles);

  RenderSession session;
  Snapshot snapshot = snapshot_of(*prepared, settings.size.width, settings.size.height);
  snapshot.settings.threads = settings.threads;
  snapshot.progressive = true;
  session.restart(snapshot);
  wait_for(session, Reached::Pass::blocks);
  steps.print("first coarse picture", triangles);
  wait_for(session, Reached::Pass::samples);
  steps.print("one sample a pixel", triangles);
  if (const auto whole = with_boundaries(*prepared); !whole) return fail(whole.error());
  steps.print("boundaries", triangles);
  session.cancel();
  const auto each = [&](double bytes) {
    return bytes / static_cast<double>(std::max<std::size_t>(1, triangles));
  };
  const FeatureSet& features = (*prepared)->features();
  fmt::print(
      "{} triangles, {:.1f} bytes each are kept: rays {:.1f}, boundaries {:.1f}, of these "
      "edges {:.1f} and nodes {:.1f}\n",
      triangles, each((*prepared)->geometry->memory_mb() * 1024.0 * 1024.0),
      each(static_cast<double>((*prepared)->rays().memory_bytes())),
      each(static_cast<double>(features.memory_bytes())),
      each(static_cast<double>(features.edges().size_bytes())),
      each(static_cast<double>(features.nodes().size_bytes())));
  return 0;
}

int run(int argc, char** argv) {
  Settings settings;
  Options options("How long a scene takes to open, and how much memory.");
  options.text("SCENE", settings.scene);
  options.size(settings.size);
  options.number("--threads", settings.threads, 1, 1024);
  if (const auto code = options.end(argc, argv)) return *code;
  give_back_large_blocks();  // as the program does
  return measure(settings);
}

}  // namespace asos::bench::loading
