// How many times longer ASOS takes than one stochastic sample a pixel, scene by scene, with the
// time to load and to build beside it. The two methods take turns within one process, so that what
// else the machine does meets both; the median counts.
//
//   bench_render_ratios [--csv] [--size WxH] [--threads N] [--max K] [--runs N] [SCENE...]
//
// Without scenes: the built-in ones that the limits are set for.

#include "renderer/scene/load.h"
#include "renderer/session/render_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace asos;

struct Settings {
  bool csv = false;
  int width = 1280;
  int height = 720;
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
  double sample_seconds = 0.0;  ///< stochastic, one sample a pixel
  double asos_seconds = 0.0;

  [[nodiscard]] double ratio() const { return asos_seconds / sample_seconds; }
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Result<Row> measure(const std::string& source, const Settings& settings) {
  const auto started = std::chrono::steady_clock::now();
  const Result<Scene> scene = load_scene(source);
  if (!scene) return tl::unexpected(scene.error());
  const double load_seconds = seconds_since(started);
  const auto loaded = std::chrono::steady_clock::now();
  const auto prepared = prepare(*scene);
  if (!prepared) return tl::unexpected(prepared.error());
  const double build_seconds = seconds_since(loaded);

  const World& world = (*prepared)->world;
  Snapshot snapshot;
  snapshot.scene = *prepared;
  snapshot.progressive = false;
  snapshot.camera =
      world.cameras.empty()
          ? default_camera(world, static_cast<double>(settings.width) / settings.height)
          : world.cameras.front();
  snapshot.settings.width = settings.width;
  snapshot.settings.height = settings.height;
  snapshot.settings.threads = settings.threads;
  snapshot.settings.max_level = settings.max_level;
  snapshot.settings.spp = 1;

  std::vector<double> sample_seconds;
  std::vector<double> asos_seconds;
  for (int run = 0; run < settings.runs; ++run) {
    snapshot.settings.method = Method::stochastic;
    sample_seconds.push_back(render_to_end(snapshot).seconds);
    snapshot.settings.method = Method::asos;
    asos_seconds.push_back(render_to_end(snapshot).seconds);
  }
  return Row{source,        world.triangles.size(), load_seconds,
             build_seconds, median(sample_seconds), median(asos_seconds)};
}

void print_heading(const Settings& settings) {
  if (settings.csv) {
    fmt::print("scene,triangles,load_seconds,build_seconds,sample_seconds,asos_seconds,ratio\n");
    return;
  }
  fmt::print("{}x{}, {} threads, MAX {}, median of {}\n", settings.width, settings.height,
             settings.threads, settings.max_level, settings.runs);
  fmt::print("{:>10} {:>8} {:>8} {:>9} {:>9} {:>6}  scene\n", "triangles", "load s", "build s",
             "1 spp s", "asos s", "ratio");
}

void print_row(const Settings& settings, const Row& row) {
  if (settings.csv)
    fmt::print("\"{}\",{},{:.4f},{:.4f},{:.4f},{:.4f},{:.3f}\n", row.scene, row.triangles,
               row.load_seconds, row.build_seconds, row.sample_seconds, row.asos_seconds,
               row.ratio());
  else
    fmt::print("{:>10} {:>8.3f} {:>8.3f} {:>9.4f} {:>9.4f} {:>6.2f}  {}\n", row.triangles,
               row.load_seconds, row.build_seconds, row.sample_seconds, row.asos_seconds,
               row.ratio(), row.scene);
  std::fflush(stdout);
}

// Whether the words make sense.
bool read_words(int argc, char** argv, Settings& settings) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto number = [&](int& value) {
      return ++i < argc && std::sscanf(argv[i], "%d", &value) == 1 && value > 0;
    };
    if (word == "--csv") {
      settings.csv = true;
    } else if (word == "--size") {
      if (++i >= argc || std::sscanf(argv[i], "%dx%d", &settings.width, &settings.height) != 2)
        return false;
    } else if (word == "--threads") {
      if (!number(settings.threads)) return false;
    } else if (word == "--max") {
      if (!number(settings.max_level)) return false;
    } else if (word == "--runs") {
      if (!number(settings.runs)) return false;
    } else if (word.starts_with("--")) {
      return false;
    } else {
      settings.scenes.push_back(word);
    }
  }
  if (settings.scenes.empty())
    settings.scenes = {"builtin:boxes", "builtin:mixed", "builtin:dense"};
  return settings.width > 0 && settings.height > 0 &&
         settings.max_level <= RenderSettings::max_level_limit;
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  if (!read_words(argc, argv, settings)) {
    fmt::print(stderr,
               "usage: bench_render_ratios [--csv] [--size WxH] [--threads N] [--max K] [--runs N] "
               "[SCENE...]\n");
    return 2;
  }
  print_heading(settings);
  for (const std::string& scene : settings.scenes) {
    const auto row = measure(scene, settings);
    if (!row) {
      fmt::print(stderr, "bench_render_ratios: {}\n", row.error().message());
      return 1;
    }
    print_row(settings, *row);
  }
  return 0;
}
