// Time at equal error over every scene: ASOS at a few depths beside a ladder of Sobol sampling, a
// line a scene, then the median and the worst. A change to ASOS is judged by all of them, for one
// that makes some scenes quicker may make others slower.
//
//   bench_every_scene [--size WxH] [--levels 2,3] [--reference N] [--runs N] [--cache DIR]
//                     [--only asos|sobol] [--fresh] [SCENE...]
//
// SCENE is a name from the table or anything that `asos render` opens; without any, all built-in
// scenes and all models in $ASOS_SHARED/scenes. Errors are RMSE of linear radiance clipped to 0..1
// against --reference Sobol samples of another seed; times are processor time, medians of runs that
// take turns. "x" is how much longer Sobol sampling takes to ASOS's error, read off its ladder with
// both axes logarithmic: `e` where that lies beyond the ladder's ends, `*` where the error is below
// twice the reference's own noise and so is hardly known.
//
// --cache keeps references and the ladder's times and errors in a folder, so that the next call
// renders ASOS only; --fresh measures the ladder anew, as on another machine. --only asos never
// renders the ladder, --only sobol fills the cache.

#include "app/values.h"
#include "renderer/film/image_io.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace asos;
using namespace asos::bench;

struct Settings {
  PictureSize size{240, 135};
  std::vector<int> levels{2, 3};
  int reference = 1024;
  int runs = 1;
  std::string cache = ".";
  std::string only = "both";
  bool keep = false;
  bool fresh = false;
  std::vector<std::string> scenes;
};

struct NamedScene {
  std::string name;
  std::string source;
};

/// One setting of a method, measured.
struct Rung {
  RenderSettings settings;
  Times times;
  CurvePoint point;
};

/// A scene's figures.
struct Row {
  std::string name;
  std::vector<CurvePoint> ladder;  ///< of Sobol sampling; empty: not measured
  std::vector<CurvePoint> asos;    ///< in the order of Settings::levels
};

/// How much longer Sobol sampling takes to ASOS's error.
struct Ratio {
  double value = 0.0;
  bool beyond = false;   ///< past the ladder's ends
  bool unknown = false;  ///< the error is within twice the reference's noise
};

constexpr int ladder_spp[] = {4, 16, 64, 256};

std::vector<NamedScene> all_scenes() {
  std::vector<NamedScene> scenes;
  for (const BuiltinScene& scene : builtin_scenes())
    scenes.push_back({scene.name, "builtin:" + scene.name});
  const char* shared = std::getenv("ASOS_SHARED");
  if (!shared) return scenes;
  const auto first_model = static_cast<std::ptrdiff_t>(scenes.size());
  std::error_code unreadable;
  for (const auto& file : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(shared) / "scenes", unreadable)) {
    const std::string ending = file.path().extension().string();
    if (ending != ".glb" && ending != ".gltf") continue;
    scenes.push_back({file.path().parent_path().filename().string(), file.path().string()});
  }
  std::sort(scenes.begin() + first_model, scenes.end(),
            [](const NamedScene& a, const NamedScene& b) { return a.name < b.name; });
  return scenes;
}

std::vector<NamedScene> chosen_scenes(const std::vector<std::string>& chosen) {
  const std::vector<NamedScene> all = all_scenes();
  if (chosen.empty()) return all;
  std::vector<NamedScene> scenes;
  for (const std::string& text : chosen) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const NamedScene& scene) { return scene.name == text; });
    scenes.push_back(found != all.end() ? *found : NamedScene{text, text});
  }
  return scenes;
}

/// What the cache has of a scene lies in files that begin like this.
std::string cache_path(const Settings& settings, const std::string& name) {
  std::string file = name;
  std::replace_if(
      file.begin(), file.end(), [](char c) { return c == '/' || c == ':'; }, '_');
  return fmt::format("{}/{}-{}x{}-{}", settings.cache, file, settings.size.width,
                     settings.size.height, settings.reference);
}

