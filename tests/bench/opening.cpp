// Time and memory of opening a scene, stage by stage. Every scene has a process of its own.
//
//   bench opening [SCENE...] [--size WxH] [--threads N].
//
//   read      reading and decoding the file.
//   rays      flattening, likely ground, rays' hierarchy, coplanar triangles, lights.
//   look      default sky, and the ground if it is another.
//   picture   one Sobol sample per pixel.
//   edges     the search for boundaries, which only methods with edges need.
//   block     the first exact block.
//   hide      hiding every second object.
//
// Seconds are processor time of all threads; "wall" is the time until the picture, and until the
// block. The last columns are the peak memory until the picture, and of all stages, with bytes per
// triangle. The last line names the stages of 50 ms or more that take more than five times as long
// as reading the file.

#include "app/large_blocks.h"
#include "renderer/prepared/default_look.h"
#include "renderer/prepared/own_lights.h"
#include "renderer/prepared/prepare_on_ground.h"
#include "renderer/prepared/without_objects.h"
#include "renderer/render_block.h"
#include "renderer/session/film_render.h"
#include "renderer/world/ground.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace asos::bench::opening {
namespace {

struct Settings {
  std::vector<std::string> scenes;
  PictureSize size{320, 180};
  int threads = 1;
};

/// The stages of one scene. Plain data: it passes through a pipe.
struct Opened {
  enum Stage { read, rays, look, picture, edges, block, hide, stages };
  std::array<double, stages> cpu{};
  std::array<double, 2> wall{};        // until the picture, until the block
  std::array<double, 2> peak_bytes{};  // the same
  double triangles = 0.0;
};

rusage usage() {
  rusage now{};
  getrusage(RUSAGE_SELF, &now);
  return now;
}

double cpu_seconds() {
  const rusage now = usage();
  const auto seconds = [](timeval t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(now.ru_utime) + seconds(now.ru_stime);
}

Result<Opened> measure(const std::string& source, const Settings& settings) {
  Opened opened;
  double before = cpu_seconds();
  const auto start = std::chrono::steady_clock::now();
  const auto end = [&](Opened::Stage stage) {
    const double now = cpu_seconds();
    opened.cpu[stage] = now - before;
    before = now;
  };
  auto scene = load_scene(source);
  if (!scene) return unexpected(scene.error());
  end(Opened::read);
  auto ready = prepare_on_ground(*scene, {}, nullptr, [](const World& world, bool dark) {
    return GroundChoice{likely_ground(world, dark, first_camera(world))};
  });
  if (!ready) return unexpected(ready.error());
  *scene = Scene{};  // as the program does
  end(Opened::rays);
  ready = as_rendered(*std::move(ready));
  if (!ready) return unexpected(ready.error());
  end(Opened::look);

  Snapshot snapshot = snapshot_of(*ready, settings.size.width, settings.size.height);
  snapshot.settings.threads = settings.threads;
  snapshot.settings.method = Method::sobol;
  snapshot.settings.sampling.spp = 1;
  (void)render_to_end(snapshot);
  end(Opened::picture);
  const auto reach = [&](std::size_t point) {
    opened.wall[point] = seconds_since(start);
    opened.peak_bytes[point] = 1024.0 * static_cast<double>(usage().ru_maxrss);
  };
  reach(0);
  if (const auto whole = with_boundaries(*ready); !whole) return unexpected(whole.error());
  end(Opened::edges);
  snapshot.settings.method = Method::asos;
  const View view(snapshot.camera, settings.size.width, settings.size.height,
                  radius_around_origin((*ready)->world().bounds));
  const PixelRect middle{settings.size.width / 16 * 8, settings.size.height / 16 * 8, 8, 8};
  (void)render_block(**ready, view, snapshot.settings, middle);
  end(Opened::block);
  reach(1);
  std::vector<std::uint8_t> hidden(objects_without_ground((*ready)->world()), 0);
  for (std::size_t i = 1; i < hidden.size(); i += 2) hidden[i] = 1;
  before = cpu_seconds();
  if (const auto left = without_objects(*ready, hidden, nullptr); !left)
    return unexpected(left.error());
  end(Opened::hide);
  opened.triangles = static_cast<double>((*ready)->world().triangles.size());
  return opened;
}

/// Measures a scene in a process of its own, so that nothing is warm and the peak memory is its
/// own.
std::optional<Opened> measure_apart(const std::string& source, const Settings& settings) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return std::nullopt;
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    give_back_large_blocks();  // as the program does
    const Result<Opened> opened = measure(source, settings);
    if (!opened) (void)fail(opened.error());
    const bool told = opened && write(ends[1], &*opened, sizeof(Opened)) == sizeof(Opened);
    _exit(told ? 0 : 1);
  }
  close(ends[1]);
  Opened opened;
  const bool known = child > 0 && ::read(ends[0], &opened, sizeof opened) == sizeof opened;
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return known ? std::optional(opened) : std::nullopt;
}

std::string slow_stages(const std::string& name, const Opened& opened) {
  constexpr std::array names{"read", "rays", "look", "picture", "edges", "block", "hide"};
  static_assert(names.size() == Opened::stages);
  constexpr double least_seconds = 0.05;
  std::string slow;
  for (std::size_t stage = Opened::rays; stage < Opened::stages; ++stage)
    if (opened.cpu[stage] > std::max(least_seconds, 5.0 * opened.cpu[Opened::read]))
      slow += fmt::format("{} {} {:.1f}, ", name, names[stage],
                          opened.cpu[stage] / opened.cpu[Opened::read]);
  return slow;
}

}  // namespace

int run(int argc, char** argv) {
  Settings settings;
  Options options("How long scenes take to open, stage by stage, and how much memory.");
  options.texts("SCENE", settings.scenes, "all built-in and shared scenes if there is none");
  options.size(settings.size);
  options.number("--threads", settings.threads, 1, 1024);
  if (const auto code = options.end(argc, argv)) return *code;
  fmt::print(
      "{:<30} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>8} {:>6} {:>10} {:>6}\n",
      "processor seconds", "read", "rays", "look", "picture", "wall", "edges", "block", "wall",
      "hide", "peak MB", "B/tri", "with edges", "B/tri");
  std::string slow;
  bool all = true;
  for (const NamedScene& scene : chosen_scenes(settings.scenes)) {
    const std::optional<Opened> opened = measure_apart(scene.source, settings);
    all = all && opened.has_value();
    if (!opened) continue;
    const auto& cpu = opened->cpu;
    const auto& [first, all_stages] = opened->peak_bytes;
    const double triangles = std::max(1.0, opened->triangles);
    fmt::print(
        "{:<30} {:7.3f} {:7.3f} {:7.3f} {:7.3f} {:7.3f} {:7.3f} {:7.3f} {:7.3f} {:7.3f} {:8.0f} "
        "{:6.0f} {:10.0f} {:6.0f}\n",
        scene.name, cpu[Opened::read], cpu[Opened::rays], cpu[Opened::look], cpu[Opened::picture],
        opened->wall[0], cpu[Opened::edges], cpu[Opened::block], opened->wall[1], cpu[Opened::hide],
        1e-6 * first, first / triangles, 1e-6 * all_stages, all_stages / triangles);
    slow += slow_stages(scene.name, *opened);
  }
  if (!slow.empty()) slow.resize(slow.size() - 2);
  fmt::print("stages over reading, above 5: {}\n", slow.empty() ? "none" : slow);
  return all ? 0 : 1;
}

}  // namespace asos::bench::opening
