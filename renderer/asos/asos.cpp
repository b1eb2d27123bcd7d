#include "renderer/asos/asos.h"

#include "renderer/asos/defocus.h"
#include "renderer/asos/eye_caster.h"
#include "renderer/asos/plane_cuts.h"
#include "renderer/asos/started_pyray.h"
#include "renderer/published/published_modes.h"
#include "renderer/pyray/tracer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace asos {
namespace {

// Returns the width, in pixels, of the frame that a block needs around it. It covers the filters of
// the outermost pixels, the search for boundaries that a lens blurs (`blur`), and the pixels'
// cones. Cones reach farther the farther they are from the picture's centre.
int border_of(const View& view, PixelRect block, const RenderSettings& settings,
              const SubdivisionVariant* variant, double blur) {
  const int fat = settings.asos.fat;
  FatPyray pyray{view.frame(block.x, block.y, fat, fat), fat};
  pyray.width = settings.filter_width;
  pyray.reach = blur;
  double beyond = 0.5 * (settings.filter_width - 1.0) + blur;  // in pixels
  if (const auto detection = variant ? variant->detection(pyray.frame) : nullptr) {
    const double side = 1.0 / fat;
    for (const int x : {0, fat - 1}) {
      for (const int y : {0, fat - 1}) {
        const auto reach =
            static_cast<double>(detection->reach(pyray.searched_square(x, y, 1)).side);
        beyond = std::max(beyond, 0.5 * (reach / side - 1.0));
      }
    }
  }
  return static_cast<int>(std::ceil(beyond));
}

FatPyray fat_pyray(const View& view, PixelRect block, PixelRect framed,
                   const RenderSettings& settings, double reach) {
  FatPyray fat{view.frame(framed.x, framed.y, framed.width, framed.height), settings.asos.fat};
  fat.columns = block.width;
  fat.rows = block.height;
  fat.border = block.x - framed.x;
  fat.width = settings.filter_width;
  fat.reach = reach;
  fat.origin = {block.x, block.y};
  return fat;
}

/// Scratch memory that fat pyrays reuse. Holds no result.
struct BlockWorkspace {
  Tracer tracer;
  EyeWorkspace eye;
};

/// Shades through the camera of a job.
struct CameraEye {
  CameraEye(const BlockJob& job, const ErrorBudget& error_budget)
      : shader(shader_of(job.scene, job.settings, job.view, error_budget.negligible_bend())),
        viewer(ViewContext::camera(job.view, shader, job.settings.filter_width)) {}
  CameraEye(const CameraEye&) = delete;
  CameraEye& operator=(const CameraEye&) = delete;

  Shader shader;
  ViewContext viewer;
};

}  // namespace

