#include "tests/bench/bench_support.h"

#include "renderer/prepared/default_look.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/prepared/exposure.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/scene/builtin.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/world/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <utility>

namespace asos::bench {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

RenderResult Times::render(const Snapshot& snapshot) {
  const std::clock_t start = std::clock();
  RenderResult result = render_to_end(snapshot);
  wall_.push_back(result.seconds);
  cpu_.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  return result;
}

Result<SharedScene> as_rendered(SharedScene scene) {
  const DefaultLook look = default_look(*scene);
  return lit_under(std::move(scene), look.sky.get()).and_then([&](SharedScene lit) {
    return with_ground(std::move(lit), look.ground);
  });
}

Result<SharedScene> open_scene(const std::string& source) {
  const Result<Scene> scene = load_scene(source);
  if (!scene) return unexpected(scene.error());
  return prepare(*scene).and_then(as_rendered).and_then(with_boundaries);
}

Snapshot snapshot_of(SharedScene scene, int width, int height) {
  const World& world = scene->world();
  Snapshot snapshot;
  snapshot.camera = world.cameras.empty()
                        ? default_camera(world, static_cast<double>(width) / height)
                        : world.cameras.front();
  snapshot.settings.sky = default_look(*scene, snapshot.camera).sky;
  snapshot.settings.ground = ground_of(world);
  snapshot.settings.background = default_background(snapshot.settings.sky.get());
  snapshot.scene = std::move(scene);
  snapshot.progressive = false;
  snapshot.settings.width = width;
  snapshot.settings.height = height;
  snapshot.settings.threads = 2;
  return snapshot;
}

std::string ExposureChoice::label() const {
  std::string text;
  if (f_stop > 0.0) text += fmt::format("-f{}", f_stop);
  if (focus > 0.0) text += fmt::format("-at-{}", focus);
  if (animation >= 0) text += fmt::format("-clip{}-{}s-{}s", animation, seconds, shutter_seconds);
  return text;
}

Result<Snapshot> exposed_snapshot(const std::string& source, PictureSize size, CameraChoice camera,
                                  const ExposureChoice& exposure) {
  const bool moves = exposure.animation >= 0;
  const Result<Scene> file = load_scene(source, {.keep_posable = moves});
  if (!file) return unexpected(file.error());
  Result<SharedScene> scene = prepare(*file);
  if (!scene) return unexpected(scene.error());
  if (moves && !file->rig) return unexpected(Error{source, "has no animations"});
  const std::shared_ptr<const RenderScene> rest = *scene;
  const auto posed = [&](const ClipTime& time, const std::shared_ptr<MeshStore>& meshes) {
    AnimationInvariants stage = rest->geometry->stage;
    stage.meshes = meshes;
    return file->rig->pose(time).and_then(
        [&](const Scene& pose) { return prepare(pose, {}, &stage); });
  };
  if (moves) scene = posed({exposure.animation, exposure.seconds}, nullptr);
  if (scene) scene = as_rendered(*scene).and_then(with_boundaries);
  if (!scene) return unexpected(scene.error());
  if (exposure.f_stop > 0.0) camera.lens.f_stop = exposure.f_stop;
  if (exposure.focus > 0.0) camera.lens.focus = exposure.focus;
  const auto chosen =
      choose_camera((*scene)->world(), camera, static_cast<double>(size.width) / size.height);
  if (!chosen) return unexpected(chosen.error());
  Snapshot snapshot = snapshot_of(*scene, size.width, size.height);
  snapshot.camera = *chosen;
  snapshot.settings.shutter.seconds = exposure.shutter_seconds;
  auto over_time = exposed(*scene, *chosen, snapshot.settings, posed);
  if (!over_time) return unexpected(over_time.error());
  snapshot.scene = *std::move(over_time);
  return snapshot;
}

namespace {

std::vector<NamedScene> builtin_set() {
  std::vector<NamedScene> scenes;
  for (const BuiltinScene& scene : builtin_scenes())
    scenes.push_back({scene.name, "builtin:" + scene.name});
  return scenes;
}

std::vector<NamedScene> models() {
  std::vector<NamedScene> scenes;
  const char* shared = std::getenv("ASOS_SHARED");
  if (!shared) return scenes;
  std::error_code unreadable;
  for (const auto& file : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(shared) / "scenes", unreadable)) {
    const std::string ending = file.path().extension().string();
    if (ending != ".glb" && ending != ".gltf") continue;
    scenes.push_back({file.path().parent_path().filename().string(), file.path().string()});
  }
  std::sort(scenes.begin(), scenes.end(),
            [](const NamedScene& a, const NamedScene& b) { return a.name < b.name; });
  return scenes;
}

}  // namespace

