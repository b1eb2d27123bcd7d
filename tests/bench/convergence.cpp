// Convergence by level against the exact picture (--method beam), without shadows and at EPS 0:
// exact leaves, point leaves, the published method, and 4^K stochastic samples. Work is pyrays plus
// rays. Two runs per scene: lit, with each part shaded at one point by both methods; and unlit,
// with a constant colour for every surface, so that only visibility matters.
//
//   bench convergence [--size WxH] [--look-at ...] [--fov DEG] [--max K] [--worst N] [--csv]
//                     [SCENE...]
//
// For exact leaves also: the number of pixels with 90 % of the squared error, and the distribution
// of that error over resolved, unresolved and other pixels. --worst lists pixels.

#include "renderer/comparison/method.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::convergence {

struct Settings {
  PictureSize size{160, 90};
  CameraChoice camera;
  int max_level = 6;
  int worst = 0;
  bool csv = false;
  std::vector<std::string> scenes{"builtin:boxes", "builtin:office"};
};

struct Contender {
  const char* name;
  Method method;
  LeafKind leaf;
};
constexpr std::array<Contender, 4> contenders{
    {{"exact leaves", Method::asos, LeafKind::exact},
     {"point leaves", Method::asos, LeafKind::point},
     {"published", Method::asos_published, LeafKind::point},
     {"stochastic", Method::stochastic, LeafKind::exact}}};

// Marks the vertices of flat triangles, on which a colour computed from the normal is constant.
std::vector<bool> flat_vertices(const Mesh& mesh) {
  std::vector<bool> flat(mesh.positions.size(), true);
  for (bool changed = true; changed;) {
    changed = false;
    for (const glm::uvec3& t : mesh.triangles) {
      const auto& n = mesh.normals;
      const bool one = n[t.x] == n[t.y] && n[t.x] == n[t.z] && flat[t.x] && flat[t.y] && flat[t.z];
      for (int i = 0; i < 3 && !one; ++i) {
        changed |= flat[t[i]];
        flat[t[i]] = false;
      }
    }
  }
  return flat;
}

/// The same surfaces with constant colours that differ slightly between the normals of flat faces,
/// so that all edges are visible.
Scene unlit(Scene scene) {
  for (Material& material : scene.materials) {
    material.unlit = true;
    material.base_color_texture = {};
    material.normal_texture = {};
    material.alpha_mode = AlphaMode::opaque;
    material.transmission = 0.0f;
  }
  for (Mesh& mesh : scene.meshes) {
    const std::vector<bool> flat = flat_vertices(mesh);
    mesh.colors.assign(mesh.positions.size(), glm::vec4(0.8f, 0.8f, 0.8f, 1.0f));
    for (std::size_t i = 0; i < flat.size(); ++i) {
      if (!flat[i]) continue;
      const float grey = 0.7f + 0.3f * glm::dot(mesh.normals[i], glm::vec3(0.5f, 0.7f, 0.4f));
      mesh.colors[i] = glm::vec4(glm::vec3(grey), 1.0f);
    }
  }
  return scene;
}

struct Row {
  PictureError error;
  double work = 0.0;
  double cpu_seconds = 0.0;
};

double factor(double from, double to) {
  return to > 0.0 ? from / to : 0.0;
}

class Study {
 public:
  Study(const Settings& settings, std::string title, SharedScene scene, const Camera& camera)
      : settings_(settings),
        title_(std::move(title)),
        snapshot_(snapshot_of(std::move(scene), settings.size.width, settings.size.height)) {
    snapshot_.camera = camera;
    snapshot_.settings.shadow.cast = false;
    snapshot_.settings.asos.eps = 0.0;
    snapshot_.settings.method = Method::beam;
    exact_ = render_to_end(snapshot_).film;
  }

  void run() {
    if (!settings_.csv)
      fmt::print("\n{}, {}x{}, no shadows, EPS 0\n", title_, settings_.size.width,
                 settings_.size.height);
    for (const Contender& contender : contenders) run(contender);
  }

 private:
  void run(const Contender& contender) {
    if (!settings_.csv)
      fmt::print("{:<13}{:>9}{:>7}{:>10}{:>10}{:>7}{:>8}\n", contender.name, "RMSE", "factor",
                 "raw RMSE", "work/pix", "factor", "cpu s");
    Row last;
    for (int level = 0; level <= settings_.max_level; ++level) {
      snapshot_.settings.method = contender.method;
      snapshot_.settings.asos.leaf = contender.leaf;
      snapshot_.settings.asos.max_level = level;
      snapshot_.settings.sampling.spp = 1 << (2 * level);
      const auto [row, film] = measure();
      print(contender, level, row, last);
      last = row;
      if (contender.method == Method::asos && contender.leaf == LeafKind::exact && !settings_.csv)
        explain(film);
    }
  }