Result<Film> reference_of(const Settings& settings, const std::string& name, Snapshot snapshot) {
  const std::string path = cache_path(settings, name) + ".exr";
  if (settings.keep && std::filesystem::exists(path)) {
    auto image = read_exr(path);
    if (!image) return unexpected(image.error());
    if (image->film.width != settings.size.width || image->film.height != settings.size.height)
      return unexpected(Error{path, "is not of the size that its name says"});
    return std::move(image->film);
  }
  snapshot.settings.method = Method::sobol;
  snapshot.settings.seed = 12345;
  snapshot.settings.sampling.spp = settings.reference;
  Film film = render_to_end(snapshot).film;
  if (settings.keep) {
    const auto written = write_exr(path, film, {});
    if (!written) return unexpected(written.error());
  }
  return film;
}

/// The ladder as a line a step: samples, error, seconds. Nothing if it is not there or damaged.
std::optional<std::vector<CurvePoint>> read_ladder(const std::string& path) {
  std::ifstream file(path);
  std::vector<CurvePoint> ladder;
  for (const int spp : ladder_spp) {
    int samples = 0;
    CurvePoint point;
    if (!(file >> samples >> point.error >> point.seconds) || samples != spp) return std::nullopt;
    ladder.push_back(point);
  }
  return ladder;
}

Result<void> write_ladder(const std::string& path, const std::vector<CurvePoint>& ladder) {
  std::string text;
  for (std::size_t i = 0; i < ladder.size(); ++i)
    text += fmt::format("{} {} {}\n", ladder_spp[i], ladder[i].error, ladder[i].seconds);
  return write_file_atomically(path, {text.begin(), text.end()});
}

std::vector<Rung> sobol_rungs(const RenderSettings& base) {
  std::vector<Rung> rungs;
  for (const int spp : ladder_spp) {
    RenderSettings& settings = rungs.emplace_back().settings;
    settings = base;
    settings.method = Method::sobol;
    settings.sampling.spp = spp;
  }
  return rungs;
}

std::vector<Rung> asos_rungs(const RenderSettings& base, const std::vector<int>& levels) {
  std::vector<Rung> rungs;
  for (const int level : levels) {
    RenderSettings& settings = rungs.emplace_back().settings;
    settings = base;
    settings.method = Method::asos;
    settings.asos.max_level = level;
    settings.asos.eps = 1.0 / 256.0;
  }
  return rungs;
}

void render(Snapshot& snapshot, const Film& reference, std::vector<Rung>& rungs) {
  for (Rung& rung : rungs) {
    snapshot.settings = rung.settings;
    rung.point.error = picture_error(rung.times.render(snapshot).film, reference).shown;
    rung.point.seconds = rung.times.medians().cpu;
  }
}

std::vector<CurvePoint> points_of(const std::vector<Rung>& rungs) {
  std::vector<CurvePoint> points;
  for (const Rung& rung : rungs) points.push_back(rung.point);
  return points;
}

Result<Row> measure(const Settings& settings, const NamedScene& named) {
  const auto scene = open_scene(named.source);
  if (!scene) return unexpected(scene.error());
  Snapshot snapshot = snapshot_of(*scene, settings.size.width, settings.size.height);
  const auto reference = reference_of(settings, named.name, snapshot);
  if (!reference) return unexpected(reference.error());

  Row row{named.name, {}, {}};
  const std::string ladder_path = cache_path(settings, named.name) + "-sobol.txt";
  if (settings.keep && !settings.fresh)
    row.ladder = read_ladder(ladder_path).value_or(std::vector<CurvePoint>{});
  std::vector<Rung> sobol;
  if (row.ladder.empty() && settings.only != "asos") sobol = sobol_rungs(snapshot.settings);
  std::vector<Rung> asos;
  if (settings.only != "sobol") asos = asos_rungs(snapshot.settings, settings.levels);
  for (int run = 0; run < settings.runs; ++run) {
    render(snapshot, *reference, sobol);
    render(snapshot, *reference, asos);
  }
  row.asos = points_of(asos);
  if (sobol.empty()) return row;
  row.ladder = points_of(sobol);
  if (settings.keep) {
    const auto written = write_ladder(ladder_path, row.ladder);
    if (!written) return unexpected(written.error());
  }
  return row;
}

