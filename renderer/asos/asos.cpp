#include "renderer/asos/asos.h"

#include "renderer/asos/eye_caster.h"
#include "renderer/asos/split_causes.h"
#include "renderer/prepared/plane_section.h"
#include "renderer/pyray/detection.h"
#include "renderer/pyray/tracer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

namespace asos {
namespace {

// How many pixels of frame a block needs around it: what the filters of its outermost pixels, and
// their cones, reach beyond it; cones more the farther from the picture's middle they are.
int border_of(const View& view, PixelRect block, const RenderSettings& settings) {
  const int fat = settings.asos.fat;
  FatPyray pyray{view.frame(block.x, block.y, fat, fat), fat};
  pyray.width = settings.filter_width;
  double beyond = 0.5 * (settings.filter_width - 1.0);  // in pixels
  if (settings.asos.detect == Detection::cone) {
    const Detector detector(pyray.frame, settings.asos.detect);
    const double side = 1.0 / fat;
    for (const int x : {0, fat - 1}) {
      for (const int y : {0, fat - 1}) {
        const auto reach = static_cast<double>(detector.reach(pyray.square_of(x, y, 1)).side);
        beyond = std::max(beyond, 0.5 * (reach / side - 1.0));
      }
    }
  }
  return static_cast<int>(std::ceil(beyond));
}

FatPyray fat_pyray(const View& view, PixelRect block, PixelRect framed,
                   const RenderSettings& settings) {
  FatPyray fat{view.frame(framed.x, framed.y, framed.width, framed.height), settings.asos.fat};
  fat.columns = block.width;
  fat.rows = block.height;
  fat.border = block.x - framed.x;
  fat.width = settings.filter_width;
  fat.origin = {block.x, block.y};
  return fat;
}

// Where the image plane, in which rays start, cuts surfaces.
std::vector<BorderEdge> cut_by_image_plane(const BlockJob& job, const Frame& frame) {
  std::vector<BorderEdge> outline;
  const std::optional<HalfSpace> ahead = job.view.ahead();
  if (!ahead) return outline;
  const Geometry& geometry = *job.scene.geometry;
  for (const SectionLine& line : *geometry.sections.of(geometry.world, *ahead)) {
    const FramePoint p = frame.project(frame.homogeneous(line.from));
    const FramePoint q = frame.project(frame.homogeneous(line.to));
    const glm::dvec2 from(p.u, p.v), to(q.u, q.v);
    if (glm::any(glm::lessThan(glm::max(from, to), glm::dvec2(0.0))) ||
        glm::any(glm::greaterThan(glm::min(from, to), glm::dvec2(1.0))))
      continue;
    outline.push_back({glm::vec2(from), glm::vec2(to)});
  }
  return outline;
}

// Each cell that was examined has a sample of its own. The block's other rays, as those cast to
// find out whether a patch is evenly lit, are shared by its pixels.
void publish_rays(std::span<const std::uint64_t> rays, BlockResult& result) {
  std::uint64_t told = 0;
  for (const std::uint64_t of_pixel : rays) {
    told += of_pixel;
    result.tile.rays.push_back(static_cast<float>(of_pixel));
  }
  const std::uint64_t all = result.statistics.rays();
  if (all <= told) return;
  const float shared = static_cast<float>(all - told) / static_cast<float>(rays.size());
  for (float& of_pixel : result.tile.rays) of_pixel += shared;
}

// The level whose cells would be as many.
int level_of(std::uint32_t samples) {
  return samples > 1 ? (std::bit_width(samples - 1) + 1) / 2 : 0;
}

void publish(const FatPyray& fat, int max_level, std::span<const Trace> traces,
             const EyeCaster& caster, BlockResult& result) {
  RenderStatistics& statistics = result.statistics;
  // Middles beyond the picture's border were traced with the others and do not count.
  statistics.eye_rays -= static_cast<std::uint64_t>(fat.side * fat.side - fat.columns * fat.rows);
  std::vector<std::uint64_t> rays;
  for (int y = 0; y < fat.rows; ++y) {
    for (int x = 0; x < fat.columns; ++x) {
      const std::uint32_t i = fat.index(x, y);
      // Count the pixel's cells and events.
      SubdivisionOutcome outcome = traces[i].outcome;
      const auto& cells = outcome.pyrays_by_level;
      for (std::size_t k = 0; k < cells.size(); ++k) statistics.pyrays_by_level[k] += cells[k];
      // What samples tell apart is as good as split to the end.
      const RootSum& sum = caster.sum(i);
      if (sum.cut_out) outcome.deepest = std::max(outcome.deepest, max_level);
      if (sum.varies && !outcome.uneven_shadow) outcome.uneven_shading = true;
      if (outcome.uneven_shading || outcome.uneven_shadow)
        outcome.deepest = std::max(outcome.deepest, std::min(max_level, level_of(sum.samples)));
      statistics.split_pixels += outcome.deepest > 0;
      statistics.missed_splits += traces[i].missed;
      statistics.uneven_pixels += outcome.uneven_shading || outcome.uneven_shadow;
      statistics.saturated_pixels += outcome.saturated;
      statistics.unresolved_area += outcome.unresolved_area;
      statistics.pyrays_by_level[static_cast<std::size_t>(max_level)] += sum.samples;
      // Publish its radiance, level, cause and rays.
      result.tile.radiance.push_back(caster.colour(i));
      result.tile.split_level.push_back(static_cast<std::uint8_t>(outcome.deepest));
      const SplitCause cause =
          cause_of({outcome, traces[i].by_samples || sum.cut_out, sum.shadow_cut, sum.mirror_cut});
      result.tile.cause.push_back(cause);
      if (cause != SplitCause::none) ++statistics.pixels_by_cause[static_cast<std::size_t>(cause)];
      rays.push_back(std::accumulate(cells.begin(), cells.end(), sum.rays));
    }
  }
  publish_rays(rays, result);
}

/// Memory of fat pyrays that is worth keeping from one to the next. Holds no result.
struct BlockWorkspace {
  Tracer tracer;
  EyeWorkspace eye;
};

}  // namespace

BlockResult render_block_asos(const BlockJob& job) {
  const int fat = job.settings.asos.fat;
  const PixelRect& block = job.block;
  if (block.width <= fat && block.height <= fat) return render_fat_pyray(job);
  BlockResult result;
  result.tile.rect = block;
  const auto pixels = static_cast<std::size_t>(block.width * block.height);
  result.tile.radiance.resize(pixels);
  result.tile.split_level.resize(pixels);
  result.tile.cause.resize(pixels);
  result.tile.rays.resize(pixels);
  for (int y = 0; y < block.height; y += fat) {
    for (int x = 0; x < block.width; x += fat) {
      BlockJob part = job;
      part.block = {block.x + x, block.y + y, std::min(fat, block.width - x),
                    std::min(fat, block.height - y)};
      const BlockResult done = render_fat_pyray(part);
      copy_pixels(done.tile, result.tile);
      result.statistics += done.statistics;
    }
  }
  return result;
}

BlockResult render_fat_pyray(const BlockJob& job, PixelWatch* watch) {
  thread_local BlockWorkspace work;
  const RenderSettings& settings = job.settings;
  BlockResult result;
  result.tile.rect = job.block;

  // Frame the block, with what filters and cones reach beyond it.
  const int border = border_of(job.view, job.block, settings);
  const int side = settings.asos.fat + 2 * border;
  const PixelRect framed{job.block.x - border, job.block.y - border, side, side};
  FatPyray fat = fat_pyray(job.view, job.block, framed, settings);
  const std::vector<BorderEdge> outline = cut_by_image_plane(job, fat.frame);
  fat.outline = outline;

  // Look along it as the camera does.
  const Allowance allowance = Allowance::of(settings);
  const Shader shader = shader_of(job.scene, settings, job.view, allowance.negligible_bend());
  EyeContext eye{&job.scene, &settings, Viewer::camera(job.view, shader, settings.filter_width),
                 &fat.frame, framed};
  eye.allowance = allowance;
  eye.seed = settings.seed;
  eye.work = &work.eye;
  eye.stop = job.stop;
  eye.counts = &result.statistics;
  if (watch) {
    const glm::ivec2 at = watch->pixel - fat.origin;
    eye.observed.observer = &watch->observer;
    eye.observed_root = fat.index(at.x, at.y);
    eye.observed_square = fat.square_of(at.x, at.y, 1);
  }

  // Trace: find boundaries, split, shade the leaves.
  EyeCaster caster(eye, static_cast<std::size_t>(fat.side * fat.side));
  const std::span<const Trace> traces =
      work.tracer.trace(job.scene.features(), fat, SubdivisionRules::of(settings), caster,
                        eye.observed_root, watch ? &watch->observer.pixel : nullptr);

  // Publish the pixels.
  publish(fat, settings.asos.max_level, traces, caster, result);
  if (watch) {
    const Trace& trace = traces[eye.observed_root];
    watch->missed = trace.missed;
    watch->unresolved_area = trace.outcome.unresolved_area;
    watch->observer.pixel.result = caster.colour(eye.observed_root);
  }
  return result;
}

}  // namespace asos
