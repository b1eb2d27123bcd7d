// Stability of thin objects in motion: a pole 1/8 pixel wide, and a gap of that width between two
// walls, move by 2 pixels in 64 steps. The pole's contribution to the sum of the picture's
// intensities (or the gap's reduction of it) should be constant; the table shows its (max - min) /
// mean in percent. Surfaces are unlit and the camera is orthographic, so only visibility changes.
// Also a pole that ends within the picture.
//
//   bench animation [--size N] [--steps N] [--csv]

#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"
#include "tests/support/make_settings.h"
#include "tests/support/thin_subject.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::animation {

using test::steadiness;
using test::Steadiness;
using test::thin_scene;
using test::thin_share;
using test::ThinSubject;

struct Settings {
  int size = 32;  ///< pixels; a pixel is one unit wide
  int steps = 64;
  bool csv = false;
};

constexpr double travel = 2.0;  // pixels

constexpr std::array<ThinSubject, 6> subjects{{{"pole, upright", 0.0},
                                               {"pole, tilted 1 in 7.3", 0.137},
                                               {"pole, tilted 1 in 1.7", 0.593},
                                               {"pole with ends, tilted", 0.137, 5.3},
                                               {"gap, upright", 0.0, 0.0, true},
                                               {"gap, tilted 1 in 7.3", 0.137, 0.0, true}}};

struct Contender {
  std::string name;
  RenderSettings settings;
};

std::vector<Contender> contenders(int size) {
  RenderSettings base = test::make_settings(size, size);
  base.threads = 1;
  base.asos.max_level = 4;
  std::vector<Contender> list;
  const auto add_one = [&](const std::string& name, auto change) {
    change(list.emplace_back(Contender{name, base}).settings);
  };
  add_one("asos MAX 4", [](RenderSettings&) {});
  add_one("asos MAX 4, EPS 0", [](RenderSettings& s) { s.asos.eps = 0.0; });
  add_one("published MAX 4", [](RenderSettings& s) { s.method = Method::asos_published; });
  for (const int spp : {16, 64, 256})
    add_one(fmt::format("stochastic {}", spp), [spp](RenderSettings& s) {
      s.method = Method::stochastic;
      s.sampling.spp = spp;
    });
  return list;
}

Result<void> measure(const ThinSubject& subject, const Settings& settings) {
  std::vector<Contender> list = contenders(settings.size);
  std::vector<std::vector<double>> shares(list.size());
  for (int step = 0; step < settings.steps; ++step) {
    const auto scene =
        prepare(thin_scene(subject, travel * step / settings.steps - travel / 2, settings.size))
            .and_then(with_boundaries);
    if (!scene) return unexpected(scene.error());
    Snapshot snapshot = snapshot_of(*scene, settings.size, settings.size);
    for (std::size_t i = 0; i < list.size(); ++i) {
      snapshot.settings = list[i].settings;
      shares[i].push_back(thin_share(subject, render_to_end(snapshot).film));
    }
  }
  if (!settings.csv) fmt::print("{}\n", subject.name);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Steadiness s = steadiness(shares[i]);
    if (settings.csv)
      fmt::print("\"{}\",\"{}\",{:.6f},{:.6f}\n", subject.name, list[i].name, 100.0 * s.range,
                 s.mean);
    else
      fmt::print("  {:<20}{:>12.4f}{:>14.5f}\n", list[i].name, 100.0 * s.range, s.mean);
  }
  std::fflush(stdout);
  return {};
}

int run(int argc, char** argv) {
  Settings settings;
  Options options("Steadiness of thin things that move");
  options.number("--size", settings.size, 16, 512, "pixels, width and height");
  options.number("--steps", settings.steps, 2, 4096);
  options.flag("--csv", settings.csv);
  if (const auto code = options.end(argc, argv)) return *code;
  if (settings.csv)
    fmt::print("subject,method,range_percent,mean_over_exact\n");
  else
    fmt::print("  {:<20}{:>12}{:>14}\n", "", "range, %", "mean / exact");
  for (const ThinSubject& subject : subjects)
    if (const auto done = measure(subject, settings); !done) return fail(done.error());
  return 0;
}

}  // namespace asos::bench::animation
