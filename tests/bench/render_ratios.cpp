// Time of ASOS relative to one stochastic sample per pixel, scene by scene, in wall-clock and CPU
// time. The two alternate within one process, so that other load affects both; medians count. Also
// prints the times to load and to build the scene, and the time from the start of loading to the
// window's first pictures: one sample per block, and the first tile with one sample per pixel.
//
//   bench render-ratios [--csv] [--size WxH] [--threads N] [--max K] [--runs N] [SCENE...]
//
// Without scenes: the built-in ones that have limits.

#include "renderer/gltf/load.h"
#include "renderer/session/render_session.h"
#include "renderer/session/tile_bell.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::render_ratios {

struct Settings {
  bool csv = false;
  PictureSize size{1280, 720};
  int threads = 2;
  int max_level = 3;
  int runs = 5;
  std::vector<std::string> scenes;
};

struct Row {
  std::string scene;
  std::size_t triangles = 0;
  double load_seconds = 0.0;
  double build_seconds = 0.0;
  double first_picture_seconds = 0.0;  ///< since the start of loading
  double first_pixels_seconds = 0.0;   ///< the first tile with one sample per pixel
  Seconds sample;                      ///< stochastic, one sample per pixel
  Seconds asos;
};

/// Renders a scene as a window would, until the first tile after the coarse pass.
void measure_first_picture(Snapshot snapshot, std::chrono::steady_clock::time_point start,
                           Row& row) {
  TileBell bell;
  RenderSession session([&] { bell.ring(); });
  snapshot.settings.method = Method::asos;
  snapshot.progressive = true;
  session.restart(snapshot);
  int missing = snapshot.settings.width * snapshot.settings.height;  // pixels without any colour
  std::set<std::pair<int, int>> seen;  // the corners of tiles, which are the same in each pass
  while (missing > 0 || row.first_pixels_seconds == 0.0) {
    bell.wait(std::chrono::milliseconds(20));
    bell.quiet();
    for (const FinishedTile& tile : session.take_finished()) {
      if (seen.insert({tile.rect.x, tile.rect.y}).second) {
        missing -= tile.rect.width * tile.rect.height;
        if (missing == 0) row.first_picture_seconds = seconds_since(start);
      } else if (row.first_pixels_seconds == 0.0) {
        row.first_pixels_seconds = seconds_since(start);
      }
    }
  }
}

Result<Row> measure(const std::string& source, const Settings& settings) {
  Row row;
  row.scene = source;
  const auto started = std::chrono::steady_clock::now();
  const Result<Scene> scene = load_scene(source);
  if (!scene) return tl::unexpected(scene.error());
  row.load_seconds = seconds_since(started);
  const auto prepared = prepare(*scene).and_then(as_rendered);
  if (!prepared) return tl::unexpected(prepared.error());
  row.triangles = (*prepared)->world().triangles.size();

  Snapshot snapshot = snapshot_of(*prepared, settings.size.width, settings.size.height);
  snapshot.settings.threads = settings.threads;
  snapshot.settings.asos.max_level = settings.max_level;
  snapshot.settings.sampling.spp = 1;
  measure_first_picture(snapshot, started, row);
  if (const auto whole = with_boundaries(*prepared); !whole) return tl::unexpected(whole.error());
  row.build_seconds = seconds_since(started) - row.load_seconds;
  Times sample;
  Times asos;
  for (int run = 0; run < settings.runs; ++run) {
    snapshot.settings.method = Method::stochastic;
    (void)sample.render(snapshot);
    snapshot.settings.method = Method::asos;
    (void)asos.render(snapshot);
  }
  row.sample = sample.medians();
  row.asos = asos.medians();
  return row;
}

void print_heading(const Settings& settings) {
  if (settings.csv) {
    fmt::print(
        "scene,triangles,load_seconds,build_seconds,first_picture_seconds,first_pixels_seconds,"
        "sample_seconds,asos_seconds,ratio,sample_cpu_seconds,asos_cpu_seconds,cpu_ratio\n");
    return;
  }
  fmt::print("{}x{}, {} threads, MAX {}, median of {}\n", settings.size.width, settings.size.height,
             settings.threads, settings.max_level, settings.runs);
  fmt::print("{:>9} {:>7} {:>7} {:>9} {:>8} | {:>8} {:>8} {:>6} | {:>9} {:>8} {:>6}\n", "triangles",
             "load s", "build s", "picture s", "pixels s", "1 spp s", "asos s", "ratio",
             "1 spp cpu", "asos cpu", "ratio");
}

void print_row(const Settings& settings, const Row& row) {
  const double ratio = row.asos.wall / row.sample.wall;
  const double cpu_ratio = row.asos.cpu / row.sample.cpu;
  if (settings.csv)
    fmt::print("\"{}\",{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.3f},{:.4f},{:.4f},{:.3f}\n",
               row.scene, row.triangles, row.load_seconds, row.build_seconds,
               row.first_picture_seconds, row.first_pixels_seconds, row.sample.wall, row.asos.wall,
               ratio, row.sample.cpu, row.asos.cpu, cpu_ratio);
  else
    fmt::print(
        "{}\n{:>9} {:>7.3f} {:>7.3f} {:>9.3f} {:>8.3f} | {:>8.4f} {:>8.4f} {:>6.2f} | {:>9.4f} "
        "{:>8.4f} {:>6.2f}\n",
        row.scene, row.triangles, row.load_seconds, row.build_seconds, row.first_picture_seconds,
        row.first_pixels_seconds, row.sample.wall, row.asos.wall, ratio, row.sample.cpu,
        row.asos.cpu, cpu_ratio);
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  Settings settings;
  Options options("Time over that of one stochastic sample a pixel");
  options.flag("--csv", settings.csv);
  options.size(settings.size);
  options.number("--threads", settings.threads, 1, 1024);
  options.number("--max", settings.max_level, 1, max_level_limit);
  options.number("--runs", settings.runs, 1, 99);
  options.texts("SCENE", settings.scenes);
  if (const auto code = options.end(argc, argv)) return *code;
  if (settings.scenes.empty())
    settings.scenes = {"builtin:boxes", "builtin:mixed", "builtin:dense"};
  print_heading(settings);
  for (const std::string& scene : settings.scenes) {
    const auto row = measure(scene, settings);
    if (!row) return fail(row.error());
    print_row(settings, *row);
  }
  return 0;
}

}  // namespace asos::bench::render_ratios
