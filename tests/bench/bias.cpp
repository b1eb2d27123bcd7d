// Bias of ASOS, the error that remains at any run time: its picture at a large MAX against many
// Sobol samples, for every scene. One line per scene, worst first: the error of the picture's mean,
// with its standard deviation due to the reference's noise; the RMSE without that noise
// (HalvedReference), with a < if it is below the measurable minimum; the worst pixel.
//
//   bench bias [--size WxH] [--max N] [--samples N] [--sky-shadows] [--cache DIR] [SCENE...]
//
// Errors are of linear radiance clipped to 0..1, over all pixels and channels. --cache keeps the
// references in a folder for later calls.

#include "renderer/comparison/method.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/halved_reference.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace asos::bench::bias {

struct Settings {
  PictureSize size{80, 45};
  int max_level = 4;
  int samples = 4096;
  bool sky_shadows = false;
  std::string cache;  // empty: none
  std::vector<std::string> scenes;
};

struct Row {
  std::string name;
  KnownError error;
  Bias bias;
};

Result<HalvedReference> reference_of(const Settings& settings, const std::string& name,
                                     const Snapshot& snapshot) {
  if (settings.cache.empty()) return HalvedReference::rendered(snapshot, settings.samples);
  return HalvedReference::kept(
      kept_path(settings.cache, name, settings.size, settings.samples, settings.sky_shadows),
      snapshot, settings.samples);
}

Result<Row> measure(const Settings& settings, const NamedScene& named) {
  const auto scene = open_scene(named.source);
  if (!scene) return unexpected(scene.error());
  Snapshot snapshot = snapshot_of(*scene, settings.size.width, settings.size.height);
  snapshot.settings.shadow.sky = settings.sky_shadows;
  const auto reference = reference_of(settings, named.name, snapshot);
  if (!reference) return unexpected(reference.error());
  snapshot.settings.method = Method::asos;
  snapshot.settings.asos.max_level = settings.max_level;
  const Film film = render_to_end(snapshot).film;
  return Row{named.name, reference->error_of(film), reference->bias_of(film)};
}

void print_row(const Settings& settings, const Row& row) {
  const auto width = static_cast<std::size_t>(settings.size.width);
  const Bias& bias = row.bias;
  fmt::print("{:<30}{:>11.2e}{:>10.1e}{:>2}{:>9.2e}{:>11.2e} at {},{}\n", row.name, bias.off,
             bias.stray, row.error.known ? "" : "<", row.error.rmse, bias.worst,
             bias.worst_pixel % width, bias.worst_pixel / width);
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  Settings settings;
  Options options("ASOS at a great depth beside many Sobol samples: bias and RMSE of every scene");
  options.size(settings.size);
  options.number("--max", settings.max_level, 0, 8, "MAX of ASOS");
  options.number("--samples", settings.samples, 2, 1 << 20, "of the reference");
  options.flag("--sky-shadows", settings.sky_shadows, "surfaces hide the sky from each other");
  options.parsed("--cache", "folder of references", [&](const std::string& text) -> Result<void> {
    settings.cache = text;
    return {};
  });
  options.texts("SCENE", settings.scenes);
  if (const auto code = options.end(argc, argv)) return *code;

  std::error_code failed;
  if (!settings.cache.empty()) std::filesystem::create_directories(settings.cache, failed);
  if (failed) return fail({settings.cache, failed.message()});
  fmt::print("{}x{}, MAX {} less {} samples\n{:<30}{:>11}{:>10}{:>11}{:>11}\n", settings.size.width,
             settings.size.height, settings.max_level, settings.samples, "", "bias", "+-", "RMSE",
             "worst");
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
                   [](const Row& a, const Row& b) { return a.error.rmse > b.error.rmse; });
  fmt::print("\nworst first\n");
  for (const Row& row : rows) print_row(settings, row);
  return code;
}

}  // namespace asos::bench::bias
