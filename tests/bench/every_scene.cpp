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
#include "renderer/film/image_io.h"
#include "renderer/settings/value_text.h"
#include "renderer/study/ladders.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/measured_ladder.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::every_scene {

struct Settings {
  PictureSize size{240, 135};
  std::vector<int> levels{2, 3};
  int reference = 1024;
  int threads = 2;
  int runs = 1;
  std::string cache = ".";
  std::string only = "both";
  bool keep = false;
  bool fresh = false;
  bool adaptive = false;
  bool sky_shadows = false;
  std::vector<std::string> scenes;
};

/// Measurements of one scene.
struct Row {
  std::string name;
  std::vector<std::vector<CurvePoint>> rivals;  ///< for each of rival_names; empty: not measured
  std::vector<CurvePoint> asos;                 ///< in the order of Settings::levels
  std::vector<bool> known;                      ///< whether their errors are certain
};

/// Ratio of a rival's time to that of ASOS at the same error.
struct Ratio {
  double value = 0.0;
  bool beyond = false;   ///< past the ladder's ends
  bool unknown = false;  ///< the error is within the reference's noise
};

constexpr int sobol_spp[] = {1, 4, 16, 64, 256};
constexpr std::size_t one_sample = 0, sixteen_samples = 2;  // steps of that ladder
constexpr const char* rival_names[] = {"sobol", "sobol-adaptive"};

std::string cache_path(const Settings& settings, const std::string& name) {
  return kept_path(settings.cache, name, settings.size, settings.reference, settings.sky_shadows);
}

Result<HalvedReference> reference_of(const Settings& settings, const std::string& name,
                                     const Snapshot& snapshot) {
  if (!settings.keep) return HalvedReference::rendered(snapshot, settings.reference);
  return HalvedReference::kept(cache_path(settings, name), snapshot, settings.reference);
}

MeasuredLadder ladder_of_sobol(RenderSettings settings) {
  MeasuredLadder ladder;
  settings.method = Method::sobol;
  for (const int spp : sobol_spp) {
    settings.sampling.spp = spp;
    ladder.add(std::to_string(spp), settings);
  }
  return ladder;
}

Result<MeasuredLadder> ladder_of_adaptive(const RenderSettings& settings) {
  return ladder_of(row_of(Method::sobol_adaptive).name, settings)
      .map([](const std::vector<LadderStep>& rungs) {
        MeasuredLadder ladder;
        for (const LadderStep& rung : rungs)
          ladder.add(eps_text(rung.settings.asos.eps), rung.settings);
        return ladder;
      });
}

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

Result<Row> measure(const Settings& settings, const NamedScene& named) {
  const auto scene = open_scene(named.source);
  if (!scene) return unexpected(scene.error());
  Snapshot snapshot = snapshot_of(*scene, settings.size.width, settings.size.height);
  snapshot.settings.shadow.sky = settings.sky_shadows;
  snapshot.settings.threads = settings.threads;
  const auto reference = reference_of(settings, named.name, snapshot);
  if (!reference) return unexpected(reference.error());

  // Ladders in the cache are not rendered.
  std::vector<MeasuredLadder> rivals{ladder_of_sobol(snapshot.settings)};
  if (settings.adaptive) {
    const auto adaptive = ladder_of_adaptive(snapshot.settings);
    if (!adaptive) return unexpected(adaptive.error());
    rivals.push_back(*adaptive);
  }
  MeasuredLadder asos = ladder_of_asos(snapshot.settings, settings.levels);
  std::vector<MeasuredLadder*> rendered;
  std::vector<std::pair<std::string, const MeasuredLadder*>> written;
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const std::string path =
        fmt::format("{}-{}.txt", cache_path(settings, named.name), rival_names[i]);
    if (settings.keep && !settings.fresh && rivals[i].read(path)) continue;
    if (settings.only == "asos") continue;
    rendered.push_back(&rivals[i]);
    if (settings.keep) written.emplace_back(path, &rivals[i]);
  }
  if (settings.only != "sobol") rendered.push_back(&asos);
  for (int run = 0; run < settings.runs; ++run)
    for (MeasuredLadder* ladder : rendered) ladder->render(snapshot, *reference);

  for (const auto& [path, ladder] : written)
    if (const auto done = ladder->write(path); !done) return unexpected(done.error());
  Row row{named.name, {}, asos.points(), asos.known()};
  for (const MeasuredLadder& rival : rivals) row.rivals.push_back(rival.points());
  return row;
}

std::optional<Ratio> ratio_of(const Row& row, std::size_t rival, std::size_t level) {
  if (row.asos.empty()) return std::nullopt;
  const CurvePoint asos = row.asos[level];
  const std::vector<CurvePoint>& ladder = row.rivals[rival];
  auto seconds = seconds_at_error(ladder, asos.error);
  if (!seconds) return std::nullopt;
  // An adaptive rival cannot take fewer samples than in its first step.
  if (rival > 0 && asos.error > ladder.front().error)
    seconds = CurveValue{ladder.front().seconds, true};
  return Ratio{seconds->value / asos.seconds, seconds->beyond, !row.known[level]};
}

std::size_t rival_count(const Settings& settings) {
  return settings.adaptive ? 2 : 1;
}

