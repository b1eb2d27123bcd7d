// Time at equal error: ladders of settings for ASOS, for stochastic and for Sobol sampling, with
// errors against many Sobol samples of another seed. For each setting of ASOS prints the ratio of
// the rivals' time to the same error (interpolated between their settings, log-log). Errors are
// RMSE of linear radiance clipped to 0..1; times are CPU times, medians of alternating runs. The
// reference's noise is extrapolated from the last steps of the Sobol ladder; errors below twice
// that are marked with * as uncertain.
//
//   bench equal-error [--size WxH] [--look-at ...] [--fov DEG] [--shadows on|off]
//                     [--reference N] [--runs N] [--causes MAX] [--matte] [--key-light]
//                     [--qualities] [--dfr MIN,MAX,N] [--tr N] [--levels K]
//                     [--f-stop N] [--focus M] [--animation N] [--time S] [--shutter S] SCENE
//
// --matte removes textures, highlights and emission, so that only visibility and smooth shading
// remain. --key-light keeps only the first rectangular light, of the scene or of its default
// lighting. --qualities has a row for each shadow quality at MAX 2, 3 and 4 instead of the ladder.
// --levels ends the ladder of ASOS at MAX K. --causes prints the distribution of time and error at
// one MAX: by the outcome of pixels, and by the kind of surface.

#include "renderer/comparison/method.h"
#include "renderer/settings/names.h"
#include "renderer/settings/value_text.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/error_causes.h"
#include "tests/bench/measured_ladder.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::equal_error {

struct Settings {
  PictureSize size{480, 270};
  CameraChoice camera;
  bool shadows = true;
  int reference = 1024;
  int runs = 3;
  int causes = -1;
  int levels = 5;
  bool matte = false;
  bool key_light = false;
  bool qualities = false;
  int texture_resolution = 1;
  std::optional<Dfr> dfr;
  ExposureChoice exposure;
  std::string scene;
};

MeasuredLadder asos_ladder(RenderSettings settings, int levels) {
  MeasuredLadder ladder;
  settings.method = Method::asos;
  for (const double eps : {0.0, 1.0 / 256.0}) {
    for (int level = 1; level <= levels; ++level) {
      settings.asos.max_level = level;
      settings.asos.eps = eps;
      ladder.add(fmt::format("asos MAX {}{}", level, eps > 0.0 ? " EPS 1/256" : ""), settings);
    }
  }
  return ladder;
}

MeasuredLadder quality_rows(RenderSettings settings) {
  MeasuredLadder rows;
  settings.method = Method::asos;
  for (const auto& quality : shadow_quality_names) {
    for (int level = 2; level <= 4; ++level) {
      settings.asos.max_level = level;
      settings.shadow.quality = quality.value;
      rows.add(fmt::format("{} {}", quality.name, level), settings);
    }
  }
  return rows;
}

/// Time in seconds that a sampling method takes to an error. Extrapolated beyond its ladder from
/// the first or last step; NaN if that is impossible.
double rival_seconds(const MeasuredLadder& ladder, double error) {
  const auto seconds = seconds_at_error(ladder.points(), error);
  return seconds ? seconds->value : std::numeric_limits<double>::quiet_NaN();
}

/// The expected error with `spp` samples, extrapolated from the last two steps of the ladder.
double extrapolated_error(const MeasuredLadder& ladder, int spp) {
  const MeasuredStep& a = *(ladder.steps().end() - 3);
  const MeasuredStep& b = ladder.steps().back();
  return between_log_log(spp, a.settings.sampling.spp, b.settings.sampling.spp, a.error.rmse,
                         b.error.rmse);
}

void print_step(const MeasuredStep& step, double pixels, double floor) {
  fmt::print("{:<22}{:>10.2e}{}{:>10.2e}{:>9.3f}{:>9.2f}{:>9.2f}", step.label, step.error.rmse,
             step.error.rmse < 2.0 * floor ? '*' : ' ', step.raw_rmse, step.times.medians().cpu,
             static_cast<double>(step.statistics.eye_rays) / pixels,
             static_cast<double>(step.statistics.shadow_rays) / pixels);
}

void make_matte(Scene& scene) {
  for (Material& material : scene.materials) {
    material.base_color_texture = {};
    material.metallic_roughness_texture = {};
    material.normal_texture = {};
    material.emissive_texture = {};
    material.emissive = glm::vec3(0.0f);
    material.metallic = 0.0f;
    material.roughness = 1.0f;
  }
}

Result<SharedScene> prepared_scene(const Settings& settings) {
  auto scene = load_scene(settings.scene);
  if (!scene) return unexpected(scene.error());
  if (settings.matte) make_matte(*scene);
  if (!settings.key_light) return prepare(*scene).and_then(as_rendered).and_then(with_boundaries);
  // The default lighting is made for the camera.
  const auto flattened = flatten(*scene);
  if (!flattened) return unexpected(flattened.error());
  const auto camera =
      choose_camera(flattened->world, settings.camera,
                    static_cast<double>(settings.size.width) / settings.size.height);
  if (!camera) return unexpected(camera.error());
  Camera placed = *camera;
  placed.world_from_camera[3] += glm::dvec4(flattened->world.origin, 0.0);
  scene->cameras = {placed};
  const auto lit = prepare(*scene).and_then(with_boundaries);
  if (!lit) return unexpected(lit.error());
  for (Light light : (*lit)->lights()) {
    if (light.type != Light::Type::rectangle) continue;
    light.position += (*lit)->world().origin;
    light.own_part = -1;
    scene->lights = {light};
    return prepare(*scene).and_then(as_rendered).and_then(with_boundaries);
  }
  return unexpected(Error{settings.scene, "gets no rectangular light"});
}

