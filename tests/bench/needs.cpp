// Savings of leaving out unneeded features: each such feature is forced in alone, then all of them
// together. Prints ratios to the scene without them (1: nothing saved): CPU time of the picture,
// time to build, memory of the scene. The two alternate, so that drift of the machine affects both.
// Ratios of renders use medians; those of builds the fastest run, because builds take milliseconds
// in several threads. Compares the pictures bit by bit.
//
//   bench needs [SCENE...] [--size WxH] [--repetitions N] [--max K] [--csv]

#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace asos::bench::needs {

struct Settings {
  std::vector<std::string> scenes{"builtin:boxes", "builtin:mixed"};
  PictureSize size{320, 240};
  int repetitions = 5;
  int max_level = 3;
  bool csv = false;
};

struct Forced {
  std::string name;
  RenderFeatures render_features;
};

/// The features that are left out according to `render_features` and can be forced, then all of
/// them.
std::vector<Forced> forced_features(const RenderFeatures& render_features) {
  std::vector<Forced> list;
  const RenderFeatures all = RenderFeatures::all();
  for (const RenderFeature& feature : features_left_out(render_features)) {
    if (!(all.*feature.needed)) continue;
    list.emplace_back(Forced{feature.name, {}}).render_features.*feature.needed = true;
  }
  list.push_back({"all of them", all});
  return list;
}

struct Cost {
  std::vector<double> build;
  Times render;
  double memory_mb = 0.0;
  Film film;
};

/// Prepares and renders once, and adds the costs.
Result<void> measure(const Scene& scene, const RenderFeatures& forced, const Settings& settings,
                     Cost& cost) {
  const auto prepared = prepare(scene, forced).and_then(as_rendered).and_then(with_boundaries);
  if (!prepared) return unexpected(prepared.error());
  cost.build.push_back((*prepared)->geometry->build_seconds +
                       (*prepared)->geometry->boundaries.seconds());
  cost.memory_mb = (*prepared)->geometry->memory_mb();
  Snapshot snapshot = snapshot_of(*prepared, settings.size.width, settings.size.height);
  snapshot.settings.asos.max_level = settings.max_level;
  snapshot.settings.threads = 1;
  cost.film = cost.render.render(snapshot).film;
  return {};
}

/// Compares the scene with `what` forced in and with only its needed features.
Result<void> compare(const std::string& source, const Scene& scene, const Forced& what,
                     const Settings& settings) {
  Cost needed, forced;
  for (int i = 0; i < settings.repetitions; ++i) {
    // The order alternates, too.
    const auto first = i % 2 == 0 ? measure(scene, {}, settings, needed)
                                  : measure(scene, what.render_features, settings, forced);
    if (!first) return first;
    const auto second = i % 2 == 0 ? measure(scene, what.render_features, settings, forced)
                                   : measure(scene, {}, settings, needed);
    if (!second) return second;
  }
  const double render = forced.render.medians().cpu / needed.render.medians().cpu;
  const double build = *std::min_element(forced.build.begin(), forced.build.end()) /
                       *std::min_element(needed.build.begin(), needed.build.end());
  const double memory = forced.memory_mb / needed.memory_mb;
  const bool same = forced.film.radiance == needed.film.radiance;
  if (settings.csv)
    fmt::print("\"{}\",\"{}\",{:.4f},{:.4f},{:.4f},{}\n", source, what.name, render, build, memory,
               same ? "same" : "different");
  else
    fmt::print("  {:<34}{:>9.3f}{:>9.3f}{:>9.3f}   {}\n", what.name, render, build, memory,
               same ? "same" : "DIFFERENT");
  std::fflush(stdout);
  return {};
}

Result<void> measure_scene(const std::string& source, const Settings& settings) {
  const Result<Scene> scene = load_scene(source);
  if (!scene) return unexpected(scene.error());
  const auto prepared = prepare(*scene).and_then(with_boundaries);
  if (!prepared) return unexpected(prepared.error());
  if (!settings.csv)
    fmt::print("{}: {} triangles, {:.2f} MB\n", source, (*prepared)->world().triangles.size(),
               (*prepared)->geometry->memory_mb());
  // The first line compares the scene with itself: its deviation from 1 is noise.
  std::vector<Forced> list = forced_features((*prepared)->render_features);
  list.insert(list.begin(), Forced{"(nothing: noise)", {}});
  for (const Forced& what : list) {
    if (const auto done = compare(source, *scene, what, settings); !done) return done;
  }
  return {};
}

int run(int argc, char** argv) {
  Settings settings;
  Options options("What leaving out saves");
  options.texts("SCENES", settings.scenes);
  options.size(settings.size);
  options.number("--repetitions", settings.repetitions, 1, 99);
  options.number("--max", settings.max_level, 0, 8);
  options.flag("--csv", settings.csv);
  if (const auto code = options.end(argc, argv)) return *code;
  if (settings.csv)
    fmt::print("scene,forced,render_ratio,build_ratio,memory_ratio,picture\n");
  else
    fmt::print("  {:<34}{:>9}{:>9}{:>9}   picture\n", "forced", "render", "build", "memory");
  for (const std::string& source : settings.scenes)
    if (const auto done = measure_scene(source, settings); !done) return fail(done.error());
  return 0;
}

}  // namespace asos::bench::needs