/// The reference's noise: what Sobol sampling's error would be at its number of samples if it went
/// on falling as over the last two steps of the ladder.
double reference_noise(const Row& row, int samples) {
  return between_log_log(samples, ladder_spp[1], ladder_spp[3], row.ladder[1].error,
                         row.ladder[3].error);
}

std::optional<Ratio> ratio_of(const Row& row, std::size_t level, int reference) {
  if (row.ladder.empty() || row.asos.empty()) return std::nullopt;
  const CurvePoint asos = row.asos[level];
  const auto seconds = seconds_at_error(row.ladder, asos.error);
  if (!seconds) return std::nullopt;
  return Ratio{seconds->value / asos.seconds, seconds->beyond,
               asos.error < 2.0 * reference_noise(row, reference)};
}

void print_heading(const Settings& settings) {
  fmt::print("{}x{}, EPS 1/256, reference {} samples; times are processor seconds\n{:<30}",
             settings.size.width, settings.size.height, settings.reference, "");
  if (settings.only != "sobol")
    for (const int level : settings.levels)
      fmt::print("{:>10}{:>9}{:>9}  ", fmt::format("MAX {} RMSE", level), "s", "x");
  fmt::print("{:>11}{:>9}\n", "sobol RMSE", "s (256)");
}

void print_row(const Settings& settings, const Row& row) {
  fmt::print("{:<30}", row.name);
  for (std::size_t i = 0; i < row.asos.size(); ++i) {
    const auto ratio = ratio_of(row, i, settings.reference);
    fmt::print("{:>10.2e}{:>9.3f}", row.asos[i].error, row.asos[i].seconds);
    if (ratio)
      fmt::print("{:>9.2f}{}{}", ratio->value, ratio->beyond ? 'e' : ' ',
                 ratio->unknown ? '*' : ' ');
    else
      fmt::print("{:>9}  ", "-");
  }
  if (row.ladder.empty())
    fmt::print("{:>11}{:>9}\n", "-", "-");
  else
    fmt::print("{:>11.2e}{:>9.3f}\n", row.ladder.back().error, row.ladder.back().seconds);
  std::fflush(stdout);
}

/// The median over all scenes, how many lose, and the worst ones by name.
void print_summary(const Settings& settings, const std::vector<Row>& rows) {
  constexpr std::size_t shown = 8;
  for (std::size_t i = 0; i < settings.levels.size(); ++i) {
    std::vector<std::pair<double, std::string>> ratios;
    double seconds = 0.0;
    for (const Row& row : rows) {
      if (!row.asos.empty()) seconds += row.asos[i].seconds;
      if (const auto ratio = ratio_of(row, i, settings.reference))
        ratios.emplace_back(ratio->value, row.name);
    }
    if (ratios.empty()) continue;
    std::sort(ratios.begin(), ratios.end());
    std::vector<double> values;
    for (const auto& [value, name] : ratios) values.push_back(value);
    const auto lost =
        std::count_if(values.begin(), values.end(), [](double value) { return value < 1.0; });
    fmt::print("MAX {}: median {:.2f}, {} of {} below 1, {:.2f} s in all; worst:",
               settings.levels[i], median(values), lost, values.size(), seconds);
    for (std::size_t k = 0; k < std::min(shown, ratios.size()); ++k)
      fmt::print("{} {} {:.2f}", k > 0 ? "," : "", ratios[k].second, ratios[k].first);
    fmt::print("\n");
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

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  Options options("Time at equal error over every scene, ASOS beside Sobol sampling");
  options.size(settings.size);
  options.parsed("--levels", "MAX of the runs of ASOS, as in 2,3",
                 [&](const std::string& text) { return read_levels(text, settings.levels); });
  options.number("--reference", settings.reference, 256, 65536, "samples");
  options.number("--runs", settings.runs, 1, 99);
  options.parsed("--cache", "folder of references and ladders",
                 [&](const std::string& text) -> Result<void> {
                   settings.cache = text;
                   settings.keep = true;
                   return {};
                 });
  options.choice("--only", settings.only, {"both", "asos", "sobol"});
  options.flag("--fresh", settings.fresh, "measure the ladder anew though it is in the cache");
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
  print_summary(settings, rows);
  return code;
}