  std::pair<Row, Film> measure() {
    Times times;
    const int runs = snapshot_.settings.sampling.spp > 256 ? 1 : 3;
    RenderResult result;
    for (int run = 0; run < runs; ++run) result = times.render(snapshot_);
    Row row;
    row.error = picture_error(result.film, exact_);
    row.work = static_cast<double>(pyrays_of(result.statistics) + rays_of(result.statistics)) /
               static_cast<double>(exact_.radiance.size());
    row.cpu_seconds = times.medians().cpu;
    return {row, std::move(result.film)};
  }

  void print(const Contender& contender, int level, const Row& row, const Row& last) {
    if (settings_.csv)
      fmt::print("\"{}\",{},{},{:.3e},{:.3e},{:.3f},{:.4f}\n", title_, contender.name, level,
                 row.error.shown, row.error.raw, row.work, row.cpu_seconds);
    else
      fmt::print("  MAX {:<7}{:>9.2e}{:>7.2f}{:>10.2e}{:>10.2f}{:>7.2f}{:>8.3f}", level,
                 row.error.shown, factor(last.error.shown, row.error.shown), row.error.raw,
                 row.work, factor(row.work, last.work), row.cpu_seconds);
    if (!settings_.csv && !(contender.method == Method::asos && contender.leaf == LeafKind::exact))
      fmt::print("\n");
    std::fflush(stdout);
  }

  // Distribution over outcomes of the pixels with 99 % of the squared error.
  void explain(const Film& film) {
    const std::vector<std::size_t> order = worst_pixels(film, exact_);
    const auto error = [&](std::size_t i) {
      return squared_error(film.radiance[i], exact_.radiance[i], true);
    };
    double total = 0.0;
    for (const std::size_t i : order) total += error(i);
    std::array<double, outcome_count> share{};
    double sum = 0.0;
    std::size_t most = 0;
    for (const std::size_t i : order) {
      if (total <= 0.0 || sum > 0.99 * total) break;
      most += sum < 0.9 * total;
      sum += error(i);
      share[static_cast<std::size_t>(outcome_of(trace_of(snapshot_, i)))] += error(i) / total;
    }
    fmt::print("  {:>5} pixels carry 90 %;", most);
    for (int k = 0; k < outcome_count; ++k) {
      const double s = share[static_cast<std::size_t>(k)];
      if (s > 0.005) fmt::print(" {} {:.0f} %", name_of(static_cast<Outcome>(k)), 100.0 * s);
    }
    fmt::print("\n");
    for (std::size_t k = 0; k < std::min<std::size_t>(settings_.worst, order.size()); ++k)
      print_pixel(film, order[k], error(order[k]) / total);
    std::fflush(stdout);
  }

  void print_pixel(const Film& film, std::size_t i, double share) {
    const PixelTrace trace = trace_of(snapshot_, i);
    const glm::vec3 a = film.radiance[i];
    const glm::vec3 b = exact_.radiance[i];
    fmt::print(
        "      --pixel {},{}  {:.1f} % of the squared error, {}, level {}, {} samples, unresolved "
        "{:.5f}; {:.5f} {:.5f} {:.5f} instead of {:.5f} {:.5f} {:.5f}\n",
        trace.x, trace.y, 100.0 * share, name_of(outcome_of(trace)), film.split_level[i],
        samples_of(trace), trace.unresolved_area, a.x, a.y, a.z, b.x, b.y, b.z);
  }

  const Settings& settings_;
  std::string title_;
  Snapshot snapshot_;
  Film exact_;
};

Result<void> study(const std::string& source, const Settings& settings) {
  const auto scene = load_scene(source);
  if (!scene) return unexpected(scene.error());
  for (const bool lit : {true, false}) {
    const auto prepared =
        prepare(lit ? *scene : unlit(*scene)).and_then(as_rendered).and_then(with_boundaries);
    if (!prepared) return unexpected(prepared.error());
    RenderSettings beam;
    beam.method = Method::beam;
    if (const auto can = check_method(**prepared, beam); !can) return can;
    const auto camera =
        choose_camera((*prepared)->world(), settings.camera,
                      static_cast<double>(settings.size.width) / settings.size.height);
    if (!camera) return unexpected(camera.error());
    Study(settings, source + (lit ? " lit" : " unlit"), *prepared, *camera).run();
  }
  return {};
}

int run(int argc, char** argv) {
  Settings settings;
  Options options("Error and work by level, against the exact picture");
  options.size(settings.size);
  options.camera(settings.camera);
  options.number("--max", settings.max_level, 0, 8, "deepest level");
  options.number("--worst", settings.worst, 0, 1000,
                 "pixels to list after each level of exact leaves");
  options.flag("--csv", settings.csv);
  options.texts("SCENE", settings.scenes, "files or built-in scenes");
  if (const auto code = options.end(argc, argv)) return *code;
  if (settings.csv) fmt::print("scene,method,max,rmse,raw_rmse,work_per_pixel,cpu_seconds\n");
  for (const std::string& scene : settings.scenes)
    if (const auto done = study(scene, settings); !done) return fail(done.error());
  return 0;
}

}  // namespace asos::bench::convergence
