// How steady thin things are while they move: a pole 1/8 pixel wide, and a gap of that width
// between two walls, move by 2 pixels in 64 steps. What the pole adds to the picture's sum of
// intensities (or the gap takes from the walls') should not change; the table shows
// (max - min) / mean of it, in percent. Unlit surfaces, an orthographic camera: nothing but
// visibility changes. A pole that ends within the picture moves along with its ends.
//
//   bench_animation [--size N] [--steps N] [--csv]

#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace asos;
using namespace asos::bench;

struct Settings {
  int size = 32;  ///< pixels; a pixel is one unit wide
  int steps = 64;
  bool csv = false;
};

constexpr double width = 1.0 / 8.0;  // pixels
constexpr double travel = 2.0;       // pixels

/// What moves: sheared by `slope` pixels across a pixel of height, from -half to +half in height.
struct Subject {
  const char* name;
  double slope = 0.0;
  double half = 0.0;  ///< 0: from beyond the picture's lower border to beyond its upper one
  bool gap = false;
};
constexpr std::array<Subject, 6> subjects{{{"pole, upright", 0.0},
                                           {"pole, tilted 1 in 7.3", 0.137},
                                           {"pole, tilted 1 in 1.7", 0.593},
                                           {"pole with ends, tilted", 0.137, 5.3},
                                           {"gap, upright", 0.0, 0.0, true},
                                           {"gap, tilted 1 in 7.3", 0.137, 0.0, true}}};

struct Contender {
  std::string name;
  RenderSettings settings;
};

// A parallelogram facing +Z between the slanted lines that cross y = 0 at `left` and `right`.
Mesh slanted(double left, double right, double slope, double half, double z) {
  Mesh mesh;
  for (const double y : {-half, half}) {
    for (const double x : {left, right}) {
      mesh.positions.emplace_back(x + slope * y, y, z);
      mesh.normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
  }
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}};
  return mesh;
}

void add(Scene& scene, Mesh mesh, float grey) {
  Material material;
  material.base_color = glm::vec4(glm::vec3(grey), 1.0f);
  material.unlit = true;
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  Instance instance;
  instance.mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
}

Scene make_scene(const Subject& subject, double x, int size) {
  Scene scene;
  scene.source = "animation";
  const double far = 4.0 * size;
  const double half = subject.half > 0.0 ? subject.half : far;
  add(scene, slanted(-far, far, 0.0, far, -10.0), 0.2f);
  if (subject.gap) {
    add(scene, slanted(-2.0 * far, x - width / 2.0, subject.slope, half, 0.0), 0.9f);
    add(scene, slanted(x + width / 2.0, 2.0 * far, subject.slope, half, 0.0), 0.9f);
  } else {
    add(scene, slanted(x - width / 2.0, x + width / 2.0, subject.slope, half, 0.0), 0.9f);
  }
  Camera camera;
  camera.type = Camera::Type::orthographic;
  camera.height = size;
  camera.world_from_camera[3] = glm::dvec4(0, 0, 20, 1);
  scene.cameras.push_back(camera);
  return scene;
}

double sum_of(const Film& film) {
  double sum = 0.0;
  for (const glm::vec3& c : film.radiance) sum += static_cast<double>(c.g);
  return sum;
}

std::vector<Contender> contenders(int size) {
  RenderSettings base;
  base.width = base.height = size;
  base.threads = 1;
  base.max_level = 4;
  std::vector<Contender> list;
  const auto add_one = [&](const std::string& name, auto change) {
    change(list.emplace_back(Contender{name, base}).settings);
  };
  add_one("asos MAX 4", [](RenderSettings&) {});
  add_one("asos MAX 4, EPS 0", [](RenderSettings& s) { s.eps = 0.0; });
  add_one("published MAX 4", [](RenderSettings& s) { s.method = Method::asos_published; });
  for (const int spp : {16, 64, 256})
    add_one(fmt::format("stochastic {}", spp), [spp](RenderSettings& s) {
      s.method = Method::stochastic;
      s.spp = spp;
    });
  return list;
}

/// Of what the subject adds to the picture (or takes from it), over all steps.
struct Steadiness {
  double range = 0.0;  ///< (max - min) / mean
  double mean = 0.0;   ///< over the exact value
};

Steadiness steadiness(const Subject& subject, const std::vector<double>& sums, int size) {
  const double contrast = subject.gap ? -0.7 : 0.7;
  const double plain = (subject.gap ? 0.9 : 0.2) * size * size;
  const double height = subject.half > 0.0 ? 2.0 * subject.half : size;
  std::vector<double> shares;
  for (const double sum : sums) shares.push_back((sum - plain) / (contrast * width * height));
  const auto [lo, hi] = std::minmax_element(shares.begin(), shares.end());
  double mean = 0.0;
  for (const double share : shares) mean += share / static_cast<double>(shares.size());
  return {(*hi - *lo) / mean, mean};
}

Result<void> measure(const Subject& subject, const Settings& settings) {
  std::vector<Contender> list = contenders(settings.size);
  std::vector<std::vector<double>> sums(list.size());
  for (int step = 0; step < settings.steps; ++step) {
    const auto scene =
        prepare(make_scene(subject, travel * step / settings.steps - travel / 2, settings.size));
    if (!scene) return unexpected(scene.error());
    Snapshot snapshot = snapshot_of(*scene, settings.size, settings.size);
    for (std::size_t i = 0; i < list.size(); ++i) {
      snapshot.settings = list[i].settings;
      sums[i].push_back(sum_of(render_to_end(snapshot).film));
    }
  }
  if (!settings.csv) fmt::print("{}\n", subject.name);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Steadiness s = steadiness(subject, sums[i], settings.size);
    if (settings.csv)
      fmt::print("\"{}\",\"{}\",{:.6f},{:.6f}\n", subject.name, list[i].name, 100.0 * s.range,
                 s.mean);
    else
      fmt::print("  {:<20}{:>12.4f}{:>14.5f}\n", list[i].name, 100.0 * s.range, s.mean);
  }
  std::fflush(stdout);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app("Steadiness of thin things that move");
  app.add_option("--size", settings.size, "pixels, width and height")->check(CLI::Range(16, 512));
  app.add_option("--steps", settings.steps)->check(CLI::Range(2, 4096));
  app.add_flag("--csv", settings.csv);
  CLI11_PARSE(app, argc, argv);
  if (settings.csv)
    fmt::print("subject,method,range_percent,mean_over_exact\n");
  else
    fmt::print("  {:<20}{:>12}{:>14}\n", "", "range, %", "mean / exact");
  for (const Subject& subject : subjects)
    if (const auto done = measure(subject, settings); !done) return fail(done.error());
  return 0;
}
