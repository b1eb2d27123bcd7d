// Time at equal error for every scene: ASOS at a few values of MAX against a ladder of Sobol
// sampling. One line per scene, then the median and the worst. A change to ASOS is evaluated on all
// scenes, because it may speed up some and slow down others.
//
//   bench every-scene [--size WxH] [--levels 2,3] [--reference N] [--runs N] [--cache DIR]
//                     [--only asos|sobol] [--adaptive] [--fresh] [--sky-shadows] [--threads N]
//                     [SCENE...]
//
// SCENE is a name from the table, "builtin" for all built-in scenes, or an argument of `asos
// render`; without any, all models in $ASOS_SHARED/scenes. Errors are RMSE of linear radiance
// clipped to 0..1 against --reference Sobol samples of two other seeds, without their noise
// (HalvedReference). Times are CPU times, medians of alternating runs. "x" is the ratio of Sobol
// sampling's time to that of ASOS at the same error, interpolated on its ladder (log-log): `e`
// marks an extrapolation beyond the ladder, `*` an uncertain error of ASOS, where x is a lower
// bound. Scenes with features that are far brighter than white and smaller than a pixel need
// references of thousands of samples: the clipped halves of smaller ones agree by chance.
//
// --adaptive adds a second rival, sobol-adaptive with its ladder of EPS (renderer/study/ladders.h).
// If ASOS's error exceeds that of its first step, the time of that step counts, marked `e`.
//
// --cache keeps references and the ladder's times and errors in a folder, so that the next call
// renders only ASOS; --fresh measures the ladder again, as on another machine. --only asos never
// renders the ladder, --only sobol fills the cache.

#include "renderer/comparison/method.h"
#include "renderer/settings/value_text.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/measured_ladder.h"
#include "tests/bench/scene_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::every_scene {

struct Settings {
  SceneSet set{.size = {240, 135}, .samples = 1024};
  std::vector<int> levels{2, 3};
  int threads = 2;
  int runs = 1;
  std::string only = "both";
  bool fresh = false;
  bool adaptive = false;
};

/// Measurements of one scene; ladders that were not measured have no points.
struct Row {
  std::string name;
  std::vector<MeasuredLadder> rivals;
  MeasuredLadder asos;  ///< in the order of Settings::levels
};

/// Ratio of a rival's time to that of ASOS at the same error.
struct Ratio {
  double value = 0.0;
  bool beyond = false;   ///< past the ladder's ends
  bool unknown = false;  ///< the error is within the reference's noise
};

constexpr std::array rivals{Method::sobol, Method::sobol_adaptive};

// Steps of the ladder of Sobol sampling, by their samples.
constexpr std::array<std::pair<int, std::size_t>, 2> compared_steps{{{1, 0}, {16, 2}}};

MeasuredLadder ladder_of_asos(RenderSettings settings, const std::vector<int>& levels) {
  MeasuredLadder ladder;
  settings.method = Method::asos;
  settings.asos.eps = 1.0 / 256.0;
  for (const int level : levels) {
    settings.asos.max_level = level;
    ladder.add(std::to_string(level), settings);
  }
  return ladder;
}

std::size_t rival_count(const Settings& settings) {
  return settings.adaptive ? 2 : 1;
}