void print_heading(const Settings& settings) {
  fmt::print("{}x{}, EPS 1/256, reference {} samples; times are processor seconds\n{:<28}",
             settings.size.width, settings.size.height, settings.reference, "");
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
  for (std::size_t level = 0; level < row.asos.size(); ++level) {
    fmt::print("{:>11.2e}{:>9.3f}", row.asos[level].error, row.asos[level].seconds);
    for (std::size_t rival = 0; rival < rival_count(settings); ++rival) {
      if (const auto ratio = ratio_of(row, rival, level))
        fmt::print("{:>9}{}{}", shown(ratio->value), ratio->beyond ? 'e' : ' ',
                   ratio->unknown ? '*' : ' ');
      else
        fmt::print("{:>9}  ", "-");
    }
  }
  const std::vector<CurvePoint>& sobol = row.rivals.front();
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
  constexpr std::size_t shown = 8;
  std::vector<std::pair<double, std::string>> ratios;
  std::vector<double> values;
  double seconds = 0.0;
  for (const Row& row : rows) {
    if (!row.asos.empty()) seconds += row.asos[level].seconds;
    if (const auto ratio = ratio_of(row, rival, level)) {
      ratios.emplace_back(ratio->value, row.name);
      values.push_back(ratio->value);
    }
  }
  if (ratios.empty()) return;
  std::sort(ratios.begin(), ratios.end());
  const auto lost = std::count_if(values.begin(), values.end(), [](double x) { return x < 1.0; });
  fmt::print("MAX {} beside {}: median {:.2f}, {} of {} below 1, {:.2f} s in all; worst:",
             settings.levels[level], rival_names[rival], median(values), lost, values.size(),
             seconds);
  for (std::size_t k = 0; k < std::min(shown, ratios.size()); ++k)
    fmt::print("{} {} {:.2f}", k > 0 ? "," : "", ratios[k].second, ratios[k].first);
  fmt::print("\n");
}

/// A ratio of times for one scene.
struct TimeRatio {
  double value = 0.0;
  std::string name;
};

void print_times(const char* what, std::vector<TimeRatio> ratios) {
  if (ratios.empty()) return;
  std::sort(ratios.begin(), ratios.end(),
            [](const TimeRatio& a, const TimeRatio& b) { return a.value > b.value; });
  std::vector<double> values;
  for (const TimeRatio& ratio : ratios) values.push_back(ratio.value);
  constexpr std::size_t shown = 5;
  fmt::print("{}: median {:.2f}; largest:", what, median(values));
  for (std::size_t k = 0; k < std::min(shown, ratios.size()); ++k)
    fmt::print("{} {} {:.2f}", k > 0 ? "," : "", ratios[k].name, ratios[k].value);
  fmt::print("\n");
}

/// Prints the time of each MAX relative to one and sixteen samples, and its time and error relative
/// to the last MAX.
void print_depths(const Settings& settings, const std::vector<Row>& rows) {
  const auto print = [&](const std::string& what, const auto& ratio) {
    std::vector<TimeRatio> ratios;
    for (const Row& row : rows)
      if (!row.asos.empty() && !row.rivals.front().empty())
        ratios.push_back({ratio(row), row.name});
    print_times(what.c_str(), std::move(ratios));
  };
  for (std::size_t level = 0; level < settings.levels.size(); ++level) {
    const int max = settings.levels[level];
    for (const std::size_t step : {one_sample, sixteen_samples})
      print(fmt::format("time at MAX {} over sobol {}", max, sobol_spp[step]), [&](const Row& row) {
        return row.asos[level].seconds / row.rivals.front()[step].seconds;
      });
    if (level + 1 == settings.levels.size()) continue;
    const int last = settings.levels.back();
    print(fmt::format("time at MAX {} over MAX {}", max, last),
          [&](const Row& row) { return row.asos[level].seconds / row.asos.back().seconds; });
    print(fmt::format("error at MAX {} over MAX {}", max, last),
          [&](const Row& row) { return row.asos[level].error / row.asos.back().error; });
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
  Options options("Time at equal error over every scene, ASOS beside Sobol sampling");
  options.size(settings.size);
  options.parsed("--levels", "MAX of the runs of ASOS, as in 2,3",
                 [&](const std::string& text) { return read_levels(text, settings.levels); });
  options.number("--reference", settings.reference, 256, 65536, "samples");
  options.number("--runs", settings.runs, 1, 99);
  options.number("--threads", settings.threads, 1, 1024);
  options.parsed("--cache", "folder of references and ladders",
                 [&](const std::string& text) -> Result<void> {
                   settings.cache = text;
                   settings.keep = true;
                   return {};
                 });
  options.choice("--only", settings.only, {"both", "asos", "sobol"});
  options.flag("--fresh", settings.fresh, "measure the ladder anew though it is in the cache");
  options.flag("--adaptive", settings.adaptive, "beside sobol-adaptive, too");
  options.flag("--sky-shadows", settings.sky_shadows, "surfaces hide the sky from each other");
  options.texts("SCENE", settings.scenes);
  if (const auto code = options.end(argc, argv)) return *code;

  std::error_code failed;
  if (settings.keep) std::filesystem::create_directories(settings.cache, failed);
  if (failed) return fail({settings.cache, failed.message()});
  print_heading(settings);
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
  for (std::size_t rival = 0; rival < rival_count(settings); ++rival)
    for (std::size_t level = 0; level < settings.levels.size(); ++level)
      print_summary(settings, rows, rival, level);
  print_depths(settings, rows);
  return code;
}

}  // namespace asos::bench::every_scene
