// Cost of the engine's parts, as ratios of CPU times (medians of alternating runs):
//   wall       a wall that fills the view in front of `dense`, over the wall alone
//   saturated  triangles smaller than the finest cells, over as many stochastic samples
//   fat        fat pyrays of 2, 4 and 16 pixels over those of 8
//   detect     cones over squares, and the number of pyrays that they examine in addition
//   rule       the published rule over the unresolved one
//
//   bench costs [--size WxH] [--max K] [--runs N] [PART...]

#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"
#include "tests/support/flat_mesh.h"
#include "tests/support/make_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::costs {

struct Settings {
  PictureSize size{480, 270};
  int max_level = 3;
  int runs = 5;
  std::vector<std::string> parts{"wall", "saturated", "fat", "detect", "rule"};
};

const std::array<const char*, 4> scenes{"builtin:boxes", "builtin:mixed", "builtin:dense",
                                        "builtin:office"};

/// A candidate to time, with the statistics of its last run.
struct Contender {
  std::string name;
  Snapshot snapshot;
  Times times;
  RenderStatistics statistics;
};

void time_in_turns(std::vector<Contender>& list, int runs) {
  for (int run = 0; run < runs; ++run) {
    for (Contender& c : list) c.statistics = c.times.render(c.snapshot).statistics;
  }
}

double cpu_of(const Contender& c) {
  return c.times.medians().cpu;
}

Contender make_contender(std::string name, const SharedScene& scene, const Settings& settings,
                         const std::function<void(RenderSettings&)>& change = {}) {
  Contender c;
  c.name = std::move(name);
  c.snapshot = snapshot_of(scene, settings.size.width, settings.size.height);
  c.snapshot.settings.asos.max_level = settings.max_level;
  if (change) change(c.snapshot.settings);
  return c;
}

Material paint(glm::vec3 colour) {
  Material material;
  material.base_color = glm::vec4(colour, 1.0f);
  material.metallic = 0.0f;
  material.double_sided = true;
  return material;
}

Result<void> measure_wall(const Settings& settings) {
  auto scene = load_scene("builtin:dense");
  if (!scene) return unexpected(scene.error());
  Scene alone = *scene;
  alone.meshes.clear();
  alone.instances.clear();
  test::add_wall_before_camera(alone);
  test::add_wall_before_camera(*scene);
  const auto a = prepare(alone).and_then(with_boundaries);
  const auto b = prepare(*scene).and_then(with_boundaries);
  if (!a || !b) return unexpected(a ? b.error() : a.error());
  for (const bool shadows : {false, true}) {
    const auto set = [shadows](RenderSettings& s) { s.shadow.cast = shadows; };
    std::vector<Contender> list{make_contender("wall alone", *a, settings, set),
                                make_contender("wall before dense", *b, settings, set)};
    time_in_turns(list, settings.runs);
    fmt::print("wall, shadows {:<4}{:>10.4f} s alone{:>10.4f} s before dense{:>8.3f} times\n",
               shadows ? "on" : "off", cpu_of(list[0]), cpu_of(list[1]),
               cpu_of(list[1]) / cpu_of(list[0]));
  }
  return {};
}