Result<Row> measure(const Settings& settings, const NamedScene& named) {
  const SceneSet& set = settings.set;
  auto snapshot = set.open(named.source);
  if (!snapshot) return unexpected(snapshot.error());
  snapshot->settings.threads = settings.threads;
  const auto reference = set.reference_of(named.name, *snapshot);
  if (!reference) return unexpected(reference.error());

  Row row{named.name, {}, ladder_of_asos(snapshot->settings, settings.levels)};
  for (std::size_t i = 0; i < rival_count(settings); ++i)
    row.rivals.push_back(MeasuredLadder::of_study(rivals[i], snapshot->settings));
  // Ladders in the cache are not rendered.
  std::vector<MeasuredLadder*> rendered;
  std::vector<std::pair<std::string, const MeasuredLadder*>> written;
  for (std::size_t i = 0; i < row.rivals.size(); ++i) {
    const std::string path =
        set.cache ? fmt::format("{}-{}.txt", set.path_of(named.name), row_of(rivals[i]).name) : "";
    if (set.cache && !settings.fresh && row.rivals[i].read(path)) continue;
    if (settings.only == "asos") continue;
    rendered.push_back(&row.rivals[i]);
    if (set.cache) written.emplace_back(path, &row.rivals[i]);
  }
  if (settings.only != "sobol") rendered.push_back(&row.asos);
  for (int run = 0; run < settings.runs; ++run)
    for (MeasuredLadder* ladder : rendered)
      ladder->render(*snapshot, [&](MeasuredStep& step, const Film& film) {
        step.error = reference->error_of(film);
      });
  for (const auto& [path, ladder] : written)
    if (const auto done = ladder->write(path); !done) return unexpected(done.error());
  return row;
}

std::optional<Ratio> ratio_of(const Row& row, std::size_t rival, std::size_t level) {
  if (row.asos.points().empty()) return std::nullopt;
  const CurvePoint asos = row.asos.points()[level];
  const std::vector<CurvePoint>& ladder = row.rivals[rival].points();
  auto seconds = seconds_at_error(ladder, asos.error);
  if (!seconds) return std::nullopt;
  // An adaptive rival cannot take fewer samples than in its first step.
  if (rival > 0 && asos.error > ladder.front().error)
    seconds = CurveValue{ladder.front().seconds, true};
  return Ratio{seconds->value / asos.seconds, seconds->beyond,
               !row.asos.steps()[level].error.known};
}

void print_heading(const Settings& settings) {
  fmt::print("{}x{}, EPS 1/256, reference {} samples; times are processor seconds\n{:<28}",
             settings.set.size.width, settings.set.size.height, settings.set.samples, "");
  if (settings.only != "sobol") {
    for (const int level : settings.levels) {
      fmt::print("{:>11}{:>9}", fmt::format("MAX {} RMSE", level), "s");
      fmt::print("{:>9}  ", "x");
      if (settings.adaptive) fmt::print("{:>9}  ", "adaptive");
    }
  }
  fmt::print("{:>11}{:>9}\n", "sobol RMSE", "s (256)");
}

/// Extrapolated ratios may be arbitrarily large.
std::string shown(double ratio) {
  return ratio < 1e5 ? fmt::format("{:.2f}", ratio) : fmt::format("{:.1e}", ratio);
}

void print_row(const Settings& settings, const Row& row) {
  fmt::print("{:<28}", row.name);
  const std::vector<CurvePoint>& asos = row.asos.points();
  for (std::size_t level = 0; level < asos.size(); ++level) {
    fmt::print("{:>11.2e}{:>9.3f}", asos[level].error, asos[level].seconds);
    for (std::size_t rival = 0; rival < rival_count(settings); ++rival) {
      if (const auto ratio = ratio_of(row, rival, level))
        fmt::print("{:>9}{}{}", shown(ratio->value), ratio->beyond ? 'e' : ' ',
                   ratio->unknown ? '*' : ' ');
      else
        fmt::print("{:>9}  ", "-");
    }
  }
  const std::vector<CurvePoint>& sobol = row.rivals.front().points();
  if (sobol.empty())
    fmt::print("{:>11}{:>9}\n", "-", "-");
  else
    fmt::print("{:>11.2e}{:>9.3f}\n", sobol.back().error, sobol.back().seconds);
  std::fflush(stdout);
}

