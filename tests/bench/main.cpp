// `bench NAME ...`: measurements, which cannot fail.

#include "tests/bench/benchmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace {

using namespace asos::bench;

struct Benchmark {
  std::string_view name;
  int (*run)(int argc, char** argv);
  std::string_view shows;
};

constexpr std::array benchmarks{
    Benchmark{"animation", animation::run, "a thin pole and a thin gap that move through pixels"},
    Benchmark{"bias", bias::run, "ASOS at a great depth beside many samples, worst first"},
    Benchmark{"convergence", convergence::run, "error and work by MAX, against the exact picture"},
    Benchmark{"costs", costs::run, "the engine's parts, as ratios of processor times"},
    Benchmark{"equal-error", equal_error::run, "how much longer sampling takes, with causes"},
    Benchmark{"anytime", anytime::run, "the error of a picture while it renders, scene by scene"},
    Benchmark{"every-scene", every_scene::run, "the same, a line for every scene"},
    Benchmark{"latency", latency::run, "how soon the window follows a change"},
    Benchmark{"opening", opening::run, "time and memory to open scenes, stage by stage"},
    Benchmark{"many-lights", many_lights::run, "many lights beside the brightest few"},
    Benchmark{"moving", moving::run, "from one moment of an animation to the next"},
    Benchmark{"needs", needs::run, "what is saved by leaving out what a scene does not need"},
    Benchmark{"prices", prices::run, "exact answers of shadows, in the time of rays"},
    Benchmark{"primitives", primitives::run, "the papers' in-out tests beside rays"},
    Benchmark{"rays-alone", rays_alone::run, "sampling over its rays and nothing else"},
    Benchmark{"render-ratios", render_ratios::run, "time over that of one sample a pixel"},
    Benchmark{"slow-kinds", slow_kinds::run, "kinds of models that ASOS is slow at"}};

void print_usage(std::FILE* to) {
  fmt::print(to, "usage: bench NAME [--help] ...\n");
  for (const Benchmark& benchmark : benchmarks)
    fmt::print(to, "  {:<14} {}\n", benchmark.name, benchmark.shows);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view name = argc > 1 ? argv[1] : "--help";
  if (name == "--help" || name == "-h") {
    print_usage(stdout);
    return 0;
  }
  const auto* const found = std::ranges::find(benchmarks, name, &Benchmark::name);
  if (found == benchmarks.end()) {
    fmt::print(stderr, "bench: there is no benchmark {}\n", name);
    print_usage(stderr);
    return 2;
  }
  return found->run(argc - 1, argv + 1);
}
