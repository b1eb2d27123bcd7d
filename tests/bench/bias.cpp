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
#include "tests/bench/benchmarks.h"
#include "tests/bench/scene_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace asos::bench::bias {

struct Row {
  std::string name;
  KnownError error;
  Bias bias;
};

Result<Row> measure(const SceneSet& set, int max_level, const NamedScene& named) {
  auto snapshot = set.open(named.source);
  if (!snapshot) return unexpected(snapshot.error());
  const auto reference = set.reference_of(named.name, *snapshot);
  if (!reference) return unexpected(reference.error());
  snapshot->settings.method = Method::asos;
  snapshot->settings.asos.max_level = max_level;
  const Film film = render_to_end(*snapshot).film;
  return Row{named.name, reference->error_of(film), reference->bias_of(film)};
}

void print_row(const SceneSet& set, const Row& row) {
  const auto width = static_cast<std::size_t>(set.size.width);
  const Bias& bias = row.bias;
  fmt::print("{:<30}{:>11.2e}{:>10.1e}{:>2}{:>9.2e}{:>11.2e} at {},{}\n", row.name, bias.off,
             bias.stray, row.error.known ? "" : "<", row.error.rmse, bias.worst,
             bias.worst_pixel % width, bias.worst_pixel / width);
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  SceneSet set{.size = {80, 45}, .samples = 4096};
  int max_level = 4;
  Options options("ASOS at a great depth beside many Sobol samples: bias and RMSE of every scene");
  set.add_to(options);
  options.number("--max", max_level, 0, 8, "MAX of ASOS");
  options.number("--samples", set.samples, 2, 1 << 20, "of the reference");
  options.flag("--sky-shadows", set.sky_shadows, "surfaces hide the sky from each other");
  if (const auto code = options.end(argc, argv)) return *code;

  fmt::print("{}x{}, MAX {} less {} samples\n{:<30}{:>11}{:>10}{:>11}{:>11}\n", set.size.width,
             set.size.height, max_level, set.samples, "", "bias", "+-", "RMSE", "worst");
  std::vector<Row> rows;
  const int code = set.measure([&](const NamedScene& scene) {
    return measure(set, max_level, scene).map([&](const Row& row) {
      print_row(set, row);
      rows.push_back(row);
    });
  });
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.error.rmse > b.error.rmse; });
  fmt::print("\nworst first\n");
  for (const Row& row : rows) print_row(set, row);
  return code;
}

}  // namespace asos::bench::bias