/// For one MAX and one rival: the median over all scenes, the number of losses, and the worst
/// scenes.
void print_summary(const Settings& settings, const std::vector<Row>& rows, std::size_t rival,
                   std::size_t level) {
  std::vector<SceneValue> ratios;
  double seconds = 0.0;
  for (const Row& row : rows) {
    if (!row.asos.points().empty()) seconds += row.asos.points()[level].seconds;
    if (const auto ratio = ratio_of(row, rival, level)) ratios.push_back({ratio->value, row.name});
  }
  const auto lost = std::count_if(ratios.begin(), ratios.end(),
                                  [](const SceneValue& ratio) { return ratio.value < 1.0; });
  const std::string then =
      fmt::format(", {} of {} below 1, {:.2f} s in all; worst:", lost, ratios.size(), seconds);
  print_median(fmt::format("MAX {} beside {}", settings.levels[level], row_of(rivals[rival]).name),
               std::move(ratios), then, 8, false);
}

/// Prints the time of each MAX relative to one and sixteen samples, and its time and error relative
/// to the last MAX.
void print_depths(const Settings& settings, const std::vector<Row>& rows) {
  const auto print = [&](const std::string& what, const auto& ratio) {
    std::vector<SceneValue> ratios;
    for (const Row& row : rows)
      if (!row.asos.points().empty() && !row.rivals.front().points().empty())
        ratios.push_back({ratio(row.asos.points(), row.rivals.front().points()), row.name});
    print_median(what, std::move(ratios), "; largest:");
  };
  using Points = std::vector<CurvePoint>;
  for (std::size_t level = 0; level < settings.levels.size(); ++level) {
    const int max = settings.levels[level];
    for (const auto& [samples, step] : compared_steps)
      print(fmt::format("time at MAX {} over sobol {}", max, samples),
            [level, at = step](const Points& asos, const Points& sobol) {
              return asos[level].seconds / sobol[at].seconds;
            });
    if (level + 1 == settings.levels.size()) continue;
    const int last = settings.levels.back();
    print(fmt::format("time at MAX {} over MAX {}", max, last),
          [level](const Points& asos, const Points& /*sobol*/) {
            return asos[level].seconds / asos.back().seconds;
          });
    print(fmt::format("error at MAX {} over MAX {}", max, last),
          [level](const Points& asos, const Points& /*sobol*/) {
            return asos[level].error / asos.back().error;
          });
  }
}

Result<void> read_levels(const std::string& text, std::vector<int>& levels) {
  levels.clear();
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto level = parse_whole(part, 0, 8);
    if (!level) return unexpected(level.error());
    levels.push_back(*level);
  }
  if (levels.empty()) return unexpected(Error{text, "names no level"});
  return {};
}

int run(int argc, char** argv) {
  Settings settings;
  SceneSet& set = settings.set;
  Options options("Time at equal error over every scene, ASOS beside Sobol sampling");
  set.add_to(options, "folder of references and ladders");
  options.parsed("--levels", "MAX of the runs of ASOS, as in 2,3",
                 [&](const std::string& text) { return read_levels(text, settings.levels); });
  options.number("--reference", set.samples, 256, 65536, "samples");
  options.number("--runs", settings.runs, 1, 99);
  options.number("--threads", settings.threads, 1, 1024);
  options.choice("--only", settings.only, {"both", "asos", "sobol"});
  options.flag("--fresh", settings.fresh, "measure the ladder anew though it is in the cache");
  options.flag("--adaptive", settings.adaptive, "beside sobol-adaptive, too");
  options.flag("--sky-shadows", set.sky_shadows, "surfaces hide the sky from each other");
  if (const auto code = options.end(argc, argv)) return *code;

  print_heading(settings);
  std::vector<Row> rows;
  const int code = set.measure([&](const NamedScene& scene) {
    return measure(settings, scene).map([&](Row row) {
      print_row(settings, row);
      rows.push_back(std::move(row));
    });
  });
  for (std::size_t rival = 0; rival < rival_count(settings); ++rival)
    for (std::size_t level = 0; level < settings.levels.size(); ++level)
      print_summary(settings, rows, rival, level);
  print_depths(settings, rows);
  return code;
}

}  // namespace asos::bench::every_scene