StartedPyray start_fat_pyray(const BlockJob& job, PixelWatch* watch) {
  thread_local BlockWorkspace work;
  const RenderSettings& settings = job.settings;
  StartedPyray started;
  started.block = job.block;

  // Look along the block as the camera does.
  const ErrorBudget error_budget = ErrorBudget::of(settings);
  const CameraEye camera(job, error_budget);
  std::optional<Defocus> defocus;
  if (job.view.has_lens()) {
    defocus.emplace(job, camera.viewer, settings.asos.fat);
    started.statistics.eye_rays +=
        static_cast<std::uint64_t>(job.block.width) * static_cast<std::uint64_t>(job.block.height);
  }
  const double reach = defocus ? defocus->reach() : 0.0;

  // Frame the block, including the reach of filters, lens and cones.
  const PublishedModes published(settings);
  const int border = border_of(job.view, job.block, settings, published.variant().pixels, reach);
  const int side = settings.asos.fat + 2 * border;
  started.framed = {job.block.x - border, job.block.y - border, side, side};
  FatPyray fat = fat_pyray(job.view, job.block, started.framed, settings, reach);
  const PlaneCuts cuts(*job.scene.geometry, job.view, fat.frame);
  fat.outline = cuts.lines;
  fat.bounds.within = cuts.between;

  EyeContext eye{&job.scene, &settings, camera.viewer, &fat.frame, started.framed};
  eye.error_budget = error_budget;
  eye.variant = published.variant();
  eye.seed = settings.seed;
  eye.defocus = defocus ? &*defocus : nullptr;
  eye.work = &work.eye;
  eye.stop = job.stop;
  eye.counts = &started.statistics;
  if (watch) {
    const glm::ivec2 at = watch->pixel - fat.origin;
    eye.observed.observer = &watch->observer;
    eye.observed_root = fat.index(at.x, at.y);
    eye.observed_square = fat.square_of(at.x, at.y, 1);
  }

  // Trace: find boundaries, split, shade the leaves.
  EyeCaster caster(eye, static_cast<std::size_t>(fat.side * fat.side));
  const std::span<const Trace> traces = work.tracer.trace(
      job.scene.features(), fat, SubdivisionRules::of(settings, published.variant().pixels), caster,
      eye.observed_root, watch ? &watch->observer.pixel : nullptr);

  // Rays through pixel centres beyond the picture's border do not count.
  started.statistics.eye_rays -=
      static_cast<std::uint64_t>(fat.side * fat.side - fat.columns * fat.rows);
  started.open = caster.take_open();
  started.asked = settings.layers;
  started.tolerance = error_budget.refines() ? static_cast<double>(error_budget.tolerance)
                                             : std::max(error_budget.eps, ErrorBudget::invisible);
  std::vector<LayerSum> layers = caster.take_layers();
  started.pixel_of_root.assign(traces.size(), 0);
  for (int y = 0; y < fat.rows; ++y) {
    for (int x = 0; x < fat.columns; ++x) {
      const std::uint32_t root = fat.index(x, y);
      started.pixel_of_root[root] = static_cast<std::uint32_t>(started.pixels.size());
      started.pixels.push_back({traces[root], caster.sum(root)});
      if (!layers.empty()) started.layers.push_back(std::move(layers[root]));
    }
  }
  return started;
}

void finish_fat_pyray(const BlockJob& job, StartedPyray& started, PixelWatch* watch) {
  OpenRegions open = std::exchange(started.open, {});
  if (open.parts.empty()) return;
  // Continue to sample the open regions.
  const RenderSettings& settings = job.settings;
  const CameraEye camera(job, ErrorBudget::of(settings));
  RegionSampler sampler(job.scene, camera.viewer, settings, started.framed, settings.seed, nullptr,
                        job.stop);
  sampler.note_layers();
  const std::uint64_t before = started.statistics.rays();
  const auto found = sampler.resume(std::move(open.samples), started.statistics);
  const auto rays = static_cast<double>(started.statistics.rays() - before);
  // Add the samples to their pixels.
  double samples = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
    samples += found[i].cost - open.parts[i].so_far.cost;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const OpenRegions::Part& part = open.parts[i];
    RootSum& sum = started.pixels[started.pixel_of_root[part.leaf.root]].sum;
    sum.add_samples(found[i], part.leaf);
    if (settings.layers.of_surfaces())
      started.layers[started.pixel_of_root[part.leaf.root]].add(sampler.layers(i),
                                                                part.leaf.weight);
    const double more = found[i].cost - part.so_far.cost;
    if (samples > 0.0) sum.rays += static_cast<std::uint64_t>(std::llround(rays * more / samples));
    if (watch) watch->observer.pixel.note(part.leaf.sample, glm::vec3(found[i].value));
  }
}

BlockResult render_fat_pyray(const BlockJob& job, PixelWatch* watch) {
  StartedPyray started = start_fat_pyray(job, watch);
  finish_fat_pyray(job, started, watch);
  if (watch) {
    const glm::ivec2 at = watch->pixel - glm::ivec2(job.block.x, job.block.y);
    const StartedPyray::Pixel& pixel =
        started.pixels[static_cast<std::size_t>(at.y * job.block.width + at.x)];
    watch->missed = pixel.trace.missed;
    watch->unresolved_area = pixel.trace.outcome.unresolved_area;
    watch->observer.pixel.result = pixel.sum.mean();
  }
  return started.result(job.settings.asos.max_level);
}

}  // namespace asos
