// What no time takes away of ASOS's error: its picture at a great depth beside one of many Sobol
// samples, over every scene. A line a scene, worst first: the mean difference of the pictures, and
// the root of the mean squared one, which holds the reference's own noise.
//
//   bench_bias [--size WxH] [--max N] [--samples N] [--sky-shadows] [SCENE...]
//
// Differences are of linear radiance clipped to 0..1, as other benchmarks have them, over all
// pixels and channels. The reference's noise is told by its two halves: the samples of two seeds.

#include "renderer/comparison/method.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace asos;
using namespace asos::bench;

struct Settings {
  PictureSize size{80, 45};
  int max_level = 4;
  int samples = 4096;
  bool sky_shadows = false;
  std::vector<std::string> scenes;
};

struct Row {
  std::string name;
  double bias = 0.0;
  double rmse = 0.0;
  double noise = 0.0;  ///< of the reference
  double worst = 0.0;  ///< of a pixel's mean over the channels
  std::size_t worst_at = 0;
};

double displayed(float radiance) {
  return std::clamp(static_cast<double>(radiance), 0.0, 1.0);
}

Row compared(const std::string& name, const Film& asos, const Film& one, const Film& other) {
  Row row{name};
  const std::size_t pixels = asos.radiance.size();
  for (std::size_t i = 0; i < pixels; ++i) {
    double off = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double a = displayed(one.radiance[i][c]), b = displayed(other.radiance[i][c]);
      const double difference = displayed(asos.radiance[i][c]) - 0.5 * (a + b);
      off += difference / 3.0;
      row.rmse += difference * difference;
      row.noise += 0.25 * (a - b) * (a - b);
    }
    row.bias += off;
    if (std::abs(off) > std::abs(row.worst)) {
      row.worst = off;
      row.worst_at = i;
    }
  }
  const auto count = static_cast<double>(pixels);
  row.bias /= count;
  row.rmse = std::sqrt(row.rmse / (3.0 * count));
  row.noise = std::sqrt(row.noise / (3.0 * count));
  return row;
}

Result<Row> measure(const Settings& settings, const NamedScene& named) {
  const auto scene = open_scene(named.source);
  if (!scene) return unexpected(scene.error());
  Snapshot snapshot = snapshot_of(*scene, settings.size.width, settings.size.height);
  snapshot.settings.shadow.sky = settings.sky_shadows;
  snapshot.settings.method = Method::sobol;
  snapshot.settings.sampling.spp = settings.samples / 2;
  snapshot.settings.seed = 12345;
  const Film one = render_to_end(snapshot).film;
  snapshot.settings.seed = 54321;
  const Film other = render_to_end(snapshot).film;
  snapshot.settings.method = Method::asos;
  snapshot.settings.seed = 0;
  snapshot.settings.asos.max_level = settings.max_level;
  return compared(named.name, render_to_end(snapshot).film, one, other);
}

void print_row(const Settings& settings, const Row& row) {
  const auto width = static_cast<std::size_t>(settings.size.width);
  fmt::print("{:<30}{:>11.2e}{:>11.2e}{:>11.2e}{:>11.2e} at {},{}\n", row.name, row.bias, row.rmse,
             row.noise, row.worst, row.worst_at % width, row.worst_at / width);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  Options options("ASOS at a great depth beside many Sobol samples: bias and RMSE of every scene");
  options.size(settings.size);
  options.number("--max", settings.max_level, 0, 8, "MAX of ASOS");
  options.number("--samples", settings.samples, 2, 1 << 20, "of the reference");
  options.flag("--sky-shadows", settings.sky_shadows, "surfaces hide the sky from each other");
  options.texts("SCENE", settings.scenes);
  if (const auto code = options.end(argc, argv)) return *code;

  fmt::print("{}x{}, MAX {} less {} samples\n{:<30}{:>11}{:>11}{:>11}{:>11}\n", settings.size.width,
             settings.size.height, settings.max_level, settings.samples, "", "bias", "RMSE",
             "its noise", "worst");
  std::vector<Row> rows;
  int code = 0;
  for (const NamedScene& scene : chosen_scenes(settings.scenes)) {
    const auto row = measure(settings, scene);
    if (!row) {
      code = fail(row.error());
      continue;
    }
    print_row(settings, *row);
    rows.push_back(*row);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.rmse > b.rmse; });
  fmt::print("\nworst first\n");
  for (const Row& row : rows) print_row(settings, row);
  return code;
}