Result<Snapshot> snapshot_for(const Settings& settings) {
  if (!settings.matte && !settings.key_light)
    return exposed_snapshot(settings.scene, settings.size, settings.camera, settings.exposure);
  const auto scene = prepared_scene(settings);
  if (!scene) return unexpected(scene.error());
  Snapshot snapshot = snapshot_of(*scene, settings.size.width, settings.size.height);
  const auto camera =
      choose_camera((*scene)->world(), settings.camera,
                    static_cast<double>(settings.size.width) / settings.size.height);
  if (!camera) return unexpected(camera.error());
  snapshot.camera = *camera;
  return snapshot;
}

Result<void> measure(const Settings& settings) {
  const auto taken = snapshot_for(settings);
  if (!taken) return unexpected(taken.error());
  Snapshot snapshot = *taken;
  const SharedScene scene = snapshot.scene;
  snapshot.settings.shadow.cast = settings.shadows;
  snapshot.settings.mirror.dfr = settings.dfr;
  snapshot.settings.texture.resolution = settings.texture_resolution;

  RenderSettings base = snapshot.settings;
  snapshot.settings.method = Method::sobol;
  snapshot.settings.seed = 12345;
  snapshot.settings.sampling.spp = settings.reference;
  const Film reference = render_to_end(snapshot).film;

  MeasuredLadder asos =
      settings.qualities ? quality_rows(base) : asos_ladder(base, settings.levels);
  MeasuredLadder stochastic = MeasuredLadder::of_study(Method::stochastic, base, "stochastic ");
  MeasuredLadder sobol = MeasuredLadder::of_study(Method::sobol, base, "sobol ");
  for (int run = 0; run < settings.runs; ++run)
    for (MeasuredLadder* ladder : {&stochastic, &sobol, &asos})
      ladder->render(snapshot, [&](MeasuredStep& step, const Film& film) {
        const PictureError error = picture_error(film, reference);
        step.error.rmse = error.shown;
        step.raw_rmse = error.raw;
      });

  const double floor = extrapolated_error(sobol, settings.reference);
  fmt::print(
      "\n{}{}, {}x{}, shadows {}, {} triangles; reference {} samples, its noise about {:.1e}\n",
      settings.scene, settings.matte ? " made matte" : "", settings.size.width,
      settings.size.height, settings.shadows ? "on" : "off", scene->world().triangles.size(),
      settings.reference, floor);
  fmt::print("{:<22}{:>10} {:>10}{:>9}{:>9}{:>9}{:>10}{:>12}{:>9}\n", "", "RMSE", "raw RMSE",
             "cpu s", "eye/pix", "shad/pix", "unres. %", "stochastic x", "sobol x");
  const auto pixels = static_cast<double>(reference.radiance.size());
  for (const MeasuredLadder* ladder : {&stochastic, &sobol}) {
    for (const MeasuredStep& step : ladder->steps()) {
      print_step(step, pixels, floor);
      fmt::print("\n");
    }
  }
  for (const MeasuredStep& step : asos.steps()) {
    print_step(step, pixels, floor);
    const double seconds = step.times.medians().cpu;
    fmt::print("{:>10.4f}{:>12.2f}{:>9.2f}\n", 100.0 * step.statistics.unresolved_area / pixels,
               rival_seconds(stochastic, step.error.rmse) / seconds,
               rival_seconds(sobol, step.error.rmse) / seconds);
  }
  if (settings.causes >= 0) {
    snapshot.settings = base;
    snapshot.settings.asos.eps = 0.0;
    snapshot.settings.asos.max_level = settings.causes;
    print_causes(snapshot, render_to_end(snapshot).film, reference);
  }
  return {};
}

int run(int argc, char** argv) {
  Settings settings;
  std::string shadows = "on";
  Options options("Time at equal error, ASOS beside stochastic and Sobol sampling");
  options.size(settings.size);
  options.camera(settings.camera);
  options.exposure(settings.exposure);
  options.choice("--shadows", shadows, {"on", "off"});
  options.number("--reference", settings.reference, 256, 65536, "samples");
  options.number("--runs", settings.runs, 1, 99);
  options.number("--causes", settings.causes, 0, 8, "MAX to look into");
  options.number("--levels", settings.levels, 1, 8, "deepest MAX of the ladder");
  options.flag("--matte", settings.matte, "without textures, highlights and emission");
  options.flag("--key-light", settings.key_light, "the first rectangular light only");
  options.parsed("--dfr", "MIN,MAX,N of all that mirrors", [&](const std::string& text) {
    return parse_dfr(text).map([&](const Dfr& dfr) { settings.dfr = dfr; });
  });
  options.number("--tr", settings.texture_resolution, 1, 8, "TR of asos");
  options.flag("--qualities", settings.qualities, "a row for each shadow quality");
  options.text("SCENE", settings.scene);
  if (const auto code = options.end(argc, argv)) return *code;
  settings.shadows = shadows == "on";
  const auto done = measure(settings);
  return done ? 0 : fail(done.error());
}

}  // namespace asos::bench::equal_error