std::vector<NamedScene> chosen_scenes(const std::vector<std::string>& chosen) {
  const std::vector<NamedScene> built_in = builtin_set(), files = models();
  if (chosen.empty()) return files.empty() ? built_in : files;
  std::vector<NamedScene> scenes;
  for (const std::string& text : chosen) {
    if (text == "builtin" || text == "models") {
      const std::vector<NamedScene>& set = text == "builtin" ? built_in : files;
      scenes.insert(scenes.end(), set.begin(), set.end());
      continue;
    }
    NamedScene found{text, text};
    for (const std::vector<NamedScene>* set : {&files, &built_in})
      for (const NamedScene& scene : *set)
        if (scene.name == text) found = scene;
    scenes.push_back(std::move(found));
  }
  return scenes;
}

Camera camera_at(const World& world, glm::dvec3 eye, glm::dvec3 target, double fov_y_deg) {
  return choose_camera(world, {{}, LookAt{eye, target}, {}, fov_y_deg}, 1.0).value();
}

PictureError picture_error(const Film& film, const Film& reference) {
  return {root_mean_square(film, reference, true), root_mean_square(film, reference, false)};
}

std::vector<std::size_t> worst_pixels(const Film& film, const Film& reference) {
  std::vector<double> error(film.radiance.size());
  for (std::size_t i = 0; i < error.size(); ++i)
    error[i] = squared_error(film.radiance[i], reference.radiance[i], true);
  std::vector<std::size_t> order(error.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return error[a] > error[b]; });
  return order;
}

const char* name_of(Outcome outcome) {
  constexpr const char* names[outcome_count] = {"one sample", "resolved", "unresolved", "saturated",
                                                "by samples"};
  return names[static_cast<int>(outcome)];
}

Outcome outcome_of(const PixelTrace& trace) {
  const auto any = [&](CellFate fate) {
    return std::any_of(trace.cells.begin(), trace.cells.end(),
                       [fate](const TracedCell& cell) { return cell.fate == fate; });
  };
  if (any(CellFate::by_samples) || any(CellFate::sampled)) return Outcome::by_samples;
  if (any(CellFate::saturated)) return Outcome::saturated;
  if (trace.unresolved_area > 0.0) return Outcome::unresolved;
  return samples_of(trace) > 1 ? Outcome::resolved : Outcome::one_sample;
}

std::size_t samples_of(const PixelTrace& trace) {
  std::size_t samples = 0;
  for (const TracedCell& cell : trace.cells) samples += cell.samples.size();
  return samples;
}

PixelTrace trace_of(const Snapshot& snapshot, std::size_t pixel) {
  RenderSettings settings = snapshot.settings;
  settings.asos.fat = 2;
  const auto width = static_cast<std::size_t>(settings.width);
  return trace_pixel(*snapshot.scene, View(snapshot.camera, settings.width, settings.height),
                     settings, static_cast<int>(pixel % width), static_cast<int>(pixel / width));
}

int fail(const Error& error) {
  fmt::print(stderr, "{}\n", error.message());
  return 1;
}

}  // namespace asos::bench
