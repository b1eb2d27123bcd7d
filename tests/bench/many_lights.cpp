// Cost of many lights relative to few: a scene with all its lights, and with only its N brightest,
// scaled to the same total. Both by ASOS and by sampling, with errors against references with the
// same lights. CPU time of all threads, medians of alternating runs.
//
//   bench many-lights [--few N] [--size WxH] [--reference SPP] SCENE...

#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::many_lights {

double power_of(const PreparedLight& light) {
  const glm::vec3 p = light.power;
  const double area = light.area > 0.0 ? light.area : 1.0;
  return area * static_cast<double>(std::max({p.x, p.y, p.z}));
}

/// The scene with only its brightest lights.
Result<SharedScene> with_few_lights(const SharedScene& scene, std::size_t few) {
  const auto prepared = scene->lighting->prepared(LightRule::physical);
  std::vector<std::size_t> order(prepared.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return power_of(prepared[a]) > power_of(prepared[b]);
  });
  double all = 0.0, kept = 0.0;
  std::vector<Light> lights;
  for (std::size_t k = 0; k < order.size(); ++k) {
    all += power_of(prepared[order[k]]);
    if (k >= few) continue;
    kept += power_of(prepared[order[k]]);
    lights.push_back(scene->lighting->lights[order[k]]);
  }
  for (Light& light : lights) light.intensity *= static_cast<float>(all / kept);
  return with_lights(scene, std::move(lights));
}

struct Measured {
  double seconds = 0.0;
  double error = 0.0;
};

Measured measure(Snapshot snapshot, const Film& reference) {
  constexpr int runs = 3;
  Times times;
  double error = 0.0;
  for (int i = 0; i < runs; ++i)
    error = picture_error(times.render(snapshot).film, reference).shown;
  return {times.medians().cpu, error};
}

/// Prints one row for the few lights and one for all.
int compare(const std::string& source, std::size_t few, int reference_spp, PictureSize size) {
  const auto opened = open_scene(source);
  if (!opened) return fail(opened.error());
  const auto reduced = with_few_lights(*opened, few);
  if (!reduced) return fail(reduced.error());
  std::vector<double> seconds;
  for (const SharedScene& scene : {*reduced, *opened}) {
    Snapshot snapshot = snapshot_of(scene, size.width, size.height);
    snapshot.settings.method = Method::sobol;
    snapshot.settings.sampling.spp = reference_spp;
    const Film reference = Times().render(snapshot).film;
    snapshot.settings.sampling.spp = 16;
    const Measured sobol = measure(snapshot, reference);
    snapshot.settings.method = Method::asos;
    const Measured asos = measure(snapshot, reference);
    seconds.push_back(asos.seconds);
    fmt::print("{:28} {:7} {:12.2f} {:12.2e} {:12.2f} {:12.2e}\n", source,
               scene->lighting->lights.size(), asos.seconds, asos.error, sobol.seconds,
               sobol.error);
  }
  fmt::print("{:28} all lights take ASOS {:.2f} times as long\n", source, seconds[1] / seconds[0]);
  return 0;
}

int run(int argc, char** argv) {
  Options options("What many lights cost beside few of them");
  int few = 2, reference = 1024;
  PictureSize size{160, 90};
  std::vector<std::string> scenes;
  options.number("--few", few, 1, 1000, "Lights that are kept");
  options.number("--reference", reference, 16, 65536, "Sobol samples a pixel of the reference");
  options.size(size);
  options.texts("scene", scenes);
  if (const auto code = options.end(argc, argv)) return *code;
  fmt::print("{:28} {:>7} {:>12} {:>12} {:>12} {:>12}\n", "", "lights", "ASOS MAX 3 s", "RMSE",
             "sobol 16 s", "RMSE");
  int status = 0;
  for (const std::string& scene : scenes)
    status |= compare(scene, static_cast<std::size_t>(few), reference, size);
  return status;
}

}  // namespace asos::bench::many_lights
