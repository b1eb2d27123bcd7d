// Cost of advancing an animation: a morphing sheet of triangles, optionally with a static one.
// Prints milliseconds of CPU time of all threads and of wall-clock time, medians over the frames,
// for placing everything in the world, for the rays' hierarchy, and for the edges, which ASOS
// needs.
//
//   bench moving [--triangles N] [--still N] [--frames N]

#include "renderer/features/feature_set.h"
#include "renderer/features/welded_vertices.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/rays/ray_scene.h"
#include "renderer/study/curves.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <utility>
#include <vector>

namespace asos::bench::moving {

/// A square sheet of about `triangles` triangles, bent by a wave with this phase.
Mesh sheet(int triangles, double phase) {
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(0.5 * triangles))));
  Mesh mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      const double u = static_cast<double>(x) / side, v = static_cast<double>(y) / side;
      const double at = 9.0 * u + 5.0 * v + phase;
      mesh.positions.emplace_back(u, 0.05 * std::sin(at), v);
      mesh.normals.push_back(
          glm::normalize(glm::vec3(-0.45 * std::cos(at), 1.0, -0.25 * std::cos(at))));
    }
  }
  const auto index = [&](int x, int y) { return static_cast<std::uint32_t>(y * (side + 1) + x); };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      mesh.triangles.emplace_back(index(x, y), index(x, y + 1), index(x + 1, y));
      mesh.triangles.emplace_back(index(x + 1, y), index(x, y + 1), index(x + 1, y + 1));
    }
  }
  return mesh;
}

Scene moment(int triangles, int still, double phase) {
  Scene scene;
  scene.source = "sheet";
  for (const bool moves : {true, false}) {
    if (!moves && still == 0) continue;
    glm::dmat4 place(1.0);
    place[3].y = moves ? 0.0 : -1.0;
    scene.instances.push_back({"sheet", static_cast<int>(scene.meshes.size()), place});
    scene.meshes.push_back(moves ? sheet(triangles, phase) : sheet(still, 0.0));
  }
  return scene;
}

/// Times of a stage per frame, in milliseconds.
struct Cost {
  std::vector<double> processor, passed;
};

/// A stopwatch: appends the time since the previous call to a stage.
class Laps {
 public:
  void add_to(Cost& stage) {
    const double processor = processor_ms(), now = now_ms();
    stage.processor.push_back(processor - std::exchange(processor_, processor));
    stage.passed.push_back(now - std::exchange(now_, now));
  }

 private:
  static double processor_ms() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  }
  static double now_ms() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
  }

  double processor_ = processor_ms();
  double now_ = now_ms();
};

void print(const char* name, const Cost& stage) {
  fmt::print("{:<22} {:8.2f} {:8.2f}\n", name, median(stage.processor), median(stage.passed));
}

int run(int argc, char** argv) {
  int triangles = 10'000, still = 0, frames = 24;
  Options options("What a scene costs from one moment of its animation to the next");
  options.number("--triangles", triangles, 2, 10'000'000);
  options.number("--still", still, 0, 10'000'000);
  options.number("--frames", frames, 1, 10'000);
  if (const auto code = options.end(argc, argv)) return *code;

  const auto rest = prepare(moment(triangles, still, 0.0));
  if (!rest) return EXIT_FAILURE;
  Cost placing, rays, edges, crossings, boundaries, all;
  for (int f = 0; f < frames; ++f) {
    Scene scene = moment(triangles, still, 0.1 * f);
    scene.time = ClipTime{0, 0.1 * f};
    Laps laps;
    const auto flat = flatten(scene, most_triangles, (*rest)->geometry->stage.origin);
    if (!flat) return EXIT_FAILURE;
    laps.add_to(placing);
    const auto traced = RayScene::build(flat->world, nullptr, {}, {}, nullptr, BvhPurpose::moment);
    if (!traced) return EXIT_FAILURE;
    laps.add_to(rays);
    const std::vector<std::uint32_t> welded = welded_vertices(flat->world.positions.own());
    const ExtractedFeatures found = extract_features(flat->world, welded);
    laps.add_to(edges);
    const Intersections lines =
        find_intersections(flat->world, welded, IntersectionBudget::of(flat->world));
    laps.add_to(crossings);
    const FeatureSet features(flat->world);
    laps.add_to(boundaries);
    const auto ready = prepare(scene, {}, &(*rest)->geometry->stage).and_then(with_boundaries);
    if (!ready) return EXIT_FAILURE;
    laps.add_to(all);
  }
  fmt::print("{} triangles morph, {} stand still; milliseconds a frame, medians\n", triangles,
             still);
  fmt::print("{:<22} {:>8} {:>8}\n", "", "of CPUs", "passed");
  print("placing in the world", placing);
  print("rays' hierarchy", rays);
  print("boundaries", boundaries);
  print("  of which edges", edges);
  print("  and intersections", crossings);
  print("all of it", all);
  return EXIT_SUCCESS;
}

}  // namespace asos::bench::moving