/// `count` random triangles of size `size` in a box that fills the view of a camera at distance 4.
Scene soup(int count, float size) {
  Scene scene;
  scene.source = "soup";
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  const auto anywhere = [&] {
    const float x = unit(random);
    const float y = unit(random);
    return glm::vec3(x, y, unit(random));
  };
  constexpr int colours = 4;
  for (int k = 0; k < colours; ++k) {
    Mesh mesh;
    const Material material = paint(0.2f + 0.6f * glm::abs(anywhere()));
    for (int i = 0; i < count / colours; ++i) {
      const glm::vec3 centre = anywhere() * glm::vec3(2.4f, 1.4f, 0.5f);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (int corner = 0; corner < 3; ++corner)
        mesh.positions.push_back(centre + size * anywhere());
      const glm::vec3 n = glm::cross(mesh.positions[first + 1] - mesh.positions[first],
                                     mesh.positions[first + 2] - mesh.positions[first]);
      mesh.normals.insert(mesh.normals.end(), 3,
                          glm::dot(n, n) > 0.0f ? glm::normalize(n) : glm::vec3(0, 0, 1));
      mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    test::place(scene, std::move(mesh), material);
  }
  Camera camera;
  camera.world_from_camera[3] = glm::dvec4(0, 0, 4, 1);
  camera.fov_y_rad = 0.6;
  scene.cameras.push_back(camera);
  scene.lights.push_back(test::make_sun(glm::normalize(glm::dvec3(-0.3, -0.4, -1.0)), 3.0f));
  return scene;
}

Result<void> measure_saturated(const Settings& settings) {
  fmt::print("saturated, MAX {}\n  {:>9}{:>7}{:>9}{:>12}{:>10}{:>10}{:>12}{:>14}\n",
             settings.max_level, "triangles", "size", "shadows", "saturated", "eye/pix", "cpu s",
             "stochastic", "same samples");
  for (const auto& [count, size] :
       {std::pair(100'000, 0.01f), std::pair(400'000, 0.004f), std::pair(2'000'000, 0.0012f)}) {
    const auto scene = prepare(soup(count, size)).and_then(with_boundaries);
    if (!scene) return unexpected(scene.error());
    for (const bool shadows : {false, true}) {
      std::vector<Contender> list{
          make_contender("asos", *scene, settings,
                         [=](RenderSettings& s) { s.shadow.cast = shadows; }),
          make_contender("stochastic", *scene, settings, [&](RenderSettings& s) {
            s.shadow.cast = shadows;
            s.method = Method::stochastic;
            s.sampling.spp = 1 << (2 * settings.max_level);
          })};
      time_in_turns(list, settings.runs);
      const auto pixels = static_cast<double>(settings.size.width * settings.size.height);
      const auto rays = static_cast<double>(list[0].statistics.eye_rays);
      const double same = rays / static_cast<double>(list[1].statistics.eye_rays);
      fmt::print("  {:>9}{:>7.3f}{:>9}{:>10.1f} %{:>10.1f}{:>10.3f}{:>12.3f}{:>8.2f} times\n",
                 count, size, shadows ? "on" : "off",
                 100.0 * static_cast<double>(list[0].statistics.saturated_pixels) / pixels,
                 rays / pixels, cpu_of(list[0]), cpu_of(list[1]),
                 cpu_of(list[0]) / (same * cpu_of(list[1])));
    }
  }
  return {};
}

/// Times `variants` of the settings on each scene, and prints the times relative to the first
/// variant.
using Change = std::pair<std::string, std::function<void(RenderSettings&)>>;
Result<void> compare(const char* title, const std::vector<Change>& variants,
                     const Settings& settings) {
  fmt::print("{}, MAX {}; times over {}, and pyrays\n", title, settings.max_level,
             variants.front().first);
  for (const char* source : scenes) {
    const auto scene = open_scene(source);
    if (!scene) return unexpected(scene.error());
    std::vector<Contender> list;
    for (const auto& [name, change] : variants)
      list.push_back(make_contender(name, *scene, settings, change));
    time_in_turns(list, settings.runs);
    fmt::print("  {:<15}{:>8.3f} s", source, cpu_of(list.front()));
    for (const Contender& c : list) {
      if (&c == &list.front()) continue;
      fmt::print("; {} {:.2f}, {:.2f}", c.name, cpu_of(c) / cpu_of(list.front()),
                 static_cast<double>(pyrays_of(c.statistics)) /
                     static_cast<double>(pyrays_of(list.front().statistics)));
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  return {};
}

Result<void> measure_fat(const Settings& settings) {
  std::vector<Change> variants;
  for (const int fat : {8, 2, 4, 16})
    variants.emplace_back(fmt::format("fat {}", fat),
                          [fat](RenderSettings& s) { s.asos.fat = fat; });
  return compare("fat", variants, settings);
}

Result<void> measure_detect(const Settings& settings) {
  for (const LeafKind leaf : {LeafKind::exact, LeafKind::point}) {
    const auto with = [leaf](Detection detect) {
      return [=](RenderSettings& s) {
        s.asos.leaf = leaf;
        s.asos.detect = detect;
      };
    };
    const auto done =
        compare(leaf == LeafKind::exact ? "detect, exact leaves" : "detect, point leaves",
                {{"square", with(Detection::square)}, {"cone", with(Detection::cone)}}, settings);
    if (!done) return done;
  }
  return {};
}

Result<void> measure_rule(const Settings& settings) {
  for (const LeafKind leaf : {LeafKind::exact, LeafKind::point}) {
    const auto with = [leaf](StoppingRule rule) {
      return [=](RenderSettings& s) {
        s.asos.leaf = leaf;
        s.asos.rule = rule;
      };
    };
    const auto done = compare(leaf == LeafKind::exact ? "rule, exact leaves" : "rule, point leaves",
                              {{"unresolved", with(StoppingRule::unresolved)},
                               {"published", with(StoppingRule::published)}},
                              settings);
    if (!done) return done;
  }
  return {};
}

int run(int argc, char** argv) {
  const std::vector<std::pair<std::string, Result<void> (*)(const Settings&)>> parts{
      {"wall", measure_wall},
      {"saturated", measure_saturated},
      {"fat", measure_fat},
      {"detect", measure_detect},
      {"rule", measure_rule}};
  Settings settings;
  Options options("Costs of the engine's parts, as ratios of processor times");
  options.size(settings.size);
  options.number("--max", settings.max_level, 1, 8);
  options.number("--runs", settings.runs, 1, 99);
  options.choices("PART", settings.parts, {"wall", "saturated", "fat", "detect", "rule"});
  if (const auto code = options.end(argc, argv)) return *code;
  for (const auto& [name, measure] : parts) {
    if (std::find(settings.parts.begin(), settings.parts.end(), name) == settings.parts.end())
      continue;
    if (const auto done = measure(settings); !done) return fail(done.error());
  }
  return 0;
}

}  // namespace asos::bench::costs
